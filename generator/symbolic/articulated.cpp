// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/articulated.hpp"

#include <utility>

#include "generator/symbolic/factor.hpp"
#include "generator/symbolic/notation.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

// The part normal to an axis, where that has zeros, and what is applied along it.
ex across(const ex& all, const ex& normal, const ex& applied) {
  return normal.is_equal(1) ? all : normal * all - applied;
}

}  // namespace

Articulated::Articulated(Derivation& derivation, const Balance& balance, const AppliedLoads& loads,
                         std::vector<bool> skip)
    : derivation_(derivation),
      balance_(balance),
      loads_(loads),
      skip_(std::move(skip)),
      passed_(skip_.size()),
      spin_(skip_.size()),
      origin_(skip_.size()) {
  for (int k = derivation.size(); k >= 1; --k)
    if (!skip_[static_cast<std::size_t>(k)]) inward(k);
  for (int k = 1; k <= derivation.size(); ++k)
    if (!skip_[static_cast<std::size_t>(k)]) outward(k);
}

// --- names

ex Articulated::define(const std::string& name, int k, const ex& value, const std::string& meaning, Pass pass) {
  return derivation_.define(name, name, k, pass, value, meaning);
}

ex Articulated::symmetric(const std::string& name, int k, const ex& value, const std::string& meaning) {
  return derivation_.define(name, name, k, Pass::inward, value, meaning, true);
}

std::string Articulated::of(const std::string& letter, int k, std::size_t i) const {
  return coordinates(k).size() == 1 ? letter : letter + std::to_string(i + 1) + "_";
}

// From one frame's components to another's, by name where it is a product; k: the link whose axes are `from`.
ex Articulated::rotation(Frame from, Frame to, int k) {
  const ex value = derivation_.in_axes(ex(1), from, to);
  if (value.is_equal(1) || GiNaC::is_a<Atom>(value)) return value;
  ex& known = rotations_[{from, to}];
  const std::string other = to == 0 ? "0" : derivation_.mechanism().link(to).suffix;
  if (known.is_zero())
    known = derivation_.define("C" + other + "_", "C_{" + latex_index(other) + ",#}", k, Pass::outward, value,
                               "takes components in the body to those in body " + other);
  return known;
}

// 1 − a aᵀ where a is a coordinate axis, of which zeros follow; else 1.
ex Articulated::projection(const Coordinate& c, int k) {
  if (coordinate_axis(c.freedom.axis) < 0 || !derivation_.letters(k).pitch.is_zero()) return 1;
  std::vector<scene::Number> entries(9, scene::Number::constant(0.0));
  for (std::size_t i = 0; i < 3; ++i)
    if (c.freedom.axis[i] == 0) entries[4 * i] = scene::Number::constant(1.0);
  const SymbolTable& table = derivation_.equations.table;
  return derivation_.equations.table.add_numbers("P_" + table.of(c.axis).name, "P", table.of(c.axis).suffix, entries);
}

ex Articulated::found(int k, std::size_t i, const ex& value) {
  const Symbol& rate = derivation_.equations.table.of(coordinates(k)[i].acceleration);
  const bool is_root = is_cut(k) && i == 1;
  const std::string name = is_root ? "Pddot" : rate.name;
  const std::string latex = is_root ? "\\ddot P" : rate.latex;
  ex& letter = found_[{k, i}];
  letter = value;
  if (value.is_zero() || GiNaC::is_a<Atom>(value)) return letter;
  const std::string suffix = rate.suffix;
  letter = derivation_.equations.table.add(Role::quantity, name, latex, suffix, shape_of(value));
  derivation_.equations.quantities.push_back({letter, value, derivation_.mechanism().link(k).body, Pass::solved, ""});
  return letter;
}

// --- inward

// m 1, h̃ and J of the link itself, what is applied to it less inertia at ẏ = 0, and what the joints on it pass on.
Articulated::Load Articulated::carried(int k) {
  const auto at = static_cast<std::size_t>(k);
  const Frame home = derivation_.home(k);
  const Inertia& own = derivation_.inertia(k);
  if (identity_.is_zero()) {
    std::vector<scene::Number> entries(9, scene::Number::constant(0.0));
    for (const std::size_t i : {0U, 4U, 8U}) entries[i] = scene::Number::constant(1.0);
    identity_ = derivation_.equations.table.add_numbers("one", "1", "", entries);
  }
  const ex& G = balance_.force[at];
  Load sum{own.mass * identity_,
           skew(own.moment),
           own.inertia,
           G,
           balance_.moment[at] + skew(own.reference) * derivation_.in_axes(G, home, k),
           home};
  for (const int c : derivation_.mechanism().children(k))
    if (!is_cut(c)) add(sum, k, c);
  Load named;
  named.frame = home;
  named.M = symmetric("MA", k, sum.M, "force for an acceleration of the origin, home axes [kg]");
  const ex HB = define(home == k ? "HA" : "HB", k, sum.H, "moment for an acceleration of the origin, body axes [kg m]");
  const ex columns = derivation_.in_axes(ex(1), home, k);
  named.H = columns.is_equal(1) ? HB : define("HA", k, HB * columns, "the same for one in inertial axes [kg m]");
  named.J = symmetric("JA", k, sum.J, "moment for an angular acceleration, body axes [kg m^2]");
  named.g = define("g", k, sum.g, "force that drives it, home axes [N]");
  named.n = define("n", k, sum.n, "moment that drives it, body axes [N m]");
  return named;
}

