// A, f, residual and accelerations. Oracles: definiteness, the kinetic energy, Newton's and Euler's laws body by body,
// and the laws of energy and momentum.
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "runtime/base/error.hpp"
#include "runtime/generic/expression.hpp"
#include "tests/generic/sample.hpp"

namespace kanec::generic {
namespace {

using Three = Vector3<Real>;

// Force with weight (inertial axes) and moment (body axes) on each body, read from the scene here and nowhere else.
struct Loads {
  Three F, M;
};
std::vector<Loads> loads(const Sample& s) {
  std::vector<Loads> loads;
  for (const scene::Body& body : s.scene.bodies)
    loads.push_back({values(s, body.force) + value(s, body.mass) * values(s, s.scene.gravity), values(s, body.moment)});
  return loads;
}

TEST(MassMatrix, is_symmetric_and_positive_definite) {
  for (const Sample& s : samples()) {
    const Eigen::Index n = s.y.size();
    const Matrix A = s.matrix("mass_matrix", n);
    if (n == 0) continue;
    EXPECT_LT(relative_error(A, A.transpose()), rounding);
    const Vector eigenvalues = A.selfadjointView<Eigen::Lower>().eigenvalues();  // ascending
    EXPECT_GT(eigenvalues[0], 0);
    EXPECT_LT(eigenvalues[n - 1], 1e4L * eigenvalues[0]);  // so that tolerances on ẏ can be tight
  }
}

// From ṗ and Ṙ of each body by differentiation: ω̃ = -Ṙ Rᵀ.
Real kinetic_energy(const Sample& s) {
  using Map = Eigen::Map<const Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>>;
  const Vector poses = s("poses"), moving = s.rate("poses");
  Real kinetic = 0;
  for (Eigen::Index k = 0; k < scene::size(s.scene); ++k) {
    const scene::Body& body = s.scene.bodies[static_cast<std::size_t>(k)];
    const Matrix3<Real> omega_skew = -Map(moving.data() + 12 * k) * Map(poses.data() + 12 * k).transpose();
    const Three omega(omega_skew(2, 1), omega_skew(0, 2), omega_skew(1, 0));
    kinetic += 0.5L * value(s, body.mass) * moving.segment<3>(12 * k + 9).squaredNorm();
    kinetic += 0.5L * omega.dot(inertia(s, body.inertia) * omega);
  }
  return kinetic;
}

TEST(Energy, is_that_of_the_moving_bodies) {
  for (const Sample& s : samples()) {
    const Real kinetic = kinetic_energy(s);
    EXPECT_LT(std::abs(s("energy")[0] - kinetic), 10 * rounding * kinetic);
  }
}

TEST(MassMatrix, gives_the_kinetic_energy_where_nothing_is_prescribed) {
  test::RandomSceneOptions options = test::everything();
  options.prescribed_share = 0;
  for (const Sample& s : samples(options)) {
    const Real by_matrix = 0.5L * s.y.dot(s.matrix("mass_matrix", s.y.size()) * s.y);
    EXPECT_LT(std::abs(by_matrix - s("energy")[0]), 10 * rounding * by_matrix);
  }
}

TEST(Residual, is_mass_matrix_times_rates_less_forcing) {
  for (const Sample& s : samples()) {
    const Vector A_ydot = s.matrix("mass_matrix", s.y.size()) * s.ydot, f = s("forcing");
    const double size = 1 + double(A_ydot.norm() + f.norm());
    EXPECT_LT((s("residual") - (A_ydot - f)).norm(), rounding * size);
  }
}

TEST(Residual, undoes_accelerations) {
  for (const Sample& s : samples()) {
    const Vector f = s("forcing");
    // backward stable: the residual is some hundred roundings of A ẏ, which has the size of f
    EXPECT_LE(s.falling()("residual").norm(), 10 * rounding * f.norm());
  }
}

// A joint with six degrees of freedom transmits nothing, so each body moves as if alone: m p̈ = F, I ω̇ + ω × I ω = M.
TEST(Accelerations, move_each_free_body_by_the_laws_of_newton_and_euler) {
  for (const Sample& s : free_samples()) {
    const Sample falling = s.falling();
    const Eigen::Index rows = 3 * scene::size(s.scene);
    const Vector acceleration =
        s.matrix("partial_velocities", rows) * falling.ydot + s.matrix("partial_velocity_rates", rows) * s.y;
    const std::vector<Loads> on = loads(s);
    for (int k = 0; k < scene::size(s.scene); ++k) {
      const auto index = static_cast<std::size_t>(k);
      const scene::Body& body = s.scene.bodies[index];
      EXPECT_LT(relative_error(value(s, body.mass) * acceleration.segment<3>(3 * k), on[index].F), rounding_of_solve);
      const Three omega = s.y.segment<3>(3 * k), omegadot = falling.ydot.segment<3>(3 * k);
      const Matrix3<Real> I = inertia(s, body.inertia);
      EXPECT_LT(relative_error(I * omegadot + omega.cross(I * omega), on[index].M), rounding_of_solve);
    }
  }
}

// The rate of a coordinate's prescribed course, else zero: in the order of driving_loads, by dual numbers.
class DrivenRates {
 public:
  explicit DrivenRates(const Sample& s) : s_(s) {
    for (const scene::Body& body : s.scene.bodies) {
      if (body.joint.ball && body.joint.held) rates_.insert(rates_.end(), 3, 0);
      if (!body.joint.ball) append(body.joint.turns);
    }
    for (const scene::Body& body : s.scene.bodies) append(body.joint.slides);
  }
  Vector vector() const { return Eigen::Map<const Vector>(rates_.data(), static_cast<Eigen::Index>(rates_.size())); }

