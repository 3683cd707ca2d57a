// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/functions.hpp"

#include <algorithm>
#include <optional>

#include "generator/scene/place.hpp"
#include "runtime/base/error.hpp"

namespace kanec {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

[[noreturn]] void refuse(const std::string& found, const std::string& allowed) {
  throw InputError("function: found " + found + "; allowed: " + allowed);
}

}  // namespace

std::vector<std::string> parts_of(const std::string& request) { return parts(request); }

std::string emitted_name(const std::string& request) {
  std::string name;
  for (const std::string& part : parts_of(request)) name += (name.empty() ? "" : "_and_") + part;
  return name;
}

std::vector<std::string> parts_of_emitted(const std::string& name, const std::vector<std::string>& requests) {
  for (const std::string& request : requests)
    if (emitted_name(request) == name) return parts_of(request);
  return {name};
}

Functions::Functions(const scene::Scene& scene) : all_(available_functions(scene)) {}

std::vector<std::string> Functions::names() const {
  std::vector<std::string> names;
  for (const Available& available : all_) names.push_back(available.name);
  return names;
}

bool Functions::has(const std::string& name) const {
  return std::any_of(all_.begin(), all_.end(), [&](const Available& available) { return available.name == name; });
}

void Functions::check(const std::string& request) const {
  if (const std::optional<Fault> fault = fault_of(request, all_)) refuse(fault->found, fault->allowed);
}

std::vector<std::string> Functions::chosen(const std::vector<std::string>& requests) const {
  std::vector<std::string> chosen;
  for (const std::string& request : requests) {
    check(request);
    if (contains(chosen, request)) refuse(scene::in_quotes(request) + " twice", "each function once");
    chosen.push_back(request);
  }
  return chosen;
}

Needs Functions::needs(const std::string& request) const {
  const std::vector<std::string> parts = parts_of(request);
  Needs needs;
  for (const Available& available : all_) {
    if (!contains(parts, available.name)) continue;
    needs.y = needs.y || available.signature.y;
    needs.ydot = needs.ydot || available.signature.ydot;
  }
  if (contains(parts, "accelerations")) needs.ydot = false;  // the others have it from there
  return needs;
}

}  // namespace kanec
