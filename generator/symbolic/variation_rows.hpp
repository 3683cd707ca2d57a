// A row of a derivative of r: how the equation of one coordinate changes with its own and with those of the joints
// below. Not: with those of the joints above (variation_columns.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/symbolic/variation.hpp"

namespace kanec::symbolic {

class VariationRows {
 public:
  explicit VariationRows(Variation& variation) : v_(variation) {}

  void add(int link, const Coordinate& row);

 private:
  // A row's measure of accelerations of the points that it carries: of φ̈ × ρ + σ̈ it is K·φ̈ + B·σ̈, of 2 φ̇ × ρ̇ it is
  // Kv·φ̇, of what keeps its direction while all else turns by φ it is Kh·φ. B and Kh in the axes of `frame`.
  struct Measure {
    GiNaC::ex B, Kh;
    Frame frame = 0;
    GiNaC::ex K, Kv;
  };

  Measure of_ball(int link);
  Measure of_motion(int link, const JointMotion& motion);
  Measure beyond_ball(int link, const Measure& measure);
  Measure at_joint(int link, const Measure& measure);
  Measure shifted(const Coordinate& row, int link, const Measure& measure);
  void by_ball(const Coordinate& row, int link, const Measure& measure);
  void by_motion(const Coordinate& row, int link, const Coordinate& column, const Measure& measure);
  void by_slides(const Coordinate& row, int link, const Measure& measure);
  GiNaC::ex along(const GiNaC::ex& motion, const GiNaC::ex& measure);

  Variation& v_;
};

}  // namespace kanec::symbolic
