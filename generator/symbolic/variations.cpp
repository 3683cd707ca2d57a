// Derivatives of r without applied loads: how Kane's equations change with one coordinate or one speed, all else and ẏ
// kept. A joint's turn by φ moves all that it carries as one rigid body: δρ = φ × ρ, and with φ fixed in the lower link
// δρ̈ = φ × ρ̈ + 2 φ̇ × ρ̇ + φ̈ × ρ. So each column is one force and one moment at its joint, passed on inward, and each row
// one measure of what its joint carries against the motion of the joints below: both as the columns of A are
// (composites.hpp). After Jain & Rodriguez (1993) and Singh, Russo & Wensing (2022), here for absolute ω, ball joints
// and slides as well, about joint origins. SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/carried_motion.hpp"
#include "generator/symbolic/factor.hpp"
#include "generator/symbolic/kane.hpp"
#include "generator/symbolic/stages.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

enum class By { xi, y };

bool is_wide(const Coordinate& c) {
  return c.freedom.kind == Freedom::Kind::attitude || c.freedom.kind == Freedom::Kind::translation;
}

bool is_rotation(const Coordinate& c) {
  return c.freedom.kind == Freedom::Kind::attitude || c.freedom.kind == Freedom::Kind::turn;
}

// What one unit of a scalar coordinate, or of a translation by three, moves: a turn about the joint's point and a
// slide, fixed in the lower link, with their rates. Lower link's axes.
struct Motion {
  ex turn, turn_rate, turn_acceleration;
  ex slide, slide_rate, slide_acceleration;
};

// A change of the inertia force (axes of `frame`) and of its moment (link axes, or the lower link's at the joint).
struct Change {
  ex force;
  Frame frame = 0;
  ex moment;
};

// A row's measure of accelerations of the points that it carries: of φ̈ × ρ + σ̈ it is X·φ̈ + Z·σ̈, of 2 φ̇ × ρ̇ it is Y·φ̇,
// of what keeps its direction while all else turns by φ it is w·φ. Z and w in the axes of `frame`.
struct Measure {
  ex Z, w;
  Frame frame = 0;
  ex X, Y;
};

class Variations {
 public:
  Variations(Derivation& derivation, By by)
      : derivation_(derivation),
        by_(by),
        chain_(derive_acceleration_chain(derivation, derivation.rates)),
        balance_(inertia_alone(derivation, chain_)),
        sums_(derivation, balance_, "r"),
        composites_(derivation, std::vector<bool>(static_cast<std::size_t>(derivation.size()) + 1, false)),
        carried_(derivation, chain_, sums_, composites_),
        function_(derivation.function(by == By::xi ? "inertia_xi" : "inertia_y")) {}

  void all() {
    for (int k = derivation_.size(); k >= 1; --k)
      for (const Coordinate& c : derivation_.letters(k).coordinates) {
        if (c.row < 0) continue;
        add_row(k, c);
        add_column(k, c);
      }
  }

 private:
  int lower(int k) const { return derivation_.lower(k); }
  const Coordinate* rotation(int k) const {
    const std::vector<Coordinate>& own = derivation_.letters(k).coordinates;
    return own.empty() || own.front().row < 0 || !is_rotation(own.front()) ? nullptr : &own.front();
  }

  ex define(const std::string& name, int k, const Coordinate& of, const ex& value) {
    const Symbol& speed = derivation_.equations.table.of(of.speed);
    const std::string letter = name + "_" + speed.name + speed.suffix + "_";
    return derivation_.define(letter, name, k, Pass::inward, factored(value), "");
  }

  void place(const Coordinate& row, const Coordinate& column, const ex& block, bool is_transposed) {
    if (block.is_zero()) return;
    const int ny = derivation_.equations.layout.ny;
    function_.outputs.push_back({factored(block), row.row * ny + column.row, ny, is_transposed});
  }

  // --- motions of joints

