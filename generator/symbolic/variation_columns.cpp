// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/variation_columns.hpp"

#include "generator/symbolic/factor.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

void VariationColumns::add(int k, const Coordinate& column) {
  Change change =
      column.freedom.kind == Freedom::Kind::attitude ? by_own_ball(k) : by_own_motion(k, v_.motion(k, column));
  if (is_rotation(column)) rows_of_slides(k, change, column);
  while (v_.lower(k) > 0) {
    change = shifted(change, k, column);
    k = v_.lower(k);
    if (const Coordinate* row = v_.rotation(k)) place_row(*row, k, change, column);
    change = at_joint(change, k);
    rows_of_slides(k, change, column);
  }
}

// A ball's ω turns with it, so that its turn takes all of ρ̈ along.
VariationColumns::Change VariationColumns::by_own_ball(int k) {
  const Carried& c = v_.of_link(k);
  const Frame home = v_.derivation.home(k);
  const ex to_home = v_.derivation.in_axes(ex(1), k, home);
  if (v_.by == By::xi)
    return {-skew(sum(expanded(c.force - c.mass * c.origin - v_.derivation.in_axes(c.pull, k, home)))) * to_home, home,
            0};
  return {v_.derivation.in_axes(-skew(c.rate) - skew(c.moment) * skew(v_.derivation.letters(k).omega), k, home), home,
          0};
}

VariationColumns::Change VariationColumns::by_own_motion(int k, const JointMotion& m) {
  const Carried& c = v_.at_joint(k);
  const ex turning = skew(c.moment);
  if (v_.by == By::y)
    return {sum(expanded(-skew(c.rate) * m.turn - 2 * (turning * m.turn_rate) + 2 * (c.mass * m.slide_rate))),
            v_.lower(k), c.coriolis * m.turn + 2 * (c.inertia * m.turn_rate) + 2 * (turning * m.slide_rate)};
  Change result{-skew(c.rate) * m.turn_rate - turning * m.turn_acceleration + c.mass * m.slide_acceleration,
                v_.lower(k),
                c.coriolis * m.turn_rate + c.inertia * m.turn_acceleration + turning * m.slide_acceleration};
  result.moment -= m.slide.is_equal(1) ? skew(c.force) : skew(sum(expanded(c.force))) * m.slide;
  if (m.turn.is_zero()) return result;
  result.force -= skew(sum(expanded(c.force - c.pull - c.mass * c.origin))) * m.turn;
  result.moment += turning * (skew(c.origin) * m.turn) + v_.derivation.transposed(c.arms) * m.turn -
                   skew(sum(expanded(c.torque))) * m.turn;
  return result;
}

VariationColumns::Change VariationColumns::shifted(const Change& change, int k, const Coordinate& column) {
  const int below = v_.lower(k);
  const ex& d = v_.derivation.joint_offsets[static_cast<std::size_t>(k)];
  const Frame frame = v_.derivation.home(below) == below ? below : change.frame;
  const std::string by = v_.by == By::xi ? "q" : "v";
  const ex force = v_.define("F" + by, below, column, v_.derivation.in_axes(change.force, change.frame, below));
  return {frame == below ? force : change.force, frame,
          v_.define("M" + by, below, column, change.moment + skew(d) * force)};
}

VariationColumns::Change VariationColumns::at_joint(const Change& change, int k) {
  const Letters& link = v_.derivation.letters(k);
  if (!link.turns_with_lower) return {change.force, change.frame, 0};
  return {v_.derivation.in_axes(change.force, change.frame, v_.lower(k)), v_.lower(k), link.to_lower * change.moment};
}

void VariationColumns::place_row(const Coordinate& row, int k, const Change& change, const Coordinate& column) {
  if (row.freedom.kind == Freedom::Kind::attitude) return v_.place(row, column, change.moment, false);
  ex value = component(row.axis, change.moment);
  const ex& pitch = v_.derivation.letters(k).pitch;
  if (!pitch.is_zero()) value += pitch * component(row.axis, v_.derivation.in_axes(change.force, change.frame, k));
  v_.place(row, column, value, is_wide(column));
}

void VariationColumns::rows_of_slides(int k, const Change& change, const Coordinate& column) {
  const ex force = v_.derivation.in_axes(change.force, change.frame, v_.lower(k));
  for (const Coordinate& row : v_.derivation.letters(k).coordinates) {
    if (row.row < 0 || is_rotation(row)) continue;
    const bool is_slide = row.freedom.kind == Freedom::Kind::slide;
    v_.place(row, column, is_slide ? component(row.axis, force) : force, is_slide && is_wide(column));
  }
}

// Of a vector, or of the columns of a matrix as a vector.
ex VariationColumns::component(const ex& axis, const ex& value) {
  if (value.is_zero()) return 0;
  if (shape_of(value) == Shape::vector) return dot(axis, sum(expanded(value)));
  return v_.derivation.transposed(sum(expanded(value))) * axis;
}

}  // namespace kanec::symbolic
