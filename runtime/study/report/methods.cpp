// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/methods.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/model/functions.hpp"
#include "runtime/run/needed_functions.hpp"
#include "runtime/run/watched_events.hpp"

namespace kanec {
namespace {

using integrate::JacobianChoice;
using integrate::Method;

std::vector<Method> chosen(const std::vector<std::string>& names) {
  std::vector<Method> list;
  for (const std::string& name : names.empty() ? integrate::method_names() : names) {
    const Method method = integrate::method_of(name);
    if (method != Method::taylor_extended || !names.empty()) list.push_back(method);
  }
  return list;
}

}  // namespace

std::vector<NamedMethod> named_methods(const scene::Scene& scene, const std::vector<std::string>& names) {
  std::vector<NamedMethod> list;
  for (const Method method : chosen(names)) {
    integrate::Options options;
    options.method = method;
    options.events = watched_events(scene);
    functions_to_integrate(scene, options);  // decides on the Jacobian
    list.push_back({name_of(options), options});
    if (method != Method::cvode_bdf || is_by_differences(options)) continue;
    options.jacobian = JacobianChoice::differences;
    list.push_back({name_of(options), options});
  }
  return list;
}

std::vector<std::string> functions_called(const scene::Scene& scene, const std::vector<NamedMethod>& methods) {
  std::vector<std::string> list;
  for (const NamedMethod& method : methods) {
    integrate::Options options = method.options;
    for (const std::string& function : functions_to_integrate(scene, options))
      if (std::find(list.begin(), list.end(), function) == list.end()) list.push_back(function);
  }
  return list;
}

bool is_by_differences(const integrate::Options& options) {
  return has_jacobian(options.method) && options.jacobian == JacobianChoice::differences;
}

std::string name_of(const integrate::Options& options) {
  return name_of(options.method) + (is_by_differences(options) ? ", differences" : "");
}

std::string setting_text(const integrate::Options& options) {
  if (has_fixed_step(options.method)) return fmt::format("h {:.3g} s", options.step);
  return fmt::format("rtol {:.0e}", options.relative_tolerance);
}

std::string method_text(const integrate::Options& options) { return name_of(options) + ", " + setting_text(options); }

}  // namespace kanec
