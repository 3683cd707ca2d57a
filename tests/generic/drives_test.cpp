// Driving loads and reactions. Oracles: the same scene with its locked and prescribed coordinates set free, whose
// residual has rows along them; Newton's and Euler's laws.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "tests/generic/sample.hpp"

namespace kanec::generic {
namespace {

using Three = Vector3<Real>;
using Rotation = Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>;
using Motion = scene::Coordinate::Motion;

// A sample with every coordinate free, in the state and with the speeds' rates that the locks and courses give; where
// the speeds of the sample, and those of what was driven, stand in it.
struct Freed {
  Sample s;
  std::vector<int> kept, driven;
};

scene::Scene free_scene(const scene::Scene& from) {
  scene::Scene scene = from;
  for (scene::Body& body : scene.bodies) {
    body.joint.held = false;
    for (auto* coordinates : {&body.joint.turns, &body.joint.slides})
      for (scene::Coordinate& coordinate : *coordinates) coordinate.motion = Motion::free;
  }
  const auto moved = [](int& index, const std::vector<std::string>& was, const std::vector<std::string>& is) {
    index = static_cast<int>(std::find(is.begin(), is.end(), was[static_cast<std::size_t>(index)]) - is.begin());
  };
  for (scene::Expression& expression : scene.expressions)
    for (scene::ExpressionNode& node : expression.nodes) {
      using Kind = scene::ExpressionNode::Kind;
      if (node.kind == Kind::coordinate)
        moved(node.index, scene::coordinate_names(from), scene::coordinate_names(scene));
      if (node.kind == Kind::speed) moved(node.index, scene::speed_names(from), scene::speed_names(scene));
    }
  return scene;
}

// Body by body, rotations before translations.
class Freeing {
 public:
  explicit Freeing(const Sample& s) : s_(s), was_(s.scene), is_(free_scene(s.scene)) {
    out_.s = s;
    out_.s.scene = free_scene(s.scene);
    out_.s.x = Vector::Zero(is_.nx);
    out_.s.y = out_.s.ydot = Vector::Zero(is_.ny);
    for (std::size_t k = 0; k < was_.bodies.size(); ++k) {
      const scene::Joint& joint = s.scene.bodies[k].joint;
      const scene::BodyLayout &was = was_.bodies[k], &is = is_.bodies[k];
      if (joint.ball) ball(was, is, s.scene.bodies[k].initial.eps);
      if (!joint.ball) scalars(joint.turns, was.theta, is.theta, was.thetadot, is.thetadot);
    }
    for (std::size_t k = 0; k < was_.bodies.size(); ++k)
      scalars(s.scene.bodies[k].joint.slides, was_.bodies[k].s, is_.bodies[k].s, was_.bodies[k].sdot,
              is_.bodies[k].sdot);
  }
  Freed out() const { return out_; }

 private:
  void ball(const scene::BodyLayout& was, const scene::BodyLayout& is, const std::array<double, 4>& eps) {
    auto to = out_.s.x.segment<4>(is.eps);
    to = Eigen::Map<const Eigen::Vector4d>(eps.data()).cast<Real>().normalized();
    if (was.eps >= 0) {
      to = s_.x.segment<4>(was.eps);
      out_.s.y.segment<3>(is.omega) = s_.y.segment<3>(was.omega);
      out_.s.ydot.segment<3>(is.omega) = s_.ydot.segment<3>(was.omega);
    }
    for (int i = 0; i < 3; ++i) (was.eps < 0 ? out_.driven : out_.kept).push_back(is.omega + i);
  }

  void scalars(const std::vector<scene::Coordinate>& coordinates, const std::vector<int>& x,
               const std::vector<int>& to_x, const std::vector<int>& y, const std::vector<int>& to_y) {
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      (y[i] < 0 ? out_.driven : out_.kept).push_back(to_y[i]);
      System<Real>::Course course = {coordinates[i].value, 0, 0};
      if (y[i] >= 0) course = {s_.x[x[i]], s_.y[y[i]], s_.ydot[y[i]]};
      if (coordinates[i].motion == Motion::prescribed)
        course = s_.system<Real>().course(coordinates[i].expression, s_.t);
      out_.s.x[to_x[i]] = course.value;
      out_.s.y[to_y[i]] = course.rate;
      out_.s.ydot[to_y[i]] = course.second_rate;
    }
  }

