// Systems whose equations stand in textbooks, in every kind of coordinate that they can be written in. Oracles: those
// closed forms.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "tests/generic/sample.hpp"

namespace kanec::generic {
namespace {

using scene::Axis;
using scene::Number;

constexpr double g = 9.81;
constexpr Axis X = {1, 0, 0}, Y = {0, 1, 0}, Z = {0, 0, 1};

scene::Vector constants(double a, double b, double c) {
  return {Number::constant(a), Number::constant(b), Number::constant(c)};
}

scene::Joint joint(const std::vector<Axis>& turns, const std::vector<Axis>& slides = {}) {
  scene::Joint joint;
  joint.ball = false;
  joint.slides.clear();
  for (const Axis& axis : turns) joint.turns.push_back({.axis = axis});
  for (const Axis& axis : slides) joint.slides.push_back({.axis = axis});
  return joint;
}

// Inertia by principal moments; r along the third axis; q along it too.
scene::Body body(const scene::Joint& joint, double m, std::array<double, 3> I, double r_z, double q_z = 0) {
  scene::Body body;
  body.joint = joint;
  body.mass = Number::constant(m);
  body.inertia.xx = Number::constant(I[0]);
  body.inertia.yy = Number::constant(I[1]);
  body.inertia.zz = Number::constant(I[2]);
  body.r = constants(0, 0, r_z);
  body.q = constants(0, 0, q_z);
  return body;
}

// A chain on the inertial frame under gravity, at rest.
Sample chain(const std::vector<scene::Body>& bodies) {
  Sample s;
  s.scene.bodies = bodies;
  for (std::size_t k = 0; k < bodies.size(); ++k) s.scene.lower.push_back(static_cast<int>(k));
  s.scene.gravity = constants(0, 0, -g);
  const scene::Layout layout(s.scene);
  s.x = Vector::Zero(layout.nx);
  s.y = s.ydot = Vector::Zero(layout.ny);
  return s;
}

scene::Load joint_load(int body, bool turn) {
  scene::Load load;
  load.kind = scene::Load::Kind::joint;
  load.point.body = body;
  load.turn = turn;
  return load;
}

// (I + m l²) θ̈ = -m g l sin θ.
TEST(ClosedForm, compound_pendulum) {
  const double m = 1.7, l = 0.6, I = 0.09;
  Sample s = chain({body(joint({Y}), m, {0.2, I, 0.3}, -l)});
  for (const Real theta : {-2.5L, 0.1L, 1.0L}) {
    s.x << theta;
    s.y << 0.7L;
    EXPECT_NEAR(double(s("accelerations")[0]), double(-m * Real(g) * l * std::sin(theta) / (I + Real(m) * l * l)),
                1e-15);
  }
}

// Point masses; absolute angles φ1 = θ1, φ2 = θ1 + θ2, δ = φ1 - φ2:
// (m1 + m2) l1 φ̈1 + m2 l2 φ̈2 cos δ + m2 l2 φ̇2² sin δ + (m1 + m2) g sin φ1 = 0,
// l1 φ̈1 cos δ + l2 φ̈2 - l1 φ̇1² sin δ + g sin φ2 = 0.
TEST(ClosedForm, double_pendulum) {
  const Real m1 = 1.25L, m2 = 0.5L, l1 = 0.75L, l2 = 0.625L;
  Sample s = chain(
      {body(joint({Y}), double(m1), {}, double(-l1)), body(joint({Y}), double(m2), {}, double(-l2), double(-l1))});
  s.x << 0.8L, -1.9L;
  s.y << 1.3L, -2.1L;
  const Real phi1 = s.x[0], phi2 = s.x[0] + s.x[1], rate1 = s.y[0], rate2 = s.y[0] + s.y[1], delta = phi1 - phi2;
  Eigen::Matrix<Real, 2, 2> A;
  A << (m1 + m2) * l1, m2 * l2 * std::cos(delta), l1 * std::cos(delta), l2;
  const Eigen::Matrix<Real, 2, 1> f = {
      -m2 * l2 * rate2 * rate2 * std::sin(delta) - (m1 + m2) * Real(g) * std::sin(phi1),
      l1 * rate1 * rate1 * std::sin(delta) - Real(g) * std::sin(phi2)};
  const Eigen::Matrix<Real, 2, 1> expected = A.inverse() * f;
  const Vector found = s("accelerations");
  EXPECT_LT(relative_error(Vector{{found[0], found[0] + found[1]}}, expected), rounding);
}

// (M + m) ẍ + m l (θ̈ cos θ - θ̇² sin θ) = F, l θ̈ + ẍ cos θ = g sin θ, θ from upright.
TEST(ClosedForm, cart_pole) {
  const Real M = 2, m = 0.25L, l = 0.5L, F = 3, theta = 0.4L, rate = -1.7L;
  Sample s = chain({body(joint({}, {X}), double(M), {1, 1, 1}, 0), body(joint({Y}), double(m), {}, double(l))});
  s.scene.inputs = {{"F", 0}};
  scene::Load push = joint_load(1, false);
  push.effort = Number::input(0);
  s.scene.loads = {push};
  s.u = Vector{{F}};
  s.x << theta, 1.0L;  // rotations first
  s.y << rate, 0.3L;
  Eigen::Matrix<Real, 2, 2> A;
  A << l, std::cos(theta), m * l * std::cos(theta), M + m;
  const Eigen::Matrix<Real, 2, 1> f = {Real(g) * std::sin(theta), F + m * l * rate * rate * std::sin(theta)};
  EXPECT_LT(relative_error(s("accelerations"), A.inverse() * f), rounding);
}

// A top on its tip, transverse moment I1 about the tip, I3 about its axis, tilted by θ: precession Ω and spin ω3 are
// steady where I1 Ω² cos θ - I3 ω3 Ω + m g l = 0.
struct Top {
  double m = 0.5, l = 0.25, transverse = 0.0625, I3 = 0.03125;
  Real theta = 0.6L, precession = 2;