  Motion motion(int k, const Coordinate& c) {
    const int below = lower(k);
    const ex spin = skew(derivation_.letters(below).omega);
    const auto rates = [&](const ex& of, ex& rate, ex& acceleration) {
      rate = spin * of;
      acceleration = chain_.spin(below) * of;
    };
    Motion m;
    if (c.freedom.kind == Freedom::Kind::turn) {
      m.turn = lower_axis(k, c);
      m.slide = derivation_.letters(k).pitch * m.turn;
    } else {
      m.slide = c.freedom.kind == Freedom::Kind::slide ? c.axis : ex(1);
    }
    rates(m.turn, m.turn_rate, m.turn_acceleration);
    rates(m.slide, m.slide_rate, m.slide_acceleration);
    return m;
  }

  // Of a turn, in the lower link's axes.
  ex lower_axis(int k, const Coordinate& c) {
    const Link& link = derivation_.mechanism().link(k);
    if (is_identity(link.zero)) return c.axis;
    ex& known = lower_axes_[k];
    const scene::Axis& a = link.freedoms.front().axis;
    if (known.is_zero())
      known = derivation_.equations.table.add_numbers(
          "a", "a", link.suffix,
          {scene::Number::constant(a[0]), scene::Number::constant(a[1]), scene::Number::constant(a[2])});
    return known;
  }

  // --- rows

  void add_row(int j, const Coordinate& row) {
    Measure measure = row.freedom.kind == Freedom::Kind::attitude ? of_ball(j) : of_motion(j, motion(j, row));
    const bool is_turn = row.freedom.kind == Freedom::Kind::turn;
    if (row.freedom.kind == Freedom::Kind::attitude) {
      by_ball(row, j, measure);
      measure = beyond_ball(j, measure);
    }
    if (is_turn) by_motion(row, j, row, measure);
    by_slides(row, j, measure);
    for (int k = j; lower(k) > 0;) {
      measure = shifted(row, k, measure);
      k = lower(k);
      const Coordinate* turn = rotation(k);
      if (turn && turn->freedom.kind == Freedom::Kind::attitude) by_ball(row, k, measure);
      measure = at_joint(k, measure);
      if (turn && turn->freedom.kind == Freedom::Kind::turn) by_motion(row, k, *turn, measure);
      by_slides(row, k, measure);
    }
  }

  // Of the moment about the origin, link axes, a column an axis.
  Measure of_ball(int k) {
    const Carried& c = carried_.of_link(k);
    return {-skew(c.moment), c.arms, k, c.inertia, derivation_.transposed(c.coriolis)};
  }

  // Of the equation of a scalar coordinate or of a translation, at its joint.
  Measure of_motion(int k, const Motion& m) {
    const Carried& c = carried_.at_joint(k);
    const auto crossed = [](const ex& a, const ex& b) { return b.is_equal(1) ? skew(a) : skew(a) * b; };
    Measure result{c.mass * m.slide, -crossed(c.pull, m.slide), lower(k), crossed(c.moment, m.slide),
                   crossed(c.rate, m.slide)};
    if (m.turn.is_zero()) return result;
    result.Z += skew(m.turn) * c.moment;
    result.w += c.arms * m.turn;
    result.X += c.inertia * m.turn;
    result.Y += derivation_.transposed(c.coriolis) * m.turn;
    return result;
  }

  // Nothing but the acceleration of the joint's point counts beyond a ball.
  Measure beyond_ball(int k, const Measure& measure) {
    const Frame home = derivation_.home(k);
    const ex Z = derivation_.in_axes(measure.Z, measure.frame, home);
    return {Z, skew(chain_.origin(k)) * Z, home, 0, 0};
  }

  Measure at_joint(int k, const Measure& m) {
    const Letters& link = derivation_.letters(k);
    if (!link.turns_with_lower) return beyond_ball(k, m);
    const int below = lower(k);
    const ex& E_T = link.to_lower;
    return {derivation_.in_axes(m.Z, m.frame, below), derivation_.in_axes(m.w, m.frame, below), below, E_T * m.X,
            E_T * m.Y};
  }

