// The integrators that a report sets side by side, each a named set of options. Not: how finely they run
// (integration.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/integrate/options.hpp"

namespace kanec {

struct NamedMethod {
  std::string name;            // "cvode_bdf", "cvode_bdf, differences"
  integrate::Options options;  // method and Jacobian, the rest as it is by itself
};

// Of these names, or, where there are none, all but taylor_extended, which is for references. cvode_bdf stands there
// with the emitted Jacobian and with differences, unless the scene's would take too long to compile.
std::vector<NamedMethod> named_methods(const scene::Scene& scene, const std::vector<std::string>& names);

// What they call of the model, each function once.
std::vector<std::string> functions_called(const scene::Scene& scene, const std::vector<NamedMethod>& methods);

// Whether the method solves with differences of rates.
bool is_by_differences(const integrate::Options& options);
// "cvode_bdf, differences"
std::string name_of(const integrate::Options& options);
// "h 0.0025 s"; "rtol 1e-13"
std::string setting_text(const integrate::Options& options);
// "gauss6, h 0.0025 s"; "cvode_bdf, differences, rtol 1e-13"
std::string method_text(const integrate::Options& options);

}  // namespace kanec
