// Emitted code as it is compiled, in its variants: time of an evaluation beside its error. Not: ways of deriving, which
// need no compiler (evaluation.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "runtime/model/model.hpp"
#include "runtime/model/state_file.hpp"
#include "runtime/study/report/ulp_errors.hpp"

namespace kanec {

struct VariantErrors {
  std::string function, name;  // "accelerations", "lanes"
  bool is_float = false;
  UlpErrors ulps;            // of its own scalar, from the generic path in 50 digits
  double nanoseconds = 0.0;  // of one state, median of a few

  // The median in ulps of double.
  double double_ulps() const { return ulps.median * (is_float ? 0x1p29 : 1.0); }
};

struct VariantOptions {
  std::vector<std::string> functions;  // "accelerations", "a+b"
  std::vector<State> random, hard;     // the scene's default parameters and inputs are put in their place
  BuildOptions build;
};

// By function: as emitted; accelerations by both algorithms; loops for size; lanes in double and in float; and the
// generic path in double. Those that disagree are left out.
std::vector<VariantErrors> variant_errors(const scene::Scene& scene, const VariantOptions& options);

}  // namespace kanec
