// The functions of a generic system by name, in the flat layouts of runtime/abi/solver.hpp: a check compares any
// emitted function with it. Not: the equations (system.hpp). SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "runtime/generic/system.hpp"

namespace kanec::generic {

// The arguments of an evaluation; those that the function does not read may be empty.
template <class Real>
struct Arguments {
  Real t{};
  std::span<const Real> x = {}, y = {}, ydot = {}, u = {};
};

// The names known to evaluate(), in the order of runtime/abi/solver.hpp.
std::vector<std::string_view> function_names();

// Throws InputError for an unknown name and for an argument of the wrong length.
template <class Real>
std::vector<Real> evaluate(const System<Real>& system, std::string_view function, const Arguments<Real>& arguments);

extern template std::vector<double> evaluate(const System<double>&, std::string_view, const Arguments<double>&);
extern template std::vector<long double> evaluate(const System<long double>&, std::string_view,
                                                  const Arguments<long double>&);

}  // namespace kanec::generic