  // From a joint's point to the lower link's origin.
  Measure shifted(const Coordinate& row, int k, const Measure& m) {
    const int below = lower(k);
    const ex& d = derivation_.joint_offsets[static_cast<std::size_t>(k)];
    const Frame frame = derivation_.home(below) == below ? below : m.frame;
    const ex Z = define("Z", below, row, derivation_.in_axes(m.Z, m.frame, below));
    return {frame == below ? Z : m.Z, define("w", below, row, derivation_.in_axes(m.w, m.frame, frame)), frame,
            define("X", below, row, m.X + skew(d) * Z),
            define("Y", below, row, m.Y + skew(carried_.joint_rate(k)) * Z)};
  }

  // --- entries of rows: a column of three is written as its transpose

  void by_ball(const Coordinate& row, int k, const Measure& m) {
    const Coordinate& column = *rotation(k);
    if (by_ == By::y) return place(row, column, m.Y - skew(derivation_.letters(k).omega) * m.X, true);
    const ex origin = derivation_.in_axes(chain_.origin(k), derivation_.home(k), m.frame);
    place(row, column, derivation_.in_axes(factored(m.w - skew(origin) * m.Z), m.frame, k), true);
  }

  void by_motion(const Coordinate& row, int k, const Coordinate& column, const Measure& measure) {
    const Motion m = motion(k, column);
    const ex Z = derivation_.in_axes(measure.Z, measure.frame, lower(k));
    ex value = 0;
    if (by_ == By::y) {
      value = along(m.turn, measure.Y) + along(2 * m.turn_rate, measure.X) + along(2 * m.slide_rate, Z);
    } else {
      const ex w = derivation_.in_axes(measure.w, measure.frame, lower(k));
      const ex turning = m.turn.is_zero() ? ex(0) : sum(expanded(w - skew(carried_.at_joint(k).origin) * Z));
      value = along(m.turn, turning) + along(m.turn_rate, measure.Y) + along(m.turn_acceleration, measure.X) +
              along(m.slide_acceleration, Z);
    }
    place(row, column, value, is_wide(column));
  }

  void by_slides(const Coordinate& row, int k, const Measure& measure) {
    for (const Coordinate& c : derivation_.letters(k).coordinates)
      if (c.row >= 0 && !is_rotation(c)) by_motion(row, k, c, measure);
  }

  // motionᵀ · measure; of a vector by a matrix the transpose.
  ex along(const ex& motion, const ex& measure) {
    if (motion.is_zero() || measure.is_zero()) return 0;
    const Shape shape = shape_of(measure);
    if (shape_of(motion) == Shape::matrix) return derivation_.transposed(sum(expanded(motion))) * measure;
    if (shape == Shape::vector) return dot(motion, measure);
    if (shape == Shape::scalar) return measure * motion;
    return derivation_.transposed(sum(expanded(measure))) * motion;
  }

  // --- columns

  void add_column(int k, const Coordinate& column) {
    Change change =
        column.freedom.kind == Freedom::Kind::attitude ? by_own_ball(k) : by_own_motion(k, motion(k, column));
    if (is_rotation(column)) rows_of_slides(k, change, column);
    while (lower(k) > 0) {
      change = shifted(change, k, column);
      k = lower(k);
      if (const Coordinate* row = rotation(k)) place_row(*row, k, change, column);
      change = at_joint(change, k);
      rows_of_slides(k, change, column);
    }
  }

  // A ball's ω turns with it, so that its turn takes all of ρ̈ along.
  Change by_own_ball(int k) {
    const Carried& c = carried_.of_link(k);
    const Frame home = derivation_.home(k);
    const ex to_home = derivation_.in_axes(ex(1), k, home);
    if (by_ == By::xi)
      return {-skew(sum(expanded(c.force - c.mass * c.origin - derivation_.in_axes(c.pull, k, home)))) * to_home, home,
              0};
    return {derivation_.in_axes(-skew(c.rate) - skew(c.moment) * skew(derivation_.letters(k).omega), k, home), home, 0};
  }

