// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/variation_rows.hpp"

#include "generator/symbolic/factor.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

void VariationRows::add(int j, const Coordinate& row) {
  Measure measure = row.freedom.kind == Freedom::Kind::attitude ? of_ball(j) : of_motion(j, v_.motion(j, row));
  const bool is_turn = row.freedom.kind == Freedom::Kind::turn;
  if (row.freedom.kind == Freedom::Kind::attitude) {
    by_ball(row, j, measure);
    measure = beyond_ball(j, measure);
  }
  if (is_turn) by_motion(row, j, row, measure);
  by_slides(row, j, measure);
  for (int k = j; v_.lower(k) > 0;) {
    measure = shifted(row, k, measure);
    k = v_.lower(k);
    const Coordinate* turn = v_.rotation(k);
    if (turn && turn->freedom.kind == Freedom::Kind::attitude) by_ball(row, k, measure);
    measure = at_joint(k, measure);
    if (turn && turn->freedom.kind == Freedom::Kind::turn) by_motion(row, k, *turn, measure);
    by_slides(row, k, measure);
  }
}

// Of the moment about the origin, link axes, a column an axis.
VariationRows::Measure VariationRows::of_ball(int k) {
  const Carried& c = v_.of_link(k);
  return {-skew(c.moment), c.arms, k, c.inertia, v_.derivation.transposed(c.coriolis)};
}

// Of the equation of a scalar coordinate or of a translation, at its joint.
VariationRows::Measure VariationRows::of_motion(int k, const JointMotion& m) {
  const Carried& c = v_.at_joint(k);
  const auto crossed = [](const ex& a, const ex& b) { return b.is_equal(1) ? skew(a) : skew(a) * b; };
  Measure result{c.mass * m.slide, -crossed(c.pull, m.slide), v_.lower(k), crossed(c.moment, m.slide),
                 crossed(c.rate, m.slide)};
  if (m.turn.is_zero()) return result;
  result.B += skew(m.turn) * c.moment;
  result.Kh += c.arms * m.turn;
  result.K += c.inertia * m.turn;
  result.Kv += v_.derivation.transposed(c.coriolis) * m.turn;
  return result;
}

// Nothing but the acceleration of the joint's point counts beyond a ball.
VariationRows::Measure VariationRows::beyond_ball(int k, const Measure& measure) {
  const Frame home = v_.derivation.home(k);
  const ex B = v_.derivation.in_axes(measure.B, measure.frame, home);
  return {B, skew(v_.chain.origin(k)) * B, home, 0, 0};
}

VariationRows::Measure VariationRows::at_joint(int k, const Measure& m) {
  const Letters& link = v_.derivation.letters(k);
  if (!link.turns_with_lower) return beyond_ball(k, m);
  const int below = v_.lower(k);
  const ex& E_T = link.to_lower;
  return {v_.derivation.in_axes(m.B, m.frame, below), v_.derivation.in_axes(m.Kh, m.frame, below), below, E_T * m.K,
          E_T * m.Kv};
}

// From a joint's point to the lower link's origin.
VariationRows::Measure VariationRows::shifted(const Coordinate& row, int k, const Measure& m) {
  const int below = v_.lower(k);
  const ex& d = v_.derivation.joint_offsets[static_cast<std::size_t>(k)];
  const Frame frame = v_.derivation.home(below) == below ? below : m.frame;
  const ex B = v_.define("B", below, row, v_.derivation.in_axes(m.B, m.frame, below));
  return {frame == below ? B : m.B, v_.define("Kh", below, row, v_.derivation.in_axes(m.Kh, m.frame, frame)), frame,
          v_.define("K", below, row, m.K + skew(d) * B),
          v_.define("Kv", below, row, m.Kv + skew(v_.joint_rate(k)) * B)};
}

// --- entries of rows: a column of three is written as its transpose

void VariationRows::by_ball(const Coordinate& row, int k, const Measure& m) {
  const Coordinate& column = *v_.rotation(k);
  if (v_.by == By::y) return v_.place(row, column, m.Kv - skew(v_.derivation.letters(k).omega) * m.K, true);
  const ex origin = v_.derivation.in_axes(v_.chain.origin(k), v_.derivation.home(k), m.frame);
  v_.place(row, column, v_.derivation.in_axes(factored(m.Kh - skew(origin) * m.B), m.frame, k), true);
}

void VariationRows::by_motion(const Coordinate& row, int k, const Coordinate& column, const Measure& measure) {
  const JointMotion m = v_.motion(k, column);
  const ex B = v_.derivation.in_axes(measure.B, measure.frame, v_.lower(k));
  ex value = 0;
  if (v_.by == By::y) {
    value = along(m.turn, measure.Kv) + along(2 * m.turn_rate, measure.K) + along(2 * m.slide_rate, B);
  } else {
    const ex Kh = v_.derivation.in_axes(measure.Kh, measure.frame, v_.lower(k));
    const ex turning = m.turn.is_zero() ? ex(0) : sum(expanded(Kh - skew(v_.at_joint(k).origin) * B));
    value = along(m.turn, turning) + along(m.turn_rate, measure.Kv) + along(m.turn_acceleration, measure.K) +
            along(m.slide_acceleration, B);
  }
  v_.place(row, column, value, is_wide(column));
}

void VariationRows::by_slides(const Coordinate& row, int k, const Measure& measure) {
  for (const Coordinate& c : v_.derivation.letters(k).coordinates)
    if (c.row >= 0 && !is_rotation(c)) by_motion(row, k, c, measure);
}

// motionᵀ · measure; of a vector by a matrix the transpose.
ex VariationRows::along(const ex& motion, const ex& measure) {
  if (motion.is_zero() || measure.is_zero()) return 0;
  const Shape shape = shape_of(measure);
  if (shape_of(motion) == Shape::matrix) return v_.derivation.transposed(sum(expanded(motion))) * measure;
  if (shape == Shape::vector) return dot(motion, measure);
  if (shape == Shape::scalar) return measure * motion;
  return v_.derivation.transposed(sum(expanded(measure))) * motion;
}

}  // namespace kanec::symbolic
