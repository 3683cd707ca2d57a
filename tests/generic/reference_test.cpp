// Oracle: published states of the six-body tree, computed by another engine in other coordinates (tests/data).
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "runtime/generic/system.hpp"

namespace kanec::generic {
namespace {

using test::Converted;
using test::Reference;
using test::ReferenceState;

template <class Real>
class ReferenceTest : public testing::Test {
 protected:
  using Vector = typename System<Real>::Vector;
  using Matrix = typename System<Real>::Matrix;

  // Joint velocities v to speeds: y = J v.
  Matrix speeds_of_velocities(ReferenceState state) const {
    const auto n = static_cast<Eigen::Index>(state.v.size());
    Matrix J(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      state.v.assign(state.v.size(), 0.0);
      state.v[static_cast<std::size_t>(i)] = 1;
      J.col(i) = test::convert<Real>(reference.scene, state).y;
    }
    return J;
  }

  static double relative_error(const Vector& left, const std::vector<double>& published) {
    const Vector right = Eigen::Map<const Eigen::VectorXd>(published.data(), left.size()).template cast<Real>();
    return relative_error(left, right);
  }
  static double relative_error(const Vector& left, const Vector& right) {
    return static_cast<double>((left - right).cwiseAbs().maxCoeff() / right.cwiseAbs().maxCoeff());
  }

  // In double, the conversion, the sums and a factorisation of A with a condition number near 1e3 set the limit. In
  // long double it is the published figures' own rounding, 1.1e-16 of each, of which a result adds up to 36.
  static constexpr double tolerance = std::is_same_v<Real, double> ? 1e-12 : 3e-15;

  const Reference reference = test::read_reference(KANEC_SOURCE_DIR "/tests/data/reference_s6f.json");
  const System<Real> system{reference.scene, {}};
};

using Scalars = testing::Types<double, long double>;
TYPED_TEST_SUITE(ReferenceTest, Scalars);

TYPED_TEST(ReferenceTest, holds_three_states_of_six_bodies) {
  ASSERT_EQ(this->reference.states.size(), 3u);
  EXPECT_EQ(this->reference.scene.lower, (std::vector<int>{0, 1, 2, 2, 1, 5}));
}

TYPED_TEST(ReferenceTest, accelerations_are_the_published_ones) {
  for (const ReferenceState& state : this->reference.states) {
    const auto at = test::convert<TypeParam>(this->reference.scene, state);
    const auto ydot = this->system.accelerations(at.x, at.y, at.u);
    EXPECT_LT(this->relative_error(ydot, at.ydot), this->tolerance);
  }
}

TYPED_TEST(ReferenceTest, residual_of_the_published_accelerations_vanishes) {
  for (const ReferenceState& state : this->reference.states) {
    const auto at = test::convert<TypeParam>(this->reference.scene, state);
    const typename TestFixture::Vector f = this->system.forcing(at.x, at.y, at.u);
    const typename TestFixture::Vector r = this->system.residual(at.x, at.y, at.ydot, at.u);
    EXPECT_LT(this->relative_error(f + r, f), this->tolerance);
  }
}

// In joint coordinates: Jᵀ r with v̇ = 0 and no loads.
TYPED_TEST(ReferenceTest, residual_gives_the_published_bias) {
  for (ReferenceState state : this->reference.states) {
    state.vdot.assign(state.vdot.size(), 0.0);
    const auto at = test::convert<TypeParam>(this->reference.scene, state);
    const typename TestFixture::Vector no_loads = TestFixture::Vector::Zero(at.u.size());
    const auto r = this->system.residual(at.x, at.y, at.ydot, no_loads);
    EXPECT_LT(this->relative_error(this->speeds_of_velocities(state).transpose() * r, state.bias), this->tolerance);
  }
}

// In joint coordinates: Jᵀ A y.
TYPED_TEST(ReferenceTest, mass_matrix_gives_the_published_momenta) {
  for (const ReferenceState& state : this->reference.states) {
    const auto at = test::convert<TypeParam>(this->reference.scene, state);
    const typename TestFixture::Vector Ay = this->system.mass_matrix(at.x) * at.y;
    EXPECT_LT(this->relative_error(this->speeds_of_velocities(state).transpose() * Ay, state.momentum),
              this->tolerance);
  }
}

TYPED_TEST(ReferenceTest, energies_are_the_published_ones) {
  for (const ReferenceState& state : this->reference.states) {
    const auto at = test::convert<TypeParam>(this->reference.scene, state);
    const Energy<TypeParam> energy = this->system.energy(at.x, at.y);
    EXPECT_LT(std::abs(energy.kinetic / TypeParam(state.kinetic) - 1), this->tolerance);
    EXPECT_LT(std::abs(energy.potential / TypeParam(state.potential) - 1), this->tolerance);
  }
}

// p = P + Rᵀ r with the published origins P; r is the same for each body of this model.
TYPED_TEST(ReferenceTest, poses_stand_on_the_published_origins) {
  for (const ReferenceState& state : this->reference.states) {
    const auto at = test::convert<TypeParam>(this->reference.scene, state);
    typename TestFixture::Vector origins(18);
    Eigen::Index row = 0;
    for (const Pose<TypeParam>& pose : this->system.poses(at.x)) {
      const Vector3<TypeParam> r(TypeParam(0.1), TypeParam(0.2), TypeParam(0.05));
      origins.template segment<3>(row) = pose.p - pose.R.transpose() * r;
      row += 3;
    }
    EXPECT_LT(this->relative_error(origins, state.origins), this->tolerance);
  }
}

}  // namespace
}  // namespace kanec::generic