  Change by_own_motion(int k, const Motion& m) {
    const Carried& c = carried_.at_joint(k);
    const ex turning = skew(c.moment);
    if (by_ == By::y)
      return {sum(expanded(-skew(c.rate) * m.turn - 2 * (turning * m.turn_rate) + 2 * (c.mass * m.slide_rate))),
              lower(k), c.coriolis * m.turn + 2 * (c.inertia * m.turn_rate) + 2 * (turning * m.slide_rate)};
    Change result{-skew(c.rate) * m.turn_rate - turning * m.turn_acceleration + c.mass * m.slide_acceleration, lower(k),
                  c.coriolis * m.turn_rate + c.inertia * m.turn_acceleration + turning * m.slide_acceleration};
    result.moment -= m.slide.is_equal(1) ? skew(c.force) : skew(sum(expanded(c.force))) * m.slide;
    if (m.turn.is_zero()) return result;
    result.force -= skew(sum(expanded(c.force - c.pull - c.mass * c.origin))) * m.turn;
    result.moment += turning * (skew(c.origin) * m.turn) + derivation_.transposed(c.arms) * m.turn -
                     skew(sum(expanded(c.torque))) * m.turn;
    return result;
  }

  Change shifted(const Change& change, int k, const Coordinate& column) {
    const int below = lower(k);
    const ex& d = derivation_.joint_offsets[static_cast<std::size_t>(k)];
    const Frame frame = derivation_.home(below) == below ? below : change.frame;
    const std::string by = by_ == By::xi ? "q" : "v";
    const ex force = define("F" + by, below, column, derivation_.in_axes(change.force, change.frame, below));
    return {frame == below ? force : change.force, frame,
            define("M" + by, below, column, change.moment + skew(d) * force)};
  }

  Change at_joint(const Change& change, int k) {
    const Letters& link = derivation_.letters(k);
    if (!link.turns_with_lower) return {change.force, change.frame, 0};
    return {derivation_.in_axes(change.force, change.frame, lower(k)), lower(k), link.to_lower * change.moment};
  }

  void place_row(const Coordinate& row, int k, const Change& change, const Coordinate& column) {
    if (row.freedom.kind == Freedom::Kind::attitude) return place(row, column, change.moment, false);
    ex value = component(row.axis, change.moment);
    const ex& pitch = derivation_.letters(k).pitch;
    if (!pitch.is_zero()) value += pitch * component(row.axis, derivation_.in_axes(change.force, change.frame, k));
    place(row, column, value, is_wide(column));
  }

  void rows_of_slides(int k, const Change& change, const Coordinate& column) {
    const ex force = derivation_.in_axes(change.force, change.frame, lower(k));
    for (const Coordinate& row : derivation_.letters(k).coordinates) {
      if (row.row < 0 || is_rotation(row)) continue;
      const bool is_slide = row.freedom.kind == Freedom::Kind::slide;
      place(row, column, is_slide ? component(row.axis, force) : force, is_slide && is_wide(column));
    }
  }

  // Of a vector, or of the columns of a matrix as a vector.
  ex component(const ex& axis, const ex& value) {
    if (value.is_zero()) return 0;
    if (shape_of(value) == Shape::vector) return dot(axis, sum(expanded(value)));
    return derivation_.transposed(sum(expanded(value))) * axis;
  }

  Derivation& derivation_;
  By by_;
  AccelerationChain chain_;
  Balance balance_;
  InwardSums sums_;
  Composites composites_;
  CarriedMotion carried_;
  Function& function_;
  std::map<int, ex> lower_axes_;
};

}  // namespace

void derive_inertia_xi(Derivation& derivation) { Variations(derivation, By::xi).all(); }
void derive_inertia_y(Derivation& derivation) { Variations(derivation, By::y).all(); }

}  // namespace kanec::symbolic
