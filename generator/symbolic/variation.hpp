// One derivative of r without applied loads in the making: by the tangent of x or by y, with what its rows and columns
// need. Not: rows (variation_rows.hpp), columns (variation_columns.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/symbolic/carried_motion.hpp"

namespace kanec::symbolic {

enum class By { xi, y };

// What one unit of a scalar coordinate, or of a translation by three, moves: a turn about the joint's point and a
// slide, fixed in the lower link, with their rates. Lower link's axes.
struct JointMotion {
  GiNaC::ex turn, turn_rate, turn_acceleration;
  GiNaC::ex slide, slide_rate, slide_acceleration;
};

class Variation {
 public:
  Variation(Derivation& derivation, By by);

  int lower(int link) const { return derivation.lower(link); }
  // The coordinate of a link's turn or attitude where it is in the state, else nullptr.
  const Coordinate* rotation(int link) const;
  JointMotion motion(int link, const Coordinate& coordinate);
  // A quantity of a link that belongs to a row or a column.
  GiNaC::ex define(const std::string& name, int link, const Coordinate& of, const GiNaC::ex& value);
  // An entry of the derivative; where `is_transposed`, its transpose is given.
  void place(const Coordinate& row, const Coordinate& column, const GiNaC::ex& block, bool is_transposed);

  const Carried& of_link(int link) const { return carried_.of_link(link); }
  const Carried& at_joint(int link) { return carried_.at_joint(link); }
  const GiNaC::ex& joint_rate(int link) { return carried_.joint_rate(link); }

  Derivation& derivation;
  By by;
  AccelerationChain chain;

 private:
  GiNaC::ex lower_axis(int link, const Coordinate& coordinate);

  Balance balance_;
  InwardSums sums_;
  Composites composites_;
  CarriedMotion carried_;
  Function& function_;
  std::map<int, GiNaC::ex> lower_axes_;
};

}  // namespace kanec::symbolic
