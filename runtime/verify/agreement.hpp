// How far the emitted code is from 50-digit arithmetic and from the generic path. Not: what is shown of it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "runtime/model/model.hpp"
#include "runtime/model/state_file.hpp"

namespace kanec {

// Largest deviations of one function over the states. The deviation in a state is the largest of a component, beside
// the largest component there, or its median over the states where that is more (zeros left out): a result that
// happens to cancel is judged by its usual size, and one that is zero but for roundings by what these are of. Infinite
// where a number is not finite. States in which the generic path itself has no finite result (A singular, a function of
// the scene outside its domain) are counted and left out.
struct Agreement {
  std::string function;
  double largest_ulps = 0.0, median_ulps = 0.0;  // from 50 digits, in ulps (2^-52 of the binade of that size)
  double generic = 0.0;                          // from the generic path in long double, relative
  double generic_double = 0.0;  // of the generic path in double from that: what the problem itself costs
  int worst_state = 0;          // that of largest_ulps, from 0
  int undefined = 0;            // states without a result
  int states = 0;               // of all
};

// What is allowed; a deviation that is not a number is not.
struct Bounds {
  // The longest chain of roundings behind a component is some ten a body of its path. Measured over trees of 1 to 64
  // bodies and 10^5 states: below 20. A wrong term is 1e10 and more.
  double ulps = 200.0;
  // 200 ulps are 4.4e-14. What the generic path adds in long double (1e-19 times the condition of A, which is 1e4 to
  // 1e6 in the shipped scenes) is below the rest.
  double generic = 1e-12;
  // Where A is ill conditioned every method in double loses digits: there so many times the generic path's own error
  // are allowed as well. A wrong term is a billion times more.
  double own = 4.0;
  double ill = 1e-13;  // from this error of the generic path on

  // A function that has no result in any state holds nothing.
  bool hold(const Agreement& agreement) const {
    const bool is_ill = std::isfinite(agreement.generic_double) && agreement.generic_double > ill;
    const double conditioned = is_ill ? own * agreement.generic_double : 0.0;
    const bool precise = agreement.largest_ulps <= ulps || agreement.largest_ulps * 0x1p-52 <= conditioned;
    const bool close = agreement.generic <= generic || agreement.generic <= conditioned;
    return precise && close && agreement.undefined < agreement.states;
  }
};

// All functions of the model in all states, of which there is one at least. `progress` is told the share that is done.
std::vector<Agreement> agreements(const scene::Scene& scene, const CompiledModel& model,
                                  const std::vector<State>& states, const std::function<void(double)>& progress);

}  // namespace kanec