  const Sample& s_;
  scene::Layout was_, is_;
  Freed out_;
};

std::vector<Sample> driven_samples() {
  test::RandomSceneOptions options = test::everything();
  options.locked_share = options.prescribed_share = 0.25;
  return samples(options);
}

TEST(DrivingLoads, are_the_residual_along_the_coordinates_set_free) {
  Eigen::Index n_driven = 0;
  for (const Sample& s : driven_samples()) {
    const Freed freed = Freeing(s).out();
    const Vector r = freed.s("residual"), driving = s("driving_loads"), expected = r(freed.driven);
    ASSERT_EQ(driving.size(), expected.size());
    EXPECT_LE((driving - expected).norm(), 10 * rounding * r.norm());
    n_driven += driving.size();
  }
  EXPECT_GT(n_driven, 40);
}

TEST(Residual, along_the_free_coordinates_does_not_ask_why_the_others_move) {
  for (const Sample& s : driven_samples()) {
    const Freed freed = Freeing(s).out();
    const Vector r = freed.s("residual");
    EXPECT_LE((s("residual") - r(freed.kept)).norm(), 10 * rounding * r.norm());
  }
}

// What the joint of one body transmits, along its slides and its last turn, less the residual there.
class AlongCoordinates {
 public:
  explicit AlongCoordinates(const Sample& s)
      : s_(s), r_(s("residual")), reactions_(s("reactions")), poses_(s("poses")), layout_(s.scene) {}

  Real largest() const {
    Real error = 0;
    for (int k = 1; k <= scene::size(s_.scene); ++k) {
      const scene::Joint& joint = s_.scene.bodies[static_cast<std::size_t>(k - 1)].joint;
      error = std::max({error, joint.ball ? of_ball(k) : of_last_turn(k, joint), of_slides(k, joint)});
    }
    return error;
  }
  Real size() const { return 1 + reactions_.norm(); }

 private:
  const scene::BodyLayout& layout(int k) const { return layout_.bodies[static_cast<std::size_t>(k - 1)]; }
  Three force(int k) const { return reactions_.segment<3>(6 * (k - 1)); }
  Three moment(int k) const { return reactions_.segment<3>(6 * (k - 1) + 3); }
  Matrix3<Real> R(int k) const {
    return k == 0 ? Matrix3<Real>::Identity() : Matrix3<Real>(Eigen::Map<const Rotation>(poses_.data() + 12 * (k - 1)));
  }
  static Three axis(const scene::Axis& a) { return Three(a[0], a[1], a[2]).normalized(); }

  Real of_ball(int k) const { return (moment(k) - r_.segment<3>(layout(k).omega)).norm(); }

  // The last axis does not move against the body; a screw's turn translates too.
  Real of_last_turn(int k, const scene::Joint& joint) const {
    if (joint.turns.empty()) return 0;
    Matrix3<Real> zero;
    for (std::size_t i = 0; i < 9; ++i) zero(Eigen::Index(i) / 3, Eigen::Index(i) % 3) = joint.zero[i / 3][i % 3];
    const Three last = zero.inverse() * axis(joint.turns.back().axis);
    return std::abs(last.dot(moment(k)) + Real(joint.pitch) * last.dot(force(k)) - r_[layout(k).thetadot.back()]);
  }

  Real of_slides(int k, const scene::Joint& joint) const {
    const Three lower_force = R(s_.scene.lower[static_cast<std::size_t>(k - 1)]) * R(k).transpose() * force(k);
    Real error = 0;
    for (std::size_t i = 0; i < joint.slides.size(); ++i)
      error = std::max(error, std::abs(axis(joint.slides[i].axis).dot(lower_force) - r_[layout(k).sdot[i]]));
    return error;
  }