// With d from the link's origin to the joint: H + d̃ M, and J − (H + d̃ M) d̃ + d̃ Hᵀ.
void Articulated::add(Load& sum, int k, int c) {
  const Load& joint = passed_[static_cast<std::size_t>(c)];
  const Frame home = derivation_.home(k);
  const ex& d = derivation_.joint_offsets[static_cast<std::size_t>(c)];
  const ex M =
      symmetric("Mb", c, congruence(rotation(joint.frame, k, c), joint.M), "M of the joint, lower body's axes");
  sum.M += joint.frame == home ? joint.M : home == k ? M : congruence(rotation(joint.frame, home, c), joint.M);
  const ex H = define("Hb", c, joint.H + skew(d) * M, "H of the joint at the lower body's origin, its axes");
  sum.H += H;
  sum.J += joint.J - H * skew(d);
  if (!joint.H.is_zero()) sum.J += skew(d) * derivation_.transposed(joint.H);
  sum.g += derivation_.in_axes(joint.g, joint.frame, home);
  sum.n += joint.n + skew(d) * derivation_.in_axes(joint.g, joint.frame, k);
}

void Articulated::inward(int k) {
  Load load = carried(k);
  const std::vector<Coordinate>& own = coordinates(k);
  if (is_cut(k)) return eliminate_root(load, k);
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].row < 0) continue;
    if (own[i].freedom.kind == Freedom::Kind::attitude) eliminate_attitude(load, k, i);
    if (own[i].freedom.kind == Freedom::Kind::turn) eliminate_turn(load, k, i);
  }
  const bool has_slides = !own.empty() && (own.back().freedom.kind == Freedom::Kind::slide ||
                                           own.back().freedom.kind == Freedom::Kind::translation);
  if (!passes_moment(k)) load.H = load.J = load.n = 0;
  if (passes_moment(k) || has_slides) load = in_lower_axes(load, k);
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].row < 0) continue;
    if (own[i].freedom.kind == Freedom::Kind::slide) eliminate_slide(load, k, i);
    if (own[i].freedom.kind == Freedom::Kind::translation) eliminate_translation(load, k, i);
  }
  passed_[static_cast<std::size_t>(k)] = load;
}

Articulated::Load Articulated::in_lower_axes(const Load& load, int k) {
  const int below = derivation_.lower(k);
  const ex C = rotation(load.frame, below, k);
  Load result;
  result.frame = below;
  result.M = symmetric("Mp", k, congruence(C, load.M), "M passed on, lower body's axes [kg]");
  result.g = define("gp", k, derivation_.in_axes(load.g, load.frame, below), "force passed on, lower body's axes [N]");
  if (!passes_moment(k)) return result;
  const ex& E_T = derivation_.letters(k).to_lower;
  result.H = define("Hp", k, similarity(E_T, load.H), "H passed on, lower body's axes [kg m]");
  result.J = symmetric("Jp", k, congruence(E_T, load.J), "J passed on, lower body's axes [kg m^2]");
  result.n = define("np", k, E_T * load.n, "moment passed on, lower body's axes [N m]");
  return result;
}

// J ω̇ + H P̈ = n with J = L D Lᵀ.
void Articulated::eliminate_attitude(Load& load, int k, std::size_t i) {
  const ex factors = define("LD", k, ldl(load.J), "L D L^T = JA: L, and 1/D on the diagonal");
  const ex Y = define("Y", k, forward(factors, load.H), "L^-1 HA");
  const ex W = define("W", k, scaled(factors, Y), "D^-1 L^-1 HA");
  const ex w = define("w_", k, scaled(factors, forward(factors, load.n)), "D^-1 L^-1 n");
  triples_[{k, i}] = {factors, w, W};
  const ex Yt = Y.is_zero() ? ex(0) : derivation_.transposed(Y);
  load.M = symmetric("M", k, load.M - Yt * W, "MA less what the ball takes up [kg]");
  load.g = define("gb", k, load.g - Yt * w, "force with the ball solved [N]");
  load.H = load.J = load.n = 0;
}

