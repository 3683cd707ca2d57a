// The program of the six-body tree. Oracle: published states computed by another engine in other coordinates
// (tests/data), converted.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/support/reference.hpp"

#include <gtest/gtest.h>

#include "tests/lower/sample.hpp"

namespace kanec::test {
namespace {

// The conversion and some hundred operations in double, each off by 1.1e-16, on sums that cancel to a tenth.
constexpr double tolerance = 1e-12;

class ReferenceProgram : public testing::Test {
 protected:
  using Vector = std::vector<double>;

  static Vector list(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

  // Calls test(published state, arguments of the program with its accelerations and loads).
  template <class Test>
  void for_states(Test test) const {
    ASSERT_EQ(reference.states.size(), 3u);
    for (const ReferenceState& state : reference.states) {
      const Converted<double> at = convert<double>(reference.scene, state);
      test(state, program::Arguments<double>{{}, list(at.x), list(at.y), list(at.ydot), list(at.u)});
    }
  }

  Vector evaluate(const char* name, const program::Arguments<double>& arguments) const {
    for (const program::Function& function : program.functions)
      if (function.name == name) return program::evaluate(program, function, arguments);
    throw std::out_of_range(name);
  }

  const Reference reference = read_reference(KANEC_SOURCE_DIR "/tests/data/reference_s6f.json");
  const program::Program program = program_of(reference.scene);
};

TEST_F(ReferenceProgram, accelerations_are_the_published_ones) {
  for_states([this](const ReferenceState&, const program::Arguments<double>& at) {
    EXPECT_LT(relative_difference(evaluate("accelerations", at), as<long double>(at.ydot)), tolerance);
  });
}

TEST_F(ReferenceProgram, residual_of_the_published_accelerations_vanishes) {
  for_states([this](const ReferenceState&, const program::Arguments<double>& at) {
    const Vector f = evaluate("forcing", at);
    Vector sum = evaluate("residual", at);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += f[i];
    EXPECT_LT(relative_difference(sum, as<long double>(f)), tolerance);
  });
}

TEST_F(ReferenceProgram, mass_matrix_times_the_published_accelerations_is_the_forcing) {
  for_states([this](const ReferenceState&, const program::Arguments<double>& at) {
    const Vector A = evaluate("mass_matrix", at);
    Vector product(at.ydot.size(), 0.0);
    for (std::size_t i = 0; i < product.size(); ++i)
      for (std::size_t j = 0; j < product.size(); ++j) product[i] += A[i * product.size() + j] * at.ydot[j];
    EXPECT_LT(relative_difference(product, as<long double>(evaluate("forcing", at))), tolerance);
  });
}

TEST_F(ReferenceProgram, energies_are_the_published_ones) {
  for_states([this](const ReferenceState& state, const program::Arguments<double>& at) {
    const Vector energy = evaluate("energy", at);
    EXPECT_NEAR(energy[0] / state.kinetic, 1, tolerance);
    EXPECT_NEAR(energy[1] / state.potential, 1, tolerance);
  });
}

// p = P + R^T r with the published origins P; r is the same for each body of this model.
TEST_F(ReferenceProgram, poses_stand_on_the_published_origins) {
  for_states([this](const ReferenceState& state, const program::Arguments<double>& at) {
    const Vector poses = evaluate("poses", at);
    const double r[] = {0.1, 0.2, 0.05};
    Vector origins;
    for (std::size_t k = 0; k < 6; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        double P = poses[12 * k + 9 + i];
        for (std::size_t j = 0; j < 3; ++j) P -= poses[12 * k + 3 * j + i] * r[j];
        origins.push_back(P);
      }
    EXPECT_LT(relative_difference(origins, as<long double>(state.origins)), tolerance);
  });
}

}  // namespace
}  // namespace kanec::test
