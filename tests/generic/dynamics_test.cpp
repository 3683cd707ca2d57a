// A, f, residual and accelerations. Oracles: definiteness, the kinetic energy, Newton's and Euler's laws body by body,
// and the laws of energy and momentum. SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "runtime/base/error.hpp"
#include "tests/generic/sample.hpp"

namespace kanec::generic {
namespace {

using Three = Vector3<Real>;

double value(const Sample& s, const scene::Number& number) {
  const auto index = static_cast<std::size_t>(number.index);
  switch (number.kind) {
    case scene::Number::Kind::parameter:
      return s.parameters[index];
    case scene::Number::Kind::input:
      return static_cast<double>(s.u[number.index]);
    default:
      return number.value;
  }
}

Three values(const Sample& s, const scene::Vector& a) { return {value(s, a[0]), value(s, a[1]), value(s, a[2])}; }

Matrix3<Real> inertia(const Sample& s, const scene::Symmetric& a) {
  Matrix3<Real> I;
  I << value(s, a.xx), value(s, a.xy), value(s, a.xz), value(s, a.xy), value(s, a.yy), value(s, a.yz), value(s, a.xz),
      value(s, a.yz), value(s, a.zz);
  return I;
}

// Force with weight (inertial axes) and moment (body axes) on each body, read from the scene here and nowhere else.
struct Loads {
  Three F, M;
};
std::vector<Loads> loads(const Sample& s) {
  std::vector<Loads> loads;
  for (const scene::Body& body : s.scene.bodies)
    loads.push_back(
        {values(s, body.force) + Real(value(s, body.mass)) * values(s, s.scene.gravity), values(s, body.moment)});
  return loads;
}

// The sample as it moves under its loads: coordinates and speeds with their rates.
struct Motion {
  System<Dual>::Vector x, y, u;
};
Motion motion(const Sample& s) {
  const System<Real> system = s.system<Real>();
  return {test::along<Real>(s.x, system.kinematics(s.x, s.y)),
          test::along<Real>(s.y, system.accelerations(s.x, s.y, s.u)),
          test::along<Real>(s.u, Vector::Zero(s.u.size()))};
}

TEST(MassMatrix, is_symmetric_and_positive_definite) {
  for (const Sample& s : samples()) {
    const Matrix A = s.system<Real>().mass_matrix(s.x);
    EXPECT_LT(relative_error(A, A.transpose()), rounding);
    const Vector eigenvalues = A.selfadjointView<Eigen::Lower>().eigenvalues();  // ascending
    EXPECT_GT(eigenvalues[0], 0);
    EXPECT_LT(eigenvalues[eigenvalues.size() - 1], 1e4L * eigenvalues[0]);  // so that tolerances on ẏ can be tight
  }
}

// Kinetic energy from ṗ and ω of each body; ṗ by differentiation of p.
TEST(MassMatrix, gives_the_kinetic_energy) {
  for (const Sample& s : samples()) {
    const auto moving = s.system<Dual>().poses(motion(s).x);
    Real kinetic = 0;
    for (std::size_t k = 0; k < moving.size(); ++k) {
      const Three omega = s.y.segment<3>(3 * static_cast<Eigen::Index>(k));
      const scene::Body& body = s.scene.bodies[k];
      kinetic += 0.5L * value(s, body.mass) * test::rates(moving[k].p).squaredNorm();
      kinetic += 0.5L * omega.dot(inertia(s, body.inertia) * omega);
    }
    const Real by_matrix = 0.5L * s.y.dot(s.system<Real>().mass_matrix(s.x) * s.y);
    EXPECT_LT(std::abs(by_matrix / kinetic - 1), rounding);
    EXPECT_LT(std::abs(s.system<Real>().energy(s.x, s.y).kinetic / kinetic - 1), rounding);
  }
}

TEST(Residual, is_mass_matrix_times_rates_less_forcing) {
  for (const Sample& s : samples()) {
    const System<Real> system = s.system<Real>();
    const Vector expected = system.mass_matrix(s.x) * s.ydot - system.forcing(s.x, s.y, s.u);
    EXPECT_LT(relative_error(system.residual(s.x, s.y, s.ydot, s.u), expected), rounding);
  }
}

TEST(Residual, undoes_accelerations) {
  for (const Sample& s : samples()) {
    const System<Real> system = s.system<Real>();
    const Vector ydot = system.accelerations(s.x, s.y, s.u);
    const Vector f = system.forcing(s.x, s.y, s.u);
    // backward stable: the residual is some hundred roundings of A ẏ, which has the size of f
    EXPECT_LT(relative_error(f + system.residual(s.x, s.y, ydot, s.u), f), rounding);
  }
}

// A joint with six degrees of freedom transmits nothing, so each body moves as if alone: m p̈ = F, I ω̇ + ω × I ω = M.
TEST(Accelerations, move_each_body_by_the_laws_of_newton_and_euler) {
  for (const Sample& s : samples()) {
    const Motion along = motion(s);
    const System<Dual>::Vector v = s.system<Dual>().partial_velocities(along.x) * along.y;
    const std::vector<Loads> on = loads(s);
    for (int k = 0; k < scene::size(s.scene); ++k) {
      const auto index = static_cast<std::size_t>(k);
      const scene::Body& body = s.scene.bodies[index];
      const Three acceleration = test::rates(v.segment<3>(3 * k));
      EXPECT_LT(relative_error(value(s, body.mass) * acceleration, on[index].F), rounding_of_solve);
      const Three omega = s.y.segment<3>(3 * k), omegadot = test::rates(along.y.segment<3>(3 * k));
      const Matrix3<Real> I = inertia(s, body.inertia);
      EXPECT_LT(relative_error(I * omegadot + omega.cross(I * omega), on[index].M), rounding_of_solve);
    }
  }
}

// d(kinetic + potential)/dt = power of the applied loads.
TEST(Energy, changes_at_the_rate_of_the_power) {
  for (const Sample& s : samples()) {
    const Motion along = motion(s);
    const Energy<Dual> energy = s.system<Dual>().energy(along.x, along.y);
    const Real power = s.system<Real>().power(s.x, s.y, s.u);
    const Real scale = std::abs(energy.kinetic.rate) + std::abs(energy.potential.rate);
    EXPECT_LT(std::abs(energy.kinetic.rate + energy.potential.rate - power), rounding_of_solve * scale);
    EXPECT_GT(std::abs(power), 1e-3L * scale);  // else nothing was tested
  }
}

// d(linear)/dt = Σ F, d(angular)/dt = Σ (p × F + Rᵀ M), weight included.
TEST(Momentum, changes_at_the_rate_of_forces_and_moments) {
  for (const Sample& s : samples()) {
    const Motion along = motion(s);
    const Momentum<Dual> momentum = s.system<Dual>().momentum(along.x, along.y);
    const auto poses = s.system<Real>().poses(s.x);
    const std::vector<Loads> on = loads(s);
    Three force = Three::Zero(), moment = Three::Zero();
    for (std::size_t k = 0; k < on.size(); ++k) {
      force += on[k].F;
      moment += poses[k].p.cross(on[k].F) + poses[k].R.transpose() * on[k].M;
    }
    EXPECT_LT(relative_error(test::rates(momentum.linear), force), rounding_of_solve);
    EXPECT_LT(relative_error(test::rates(momentum.angular), moment), rounding_of_solve);
  }
}

TEST(Momentum, and_energy_are_kept_without_loads_and_gravity) {
  test::RandomSceneOptions free;
  free.gravity = false;
  free.loads = false;
  for (const Sample& s : samples(free)) {
    const Motion along = motion(s);
    const Momentum<Dual> momentum = s.system<Dual>().momentum(along.x, along.y);
    // each rate is a sum of terms as large as A ẏ
    const Real scale = test::rates(along.y).cwiseAbs().maxCoeff();
    EXPECT_LT(test::rates(momentum.linear).norm(), rounding_of_solve * scale);
    EXPECT_LT(test::rates(momentum.angular).norm(), rounding_of_solve * scale);
    EXPECT_LT(std::abs(s.system<Dual>().energy(along.x, along.y).kinetic.rate), rounding_of_solve * scale);
    EXPECT_EQ(s.system<Real>().power(s.x, s.y, s.u), 0);
    EXPECT_GT(scale, 1);  // bodies that tumble do accelerate relative to each other
  }
}

// Parameters and inputs give what constants of their values give.
TEST(System, reads_parameters_and_inputs_as_the_numbers_they_stand_for) {
  test::RandomSceneOptions open;
  open.parameter_share = 1;
  open.input_share = 0;
  test::Random first(31), second(31);
  const scene::Scene constant = test::random_scene(first, 5), named = test::random_scene(second, 5, open);
  ASSERT_TRUE(constant.parameters.empty());
  ASSERT_FALSE(named.parameters.empty());
  const Sample s = sample(constant, first);
  const System<Real> a(constant, {}), b(named, scene::default_parameters(named));
  EXPECT_EQ(a.residual(s.x, s.y, s.ydot, s.u), b.residual(s.x, s.y, s.ydot, s.u));
  EXPECT_EQ(a.power(s.x, s.y, s.u), b.power(s.x, s.y, s.u));
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
              testing::ThrowsMessage<InternalError>(testing::HasSubstr("an input stands where only loads may vary")));
}

TEST(Accelerations, refuse_a_mass_matrix_that_is_not_positive_definite) {
  scene::Scene scene;
  scene.name = "nothing";
  scene.lower = {0};
  scene.bodies.resize(1);  // without mass
  const System<double> system(scene, {});
  Eigen::VectorXd x = Eigen::VectorXd::Zero(7);
  x[3] = 1;
  const Eigen::VectorXd y = Eigen::VectorXd::Zero(6), u;
  EXPECT_THAT([&] { system.accelerations(x, y, u); },
              testing::ThrowsMessage<InputError>(
                  "scene nothing: the mass matrix is not positive definite with these parameters"));
}

}  // namespace
}  // namespace kanec::generic