// D q̈ + B·P̈ + K·ω̇ = u for a coordinate q, u with what is applied along it.
const Articulated::Scalar& Articulated::solve(int k, std::size_t i, const Pivot& p, const ex& driving) {
  const ex inverse_D = define(of("invD", k, i), k, 1 / p.D, "1/D");
  const ex kB = define(of("kB", k, i), k, inverse_D * p.B, "B/D");
  const ex kK = define(of("kK", k, i), k, inverse_D * p.K, "K/D");
  const ex tau = define(of("tau", k, i), k, effort(k, i), "applied along the coordinate [N m], [N]");
  const ex u = define(of("u_", k, i), k, driving + tau, "drives it [N m], [N]");
  const ex v = define(of("v", k, i), k, inverse_D * u, "u/D");
  return scalars_[{k, i}] = {v, kB, kK, projection(coordinates(k)[i], k), tau};
}

// What passes on has nothing along the axis but what is applied there.
void Articulated::eliminate_turn(Load& load, int k, std::size_t i) {
  const ex& b = coordinates(k)[i].axis;
  ex force = derivation_.transposed(load.H) * b, moment = load.J * b;
  ex driving = dot(b, load.n);
  const ex& pitch = derivation_.letters(k).pitch;
  if (!pitch.is_zero()) {
    force += pitch * (load.M * b);
    moment += pitch * (load.H * b);
    driving += pitch * dot(b, load.g);
  }
  const ex B = define(of("B", k, i), k, force, "force of a unit of the angle's acceleration [kg m]");
  const ex K = define(of("K", k, i), k, moment, "its moment about the body origin, body axes [kg m^2]");
  const ex D = define(of("D", k, i), k, dot(b, K) + pitch * dot(b, B), "pivot: inertia that the angle feels [kg m^2]");
  const auto& [v, kB, kK, normal, tau] = solve(k, i, {B, K, D}, driving);
  load.M = symmetric("M", k, load.M - outer(kB, B), "MA less what the turn takes up [kg]");
  load.H = define("H", k, normal * (load.H - outer(kK, B)), "HA less what the turn takes up [kg m]");
  load.J = symmetric("J", k, normal * (load.J - outer(kK, K)) * normal, "JA less what the turn takes up [kg m^2]");
  load.g = define("gt", k, load.g - v * B, "force with the turn solved [N]");
  load.n = define("nt", k, across(load.n - v * K, normal, tau * b), "moment with the turn solved [N m]");
}

void Articulated::eliminate_slide(Load& load, int k, std::size_t i) {
  const ex& a = coordinates(k)[i].axis;
  const ex B = define(of("B", k, i), k, load.M * a, "force of a unit of the slide's acceleration [kg]");
  const ex K = define(of("K", k, i), k, load.H * a, "its moment [kg m]");
  const ex D = define(of("D", k, i), k, dot(a, B), "pivot: mass that the slide feels [kg]");
  const auto& [v, kB, kK, normal, tau] = solve(k, i, {B, K, D}, dot(a, load.g));
  load.M = symmetric(of("Ms", k, i), k, normal * (load.M - outer(kB, B)) * normal, "M with the slide solved [kg]");
  load.H = define(of("Hs", k, i), k, (load.H - outer(kK, B)) * normal, "H with the slide solved [kg m]");
  load.J = symmetric(of("Js", k, i), k, load.J - outer(kK, K), "J with the slide solved [kg m^2]");
  load.g = define(of("gs", k, i), k, across(load.g - v * B, normal, tau * a), "force with the slide solved [N]");
  load.n = define(of("ns", k, i), k, load.n - v * K, "moment with the slide solved [N m]");
}

// M (P̈ + s̈) + Hᵀ ω̇ = g: nothing but a moment passes.
void Articulated::eliminate_translation(Load& load, int k, std::size_t i) {
  const ex factors = define("LDs", k, ldl(load.M), "L D L^T = M: L, and 1/D on the diagonal");
  const ex Ht = load.H.is_zero() ? ex(0) : derivation_.transposed(load.H);
  const ex Y = define("Ys", k, forward(factors, Ht), "L^-1 H^T");
  const ex W = define("Ws", k, scaled(factors, Y), "D^-1 L^-1 H^T");
  const ex w = define("ws", k, scaled(factors, forward(factors, load.g)), "D^-1 L^-1 g");
  triples_[{k, i}] = {factors, w, W};
  const ex Yt = Y.is_zero() ? ex(0) : derivation_.transposed(Y);
  load.J = symmetric("Js", k, load.J - Yt * W, "J with the translation solved [kg m^2]");
  load.n = define("ns", k, load.n - Yt * w, "moment with the translation solved [N m]");
  load.M = load.H = load.g = 0;
}

