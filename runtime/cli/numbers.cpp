// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/numbers.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "generator/scene/place.hpp"
#include "runtime/base/text.hpp"

namespace kanec::cli {
namespace {

std::optional<double> number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool is_whole = !text.empty() && !std::isspace(static_cast<unsigned char>(text[0])) && end == &text.back() + 1;
  return is_whole ? std::optional(value) : std::nullopt;
}

CLI::Validator finite(const std::string& allowed, const std::function<bool(double)>& is_right) {
  const auto check = [allowed, is_right](const std::string& text) {
    const std::optional<double> value = finite_number(text);
    if (value && is_right(*value)) return std::string();
    return fmt::format("found {}; allowed: {}", number(text) ? text : scene::in_quotes(text), allowed);
  };
  return {check, "", ""};
}

}  // namespace

std::optional<double> finite_number(const std::string& text) {
  const std::optional<double> value = number(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

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