  const Sample& s_;
  Vector r_, reactions_, poses_;
  scene::Layout layout_;
};

// Without joint loads, what joints transmit along the coordinates is the residual.
TEST(Reactions, along_the_coordinates_are_the_residual) {
  test::RandomSceneOptions options = test::everything();
  options.springs = false;
  options.locked_share = options.prescribed_share = 0;
  for (const Sample& s : samples(options)) {
    const AlongCoordinates along(s);
    EXPECT_LT(along.largest(), 100 * rounding * along.size());
  }
}

// Scenes under gravity alone that fall, locked and driven in part; a held attitude would act from outside.
std::vector<Sample> falling_samples() {
  test::RandomSceneOptions options = test::everything();
  options.loads = options.springs = options.point_loads = false;
  std::vector<Sample> out;
  for (int n_bodies = 1; n_bodies <= 12; ++n_bodies) {
    test::Random random(static_cast<std::uint64_t>(n_bodies));
    scene::Scene scene = test::random_scene(random, n_bodies, options);
    for (scene::Body& body : scene.bodies) body.joint.held = false;
    scene.points.clear();
    for (int k = 1; k <= n_bodies; ++k) {
      const scene::Body& body = scene.bodies[static_cast<std::size_t>(k - 1)];
      scene.points.push_back({"centre_" + std::to_string(k), k, body.r});
      scene.points.push_back({"origin_" + std::to_string(k), k, {}});
    }
    out.push_back(sample(scene, random).falling());
  }
  return out;
}

// m a = m g + reaction - reactions of the bodies above.
TEST(Reactions, and_weight_accelerate_each_body) {
  for (const Sample& s : falling_samples()) {
    const Vector reactions = s("reactions"), poses = s("poses");
    std::vector<Three> force(s.scene.bodies.size() + 1, Three::Zero());
    for (int k = scene::size(s.scene); k >= 1; --k) {
      const auto index = static_cast<std::size_t>(k);
      const Three transmitted =
          Eigen::Map<const Rotation>(poses.data() + 12 * (k - 1)).transpose() * reactions.segment<3>(6 * (k - 1));
      force[index] += transmitted;
      force[static_cast<std::size_t>(s.scene.lower[index - 1])] -= transmitted;
    }
    for (int k = 1; k <= scene::size(s.scene); ++k) {
      const Real m = value(s, s.scene.bodies[static_cast<std::size_t>(k - 1)].mass);
      const Three a = s.rate("centre_" + std::to_string(k) + "_velocity");
      const Three expected = m * (a - values(s, s.scene.gravity));
      EXPECT_LT((force[static_cast<std::size_t>(k)] - expected).norm(),
                rounding_of_solve * (1 + double(reactions.norm())));
    }
  }
}

// d(momentum)/dt about the inertial origin from the weight and what the bodies on the inertial frame get from it.
TEST(Reactions, on_the_inertial_frame_balance_the_rate_of_momentum) {
  for (const Sample& s : falling_samples()) {
    const Vector reactions = s("reactions"), poses = s("poses"), rate = s.rate("momentum");
    Three force = Three::Zero(), moment = Three::Zero();
    const auto add = [&](const Three& at, const Three& F) { force += F, moment += at.cross(F); };
    for (int k = 1; k <= scene::size(s.scene); ++k) {
      const auto index = static_cast<std::size_t>(k - 1);
      const Real m = value(s, s.scene.bodies[index].mass);
      add(s("centre_" + std::to_string(k) + "_position"), m * values(s, s.scene.gravity));
      if (s.scene.lower[index] != 0) continue;
      const Matrix3<Real> R_T = Eigen::Map<const Rotation>(poses.data() + 12 * (k - 1)).transpose();
      add(s("origin_" + std::to_string(k) + "_position"), R_T * reactions.segment<3>(6 * (k - 1)));
      moment += R_T * reactions.segment<3>(6 * (k - 1) + 3);
    }
    const double tolerance = 10 * rounding_of_solve * (1 + double(reactions.norm()));
    EXPECT_LT((rate.head<3>() - force).norm(), tolerance);
    EXPECT_LT((rate.tail<3>() - moment).norm(), tolerance);
  }
}

// Each entry against the whole: the power of springs that have a potential is minus the potential's rate.
TEST(LoadPowers, and_power_differ_by_the_rate_of_the_springs_potential) {
  for (Sample s : samples(test::everything())) {
    const Real difference = s("load_powers").sum() - s("power")[0];
    s.scene.gravity = {};
    const Real expected = -s.rate("energy")[1];
    EXPECT_LT(std::abs(difference - expected), 10 * rounding * (1 + double(s("load_powers").cwiseAbs().sum())));
  }
}

}  // namespace
}  // namespace kanec::generic