 private:
  void append(const std::vector<scene::Coordinate>& coordinates) {
    using Motion = scene::Coordinate::Motion;
    for (const scene::Coordinate& one : coordinates)
      if (one.motion != Motion::free) rates_.push_back(one.motion == Motion::locked ? 0 : rate(one.expression));
  }
  Real rate(int expression) const {
    const auto leaf = [&](const scene::ExpressionNode& node) {
      return node.kind == scene::ExpressionNode::Kind::time
                 ? Dual<Real>(s_.t, 1)
                 : Dual<Real>(s_.parameters[static_cast<std::size_t>(node.index)]);
    };
    return value_of<Dual<Real>>(s_.scene.expressions[static_cast<std::size_t>(expression)], leaf).rate;
  }
  const Sample& s_;
  std::vector<Real> rates_;
};

// d(kinetic + potential)/dt = power of the applied loads + that of the loads that drive prescribed coordinates.
TEST(Energy, changes_at_the_rate_of_the_power) {
  for (const Sample& s : samples()) {
    const Sample falling = s.falling();
    const Vector rate = falling.rate("energy");
    const Real power = s("power")[0], driving = falling("driving_loads").dot(DrivenRates(s).vector());
    const Real scale = std::abs(rate[0]) + std::abs(rate[1]) + std::abs(power) + std::abs(driving);
    EXPECT_LT(std::abs(rate.sum() - power - driving), rounding_of_solve * scale);
    EXPECT_GT(std::abs(power), 1e-3L * scale);  // else nothing was tested
  }
}

// d(linear)/dt = Σ F, d(angular)/dt = Σ (p × F + Rᵀ M), weight included.
TEST(Momentum, changes_at_the_rate_of_forces_and_moments) {
  using Map = Eigen::Map<const Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>>;
  for (const Sample& s : free_samples()) {
    const Vector rate = s.falling().rate("momentum"), poses = s("poses");
    const std::vector<Loads> on = loads(s);
    Three force = Three::Zero(), moment = Three::Zero();
    for (std::size_t k = 0; k < on.size(); ++k) {
      const Real* pose = poses.data() + 12 * k;
      force += on[k].F;
      moment += Three(Eigen::Map<const Three>(pose + 9)).cross(on[k].F) + Map(pose).transpose() * on[k].M;
    }
    EXPECT_LT(relative_error(rate.head<3>(), force), rounding_of_solve);
    EXPECT_LT(relative_error(rate.tail<3>(), moment), rounding_of_solve);
  }
}

// Nothing acts from outside: no gravity, a free first body, no held attitudes, every load with its reaction.
scene::Scene left_alone(test::Random& random, int n_bodies) {
  test::RandomSceneOptions options = test::everything();
  options.forest = options.gravity = options.loads = false;
  scene::Scene scene = test::random_scene(random, n_bodies, options);
  scene.bodies[0].joint = scene::Joint();
  for (scene::Body& body : scene.bodies) body.joint.held = false;
  std::erase_if(scene.loads, [](const scene::Load& load) {
    using Kind = scene::Load::Kind;
    const bool acts_alone =
        load.kind == Kind::spring ? load.other.body == 0 || load.point.body == 0 : load.reaction <= 0;
    return load.kind == Kind::joint ? load.point.body == 1 : acts_alone;
  });
  // what the expressions read has moved; time is always there
  for (scene::Expression& expression : scene.expressions)
    for (scene::ExpressionNode& node : expression.nodes)
      if (node.kind == scene::ExpressionNode::Kind::coordinate || node.kind == scene::ExpressionNode::Kind::speed)
        node.kind = scene::ExpressionNode::Kind::time;
  return scene;
}

TEST(Momentum, is_kept_where_nothing_acts_from_outside) {
  for (int n_bodies = 2; n_bodies <= 12; ++n_bodies) {
    test::Random random(static_cast<std::uint64_t>(n_bodies));
    const scene::Scene scene = left_alone(random, n_bodies);
    const Sample falling = sample(scene, random).falling();
    // each rate is a sum of terms as large as A ẏ
    const Real scale = 10 + (falling.matrix("mass_matrix", falling.y.size()) * falling.ydot).norm();
    EXPECT_LT(falling.rate("momentum").norm(), rounding_of_solve * scale);
  }
}

TEST(Momentum, and_energy_of_free_bodies_are_kept_without_loads_and_gravity) {
  test::RandomSceneOptions free;
  free.gravity = false;
  free.loads = false;
  for (const Sample& s : samples(free)) {
    const Sample falling = s.falling();
    // each rate is a sum of terms as large as A ẏ
    const Real scale = falling.ydot.cwiseAbs().maxCoeff();
    EXPECT_LT(falling.rate("momentum").norm(), rounding_of_solve * scale);
    EXPECT_LT(std::abs(falling.rate("energy")[0]), rounding_of_solve * scale);
    EXPECT_EQ(s("power")[0], 0);
    EXPECT_GT(scale, 1);  // bodies that tumble do accelerate relative to each other
  }
}

// Parameters and inputs give what constants of their values give.
TEST(System, reads_parameters_and_inputs_as_the_numbers_they_stand_for) {
  test::Random first(31), second(31);
  const scene::Scene constant = test::random_scene(first, 5),
                     named = test::random_scene(second, 5, {.parameter_share = 1});
  ASSERT_TRUE(constant.parameters.empty());
  ASSERT_FALSE(named.parameters.empty());
  const Sample a = sample(constant, first);
  Sample b = a;
  b.scene = named;
  b.parameters = scene::default_parameters(named);
  EXPECT_EQ(a("residual"), b("residual"));
  EXPECT_EQ(a("power"), b("power"));
}

TEST(System, refuses_a_wrong_number_of_parameters) {
  scene::Scene scene;
  scene.name = "pair";
  scene.parameters = {{"a", 1}, {"b", 2}};
  const std::vector<double> one = {1};
  EXPECT_THAT([&] { System<double>(scene, one); },
              testing::ThrowsMessage<InputError>("scene pair: 1 parameters given, 2 needed"));
}

TEST(System, refuses_an_input_that_is_no_load) {
  scene::Scene scene;
  scene.lower = {0};
  scene.bodies.resize(1);
  scene.inputs = {{"m", 1}};
  scene.bodies[0].mass = scene::Number::input(0);
  EXPECT_THAT([&] { System<double>(scene, {}); },
              testing::ThrowsMessage<InternalError>(testing::HasSubstr("stands where only loads may vary")));
}

TEST(Accelerations, refuse_a_mass_matrix_that_is_not_positive_definite) {
  scene::Scene scene;
  scene.name = "nothing";
  scene.lower = {0};
  scene.bodies.resize(1);  // without mass
  const System<double> system(scene, {});
  const std::vector<double> x = {0, 0, 0, 1, 0, 0, 0}, y(6);
  EXPECT_THAT([&] { evaluate(system, "accelerations", {.x = x, .y = y}); },
              testing::ThrowsMessage<InputError>(
                  "scene nothing: the mass matrix is not positive definite with these parameters"));
}

}  // namespace
}  // namespace kanec::generic
