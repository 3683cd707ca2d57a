// When ever finer runs of a method tell no more. Not: the runs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace kanec {

class Refinement {
 public:
  // `known`: the reference's own error.
  explicit Refinement(double known) : known_(known) {}

  // Takes note of a run's error; true where the reference tells no more, or rounding takes what finer steps bring.
  bool is_done(double error) {
    constexpr double settled = 1e-8;
    without_gain_ = error > 0.5 * best_ && best_ < settled ? without_gain_ + 1 : 0;
    best_ = std::min(best_, error);
    return error <= known_ || without_gain_ == 2;
  }

 private:
  double known_;
  double best_ = INFINITY;
  int without_gain_ = 0;
};

}  // namespace kanec
