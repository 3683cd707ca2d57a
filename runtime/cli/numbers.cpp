// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/numbers.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <functional>

#include "generator/scene/place.hpp"
#include "runtime/base/text.hpp"

namespace kanec::cli {
namespace {

// What reads as a number, as nan does, without quotes.
std::string shown(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return end == text.c_str() + text.size() && !text.empty() ? text : scene::in_quotes(text);
}

CLI::Validator finite(const std::string& allowed, const std::function<bool(double)>& is_right) {
  const auto check = [allowed, is_right](const std::string& text) {
    const std::optional<double> value = finite_number(text);
    if (value && is_right(*value)) return std::string();
    return fmt::format("found {}; allowed: {}", shown(text), allowed);
  };
  return {check, "", ""};
}

}  // namespace

CLI::Validator positive() {
  return finite("a positive finite number", [](double value) { return value > 0.0; });
}

CLI::Validator not_negative() {
  return finite("a finite number, 0 or more", [](double value) { return value >= 0.0; });
}

CLI::Validator within(double least, double most) {
  return finite("from " + shortest(least) + " to " + shortest(most),
                [least, most](double value) { return value >= least && value <= most; });
}

}  // namespace kanec::cli