  Real omega3() const {
    const Real I1 = transverse + m * l * l;
    return (I1 * precession * precession * std::cos(theta) + Real(m) * g * l) / (I3 * precession);
  }
  scene::Body on(const scene::Joint& tip) const { return body(tip, m, {transverse, transverse, I3}, l); }
};

TEST(ClosedForm, heavy_top_precesses_steadily_by_eulers_angles) {
  const Top top;
  Sample s = chain({top.on(joint({Z, X, Z}))});
  s.x << 0.9L, top.theta, -0.4L;
  s.y << top.precession, 0, top.omega3() - top.precession * std::cos(top.theta);
  EXPECT_LT(double(s("residual").norm()), 1e-18);  // moments of about 1
  EXPECT_LT(double(s("accelerations").norm()), 1e-16);
}

// By Euler parameters: ω in body axes turns backwards with the relative spin, ω̇ = (ψ̇ e3)~ᵀ ω.
TEST(ClosedForm, heavy_top_precesses_steadily_on_a_ball) {
  using Turn = Eigen::AngleAxis<Real>;
  const Top top;
  scene::Joint tip = joint({});
  tip.ball = true;
  Sample s = chain({top.on(tip)});
  const Eigen::Quaternion<Real> attitude(Turn(0.9L, Vector3<Real>::UnitZ()) * Turn(top.theta, Vector3<Real>::UnitX()));
  s.x = attitude.coeffs();
  // with ψ = 0 the line of nodes is the body's first axis
  s.y << 0, top.precession * std::sin(top.theta), top.omega3();
  const Real spin = top.omega3() - top.precession * std::cos(top.theta);
  const Vector3<Real> omega = s.y, expected = omega.cross(Vector3<Real>(0, 0, spin));
  EXPECT_LT(relative_error(s("accelerations"), expected), 10 * rounding);
}

// n masses between walls, equal springs: mode j has x_i = sin(i j π/(n+1)) and ω = 2 √(k/m) sin(j π/(2(n+1))). The last
// spring hangs between two points, the others along coordinates.
TEST(ClosedForm, spring_chain_swings_in_its_normal_modes) {
  const int n = 5;
  const double m = 0.75, k = 12, far = 10;
  Sample s = chain(std::vector(n, body(joint({}, {X}), m, {1, 1, 1}, 0)));
  for (int body = 1; body <= n; ++body) {
    scene::Load spring = joint_load(body, false);
    spring.stiffness = Number::constant(k);
    s.scene.loads.push_back(spring);
  }
  scene::Load last;
  last.kind = scene::Load::Kind::spring;
  last.point.body = n;
  last.other = {"", 0, constants(far, 0, 0)};
  last.stiffness = Number::constant(k);
  last.rest = Number::constant(far);
  s.scene.loads.push_back(last);
  for (int j = 1; j <= n; ++j) {
    const Real pi = std::numbers::pi_v<Real>, half = std::sin(j * pi / (2 * (n + 1)));
    const auto x = [&](int i) { return std::sin(i * j * pi / (n + 1)); };
    for (int i = 1; i <= n; ++i) s.x[i - 1] = x(i) - x(i - 1);
    EXPECT_LT(relative_error(s("accelerations"), -4 * Real(k / m) * half * half * s.x), 10 * rounding);
  }
}

// (I + m p²) θ̈ = -m g p.
TEST(ClosedForm, nut_runs_down_a_screw) {
  const double m = 0.5, I = 0.03125, pitch = 0.125;
  scene::Joint screw = joint({Z});
  screw.pitch = pitch;
  Sample s = chain({body(screw, m, {1, 1, I}, 0.25)});
  s.x << 2.0L;
  s.y << 3.0L;
  EXPECT_NEAR(double(s("accelerations")[0]), double(-m * Real(g) * pitch / (I + m * pitch * pitch)), 1e-15);
  EXPECT_NEAR(double(s("poses")[11]), 0.25 + 2 * pitch, 1e-15);
}

// θ = 0.5 t²: a flywheel needs I θ̈, the wall holds its weight.
TEST(ClosedForm, prescribed_flywheel_needs_its_torque_and_the_wall_its_weight) {
  using Kind = scene::ExpressionNode::Kind;
  const double m = 3, I = 0.25;
  scene::Joint shaft = joint({X});
  shaft.turns[0].motion = scene::Coordinate::Motion::prescribed;
  Sample s = chain({body(shaft, m, {I, 1, 1}, 0)});
  s.scene.expressions = {{"0.5*t*t",
                          {{.kind = Kind::number, .value = 0.5},
                           {.kind = Kind::time},
                           {.kind = Kind::multiply, .a = 0, .b = 1},
                           {.kind = Kind::multiply, .a = 2, .b = 1}}}};
  s.t = 1.5L;
  EXPECT_EQ(s.x.size(), 0);
  EXPECT_NEAR(double(s("driving_loads")[0]), I, 1e-17);
  EXPECT_NEAR(double(s("energy")[0]), 0.5 * I * 1.5 * 1.5, 1e-16);
  const Vector reaction = s("reactions");
  EXPECT_NEAR(double(reaction.head<3>().norm()), m * g, 1e-14);
  EXPECT_NEAR(double(reaction[3]), I, 1e-17);
}

TEST(ClosedForm, spring_between_coincident_points_does_nothing) {
  Sample s = chain({body(joint({}, {X, Y, Z}), 2, {1, 1, 1}, 0)});
  s.scene.gravity = {};
  scene::Load spring;
  spring.kind = scene::Load::Kind::spring;
  spring.point.body = 1;
  spring.stiffness = Number::constant(5);
  spring.rest = Number::constant(0.5);
  s.scene.loads = {spring};
  EXPECT_EQ(s("accelerations"), Vector::Zero(3));
}

// F = m a, r × F = I ω̇ at rest.
TEST(ClosedForm, force_at_a_point_turns_and_pushes) {
  Sample s = chain({body(scene::Joint(), 2, {1, 2, 4}, 0)});
  s.scene.gravity = {};
  s.x[3] = 1;
  scene::Load force;
  force.point = {"", 1, constants(0, 0, 0.5)};
  force.vector = constants(3, 0, 0);
  s.scene.loads = {force};
  EXPECT_LT(relative_error(s("accelerations"), Vector{{0, 0.75L, 0, 1.5L, 0, 0}}), rounding);
}

// A vector along X of each of the axes: with θ1 = θ2 = a quarter turn about Z, the lower body's X is the inertial Y,
// the body's X is the inertial -X. The second body is a free mass on two slides, so its sddot is F/m in the lower
// body's axes.
TEST(ClosedForm, loads_are_written_in_inertial_lower_or_body_axes) {
  const Real quarter = std::numbers::pi_v<Real> / 2;
  scene::Joint first = joint({Z});
  first.turns[0].motion = scene::Coordinate::Motion::locked;
  first.turns[0].value = std::numbers::pi / 2;
  Sample s = chain({body(first, 1, {1, 1, 1}, 0), body(joint({Z}, {X, Y}), 2, {1, 1, 1}, 0)});
  s.scene.gravity = {};
  s.x << quarter, 0, 0;
  scene::Load force;
  force.point.body = 2;
  force.vector = constants(6, 0, 0);
  const std::vector<std::pair<scene::Axes, Vector>> cases = {{scene::Axes::inertial, Vector{{0, 0, -3}}},
                                                             {scene::Axes::lower, Vector{{0, 3, 0}}},
                                                             {scene::Axes::body, Vector{{0, 0, 3}}}};
  for (const auto& [axes, expected] : cases) {
    force.axes = axes;
    s.scene.loads = {force};
    EXPECT_LT(relative_error(s("accelerations"), expected), 1e-15);  // the quarter turn that is locked is a double
  }
}

}  // namespace
}  // namespace kanec::generic
