// The functions of a generic system by name, in the flat layouts of runtime/abi/solver.hpp: a check compares any
// emitted function with it. Not: the equations (equations.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/generic/system.hpp"

namespace kanec::generic {

// The usual ones, in the order of runtime/abi/solver.hpp.
std::vector<std::string_view> function_names();

// All that a scene can have: the usual ones, without `power` where nothing is applied, and those on request.
std::vector<std::string> function_names(const scene::Scene& scene);

// Real: double, long double; Dual of these for all but the derivative functions. A matrix comes row by row. Throws
// InputError for an unknown name and for an argument of the wrong length.
template <class Real>
std::vector<Real> evaluate(const System<Real>& system, std::string_view function, const Arguments<Real>& arguments);

extern template std::vector<double> evaluate(const System<double>&, std::string_view, const Arguments<double>&);
extern template std::vector<long double> evaluate(const System<long double>&, std::string_view,
                                                  const Arguments<long double>&);
extern template std::vector<Dual<double>> evaluate(const System<Dual<double>>&, std::string_view,
                                                   const Arguments<Dual<double>>&);
extern template std::vector<Dual<long double>> evaluate(const System<Dual<long double>>&, std::string_view,
                                                        const Arguments<Dual<long double>>&);

}  // namespace kanec::generic
