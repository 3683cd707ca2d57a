// Oracle: published states of five trees, computed by another engine in other coordinates (tests/data).
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/reference.hpp"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#include "runtime/generic/evaluate.hpp"

namespace kanec::generic {
namespace {

using test::Converted;
using test::Reference;
using test::ReferenceState;

// One model in one scalar.
template <class Real>
class Model {
 public:
  explicit Model(const std::string& name)
      : reference_(test::read_reference(KANEC_SOURCE_DIR "/tests/data/reference_" + name + ".json")) {}

  const scene::Scene& scene() const { return reference_.scene; }
  const std::vector<ReferenceState>& states() const { return reference_.states; }
  Converted<Real> convert(const ReferenceState& state) const { return test::convert<Real>(scene(), state); }

  VectorX<Real> evaluate(const char* function, const Converted<Real>& at) const {
    const auto span = [](const VectorX<Real>& a) { return std::span(a.data(), static_cast<std::size_t>(a.size())); };
    const auto flat =
        generic::evaluate<Real>(system_, function, {0, span(at.x), span(at.y), span(at.ydot), span(at.u)});
    return Eigen::Map<const VectorX<Real>>(flat.data(), static_cast<Eigen::Index>(flat.size()));
  }

  // Joint velocities v to speeds: y = J v.
  MatrixX<Real> speeds_of_velocities(ReferenceState state) const {
    const auto n = static_cast<Eigen::Index>(state.v.size());
    MatrixX<Real> J(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      state.v.assign(state.v.size(), 0.0);
      state.v[static_cast<std::size_t>(i)] = 1;
      J.col(i) = convert(state).y;
    }
    return J;
  }

 private:
  Reference reference_;
  System<Real> system_{reference_.scene, {}};
};

// Largest difference over the largest published figure.
template <class Real>
double error(const VectorX<Real>& found, const VectorX<Real>& published) {
  return static_cast<double>((found - published).cwiseAbs().maxCoeff() / published.cwiseAbs().maxCoeff());
}
template <class Real>
double error(const VectorX<Real>& found, const std::vector<double>& published) {
  const auto n = static_cast<Eigen::Index>(published.size());
  return error<Real>(found, Eigen::Map<const Eigen::VectorXd>(published.data(), n).template cast<Real>());
}

template <class Real>
class ReferenceTest : public testing::Test {
 protected:
  // In double, the conversion, the sums and a factorisation of A with a condition number near 1e3 set the limit. In
  // long double it is the published figures' own rounding, 1.1e-16 of each, of which a result adds up to 36.
  static constexpr double tolerance = std::is_same_v<Real, double> ? 1e-12 : 3e-15;

  // Calls test(model, state) for each of the models' states.
  template <class Test>
  void for_states(Test test) const {
    for (const char* name : {"s6f", "s6b", "s6r", "cr7", "cb6"}) {
      SCOPED_TRACE(name);
      const Model<Real> model(name);
      ASSERT_EQ(model.states().size(), 3u);
      for (const ReferenceState& state : model.states()) test(model, state);
    }
  }
};

using Scalars = testing::Types<double, long double>;
TYPED_TEST_SUITE(ReferenceTest, Scalars);

TYPED_TEST(ReferenceTest, accelerations_are_the_published_ones) {
  this->for_states([this](const Model<TypeParam>& model, const ReferenceState& state) {
    const auto at = model.convert(state);
    EXPECT_LT(error<TypeParam>(model.evaluate("accelerations", at), at.ydot), this->tolerance);
  });
}

TYPED_TEST(ReferenceTest, residual_of_the_published_accelerations_vanishes) {
  this->for_states([this](const Model<TypeParam>& model, const ReferenceState& state) {
    const auto at = model.convert(state);
    const VectorX<TypeParam> f = model.evaluate("forcing", at), r = model.evaluate("residual", at);
    EXPECT_LT(error<TypeParam>(f + r, f), this->tolerance);
  });
}

// In joint coordinates: Jᵀ r with v̇ = 0 and no loads.
TYPED_TEST(ReferenceTest, residual_gives_the_published_bias) {
  this->for_states([this](const Model<TypeParam>& model, ReferenceState state) {
    state.vdot.assign(state.vdot.size(), 0.0);
    auto at = model.convert(state);
    at.u.setZero();
    const VectorX<TypeParam> bias = model.speeds_of_velocities(state).transpose() * model.evaluate("residual", at);
    EXPECT_LT(error<TypeParam>(bias, state.bias), this->tolerance);
  });
}

// In joint coordinates: Jᵀ A y.
TYPED_TEST(ReferenceTest, mass_matrix_gives_the_published_momenta) {
  this->for_states([this](const Model<TypeParam>& model, const ReferenceState& state) {
    const auto at = model.convert(state);
    const VectorX<TypeParam> A = model.evaluate("mass_matrix", at);
    const VectorX<TypeParam> Ay = Eigen::Map<const MatrixX<TypeParam>>(A.data(), at.y.size(), at.y.size()) * at.y;
    EXPECT_LT(error<TypeParam>(model.speeds_of_velocities(state).transpose() * Ay, state.momentum), this->tolerance);
  });
}

TYPED_TEST(ReferenceTest, energies_are_the_published_ones) {
  this->for_states([this](const Model<TypeParam>& model, const ReferenceState& state) {
    const VectorX<TypeParam> energy = model.evaluate("energy", model.convert(state));
    EXPECT_LT(error<TypeParam>(energy.head(1), std::vector{state.kinetic}), this->tolerance);
    EXPECT_LT(error<TypeParam>(energy.tail(1), std::vector{state.potential}), this->tolerance);
  });
}

// p = P + Rᵀ r with the published origins P; r is the same for each body of these models.
TYPED_TEST(ReferenceTest, poses_stand_on_the_published_origins) {
  using Rotation = Eigen::Matrix<TypeParam, 3, 3, Eigen::RowMajor>;
  this->for_states([this](const Model<TypeParam>& model, const ReferenceState& state) {
    const VectorX<TypeParam> poses = model.evaluate("poses", model.convert(state));
    const Vector3<TypeParam> r(TypeParam(0.1), TypeParam(0.2), TypeParam(0.05));
    VectorX<TypeParam> origins(poses.size() / 4);
    for (Eigen::Index k = 0; k < origins.size() / 3; ++k)
      origins.template segment<3>(3 * k) =
          poses.template segment<3>(12 * k + 9) - Eigen::Map<const Rotation>(poses.data() + 12 * k).transpose() * r;
    EXPECT_LT(error<TypeParam>(origins, state.origins), this->tolerance);
  });
}

}  // namespace
}  // namespace kanec::generic