// Of a free joint nothing passes on: its P̈ is known as soon as its ω̇ is eliminated.
void Articulated::eliminate_root(const Load& load, int k) {
  Load rest = load;
  eliminate_attitude(rest, k, 0);
  const ex factors = define("LDs", k, ldl(rest.M), "L D L^T = M: L, and 1/D on the diagonal");
  triples_[{k, 1}] = {factors, define("ws", k, scaled(factors, forward(factors, rest.g)), "D^-1 L^-1 g"), 0};
}

// --- outward

void Articulated::outward(int k) {
  const auto at = static_cast<std::size_t>(k);
  const int below = derivation_.lower(k);
  const Frame home = derivation_.home(k);
  ex origin;
  if (is_cut(k)) {
    const Triple& root = triples_.at({k, 1});
    origin = found(k, 1, backward(root.factors, root.w));
  } else {
    const auto lower = static_cast<std::size_t>(below);
    const ex joint = derivation_.in_axes(origin_[lower], derivation_.home(below), below) -
                     skew(derivation_.joint_offsets[at]) * spin_[lower];
    origin = derivation_.in_axes(follow_slides(joint, k), below, home);
  }
  origin_[at] = define("beta", k, origin, "acceleration of the origin beyond that at ydot = 0 [m/s^2]", Pass::solved);
  const ex turned =
      passes_moment(k) ? derivation_.letters(k).from_lower * spin_[static_cast<std::size_t>(below)] : ex(0);
  spin_[at] = follow_turn(turned, k);
}

// Acceleration of the link's origin, lower link's axes, from that of the joint.
ex Articulated::follow_slides(ex joint, int k) {
  const ex& spin = spin_[static_cast<std::size_t>(derivation_.lower(k))];
  for (std::size_t i = coordinates(k).size(); i-- > 0;) {
    const Coordinate& c = coordinates(k)[i];
    if (c.row < 0) continue;
    if (c.freedom.kind == Freedom::Kind::translation) {
      const Triple& of = triples_.at({k, i});
      const ex absolute =
          define("Ps", k, backward(of.factors, of.w - of.W * spin), "acceleration of the origin [m/s^2]", Pass::solved);
      found(k, i, absolute - joint);
      joint = absolute;
    }
    if (c.freedom.kind != Freedom::Kind::slide) continue;
    joint = define(of("Pj", k, i), k, joint, "acceleration of the joint beyond that at ydot = 0 [m/s^2]", Pass::solved);
    const Scalar& of = scalars_.at({k, i});
    const ex kB = of.normal * of.kB;
    const ex along = define(this->of("phi", k, i), k, of.v - dot(kB, joint) - dot(of.kK, spin), "", Pass::solved);
    found(k, i, of.normal.is_equal(1) ? along : along - dot(c.axis, joint));
    joint = of.normal.is_equal(1) ? joint + along * c.axis : of.normal * joint + along * c.axis;
  }
  return joint;
}

// Angular acceleration, link axes, from the lower link's in these axes.
ex Articulated::follow_turn(const ex& turned, int k) {
  const auto at = static_cast<std::size_t>(k);
  if (coordinates(k).empty() || coordinates(k)[0].row < 0) return define("alpha", k, turned, "", Pass::solved);
  const Coordinate& c = coordinates(k)[0];
  if (c.freedom.kind == Freedom::Kind::attitude) {
    const Triple& of = triples_.at({k, 0});
    return found(k, 0, backward(of.factors, of.w - of.W * origin_[at]));
  }
  if (c.freedom.kind != Freedom::Kind::turn) return define("alpha", k, turned, "", Pass::solved);
  const ex spin = define("alphaL", k, turned,
                         "angular acceleration of the lower body beyond that at ydot = 0, body axes", Pass::solved);
  const Scalar& of = scalars_.at({k, 0});
  const ex along = define("phi", k, of.v - dot(of.kB, origin_[at]) - dot(of.normal * of.kK, spin), "", Pass::solved);
  const bool is_plain = of.normal.is_equal(1);
  found(k, 0, is_plain ? along : along - dot(c.axis, spin));
  if (const ex& pitch = derivation_.letters(k).pitch; !pitch.is_zero()) {
    origin_[at] = define("betas", k, origin_[at] + pitch * along * derivation_.in_axes(c.axis, k, derivation_.home(k)),
                         "acceleration of the origin on its screw [m/s^2]", Pass::solved);
  }
  return define("alpha", k, (is_plain ? spin : of.normal * spin) + along * c.axis,
                "angular acceleration beyond that at ydot = 0, body axes [rad/s^2]", Pass::solved);
}

}  // namespace kanec::symbolic
