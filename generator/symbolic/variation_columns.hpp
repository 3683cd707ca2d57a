// A column of a derivative of r: what a change of one coordinate does to the equations of the joints below.
// Not: to those of the joints above, and to its own (variation_rows.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/symbolic/variation.hpp"

namespace kanec::symbolic {

class VariationColumns {
 public:
  explicit VariationColumns(Variation& variation) : v_(variation) {}

  void add(int link, const Coordinate& column);

 private:
  // A change of the inertia force (axes of `frame`) and of its moment (link axes, or the lower link's at the joint).
  struct Change {
    GiNaC::ex force;
    Frame frame = 0;
    GiNaC::ex moment;
  };

  Change by_own_ball(int link);
  Change by_own_motion(int link, const JointMotion& motion);
  Change shifted(const Change& change, int link, const Coordinate& column);
  Change at_joint(const Change& change, int link);
  void place_row(const Coordinate& row, int link, const Change& change, const Coordinate& column);
  void rows_of_slides(int link, const Change& change, const Coordinate& column);
  GiNaC::ex component(const GiNaC::ex& axis, const GiNaC::ex& value);

  Variation& v_;
};

}  // namespace kanec::symbolic
