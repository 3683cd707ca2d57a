// Emitted derivatives of a stiff chain of 512 masses. Oracles: its exact modes; the same method with difference
// quotients.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "generator/read/read.hpp"
#include "generator/scene/component.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/model/model.hpp"
#include "runtime/run/needed_functions.hpp"
#include "runtime/study/hard/answer.hpp"
#include "tests/base/environment.hpp"

namespace kanec::hard::test {
namespace {

using integrate::JacobianChoice;

// As models/hard/stiff_chain, longer: rates up to 10^7 1/s.
std::string chain(int n) {
  std::string connection, bodies;
  for (int i = 0; i < n; ++i) {
    connection += (i == 0 ? "" : ", ") + std::to_string(i);
    bodies +=
        "[[body]]\njoint = 'prismatic'\naxis = 'x'\nmass = 1.0\ninertia = [0.0, 0.0, 0.0]\nstiffness = 'k'\n"
        "damping = 'c'\n[body.initial]\ns = " +
        std::string(i % 3 == 0 ? "-0.01\n" : "0.01\n");
  }
  return "name = 'long_chain'\nconnection = [" + connection + "]\n[parameters]\nk = 1e8\nc = 2.5e6\n" + bodies;
}

class LongChain : public testing::Test {
 protected:
  static integrate::Options settings() {
    integrate::Options options;
    options.method = integrate::Method::cvode_bdf;
    options.relative_tolerance = 1e-6;
    options.absolute_tolerance = 1e-10;
    options.duration = options.output_step = 0.05;
    return options;
  }

  Summary run(JacobianChoice jacobian, const Observer& observer = {}) {
    integrate::Options options = options_;
    options.jacobian = jacobian;
    return simulate(Solver(model_.library.abi()), scene::initial_coordinates(scene_), scene::initial_speeds(scene_),
                    options, observer);
  }

  kanec::test::Variable cache_{"KANEC_CACHE", KANEC_BINARY_DIR "/tests/hard_cache"};
  kanec::test::Variable flags_{"KANEC_CXXFLAGS", "-O0"};
  scene::Scene scene_ = scene::parse(chain(512), "long_chain.toml");
  integrate::Options options_ = settings();
  CompiledModel model_ = build(scene_, functions_to_integrate(scene_, options_), {});
};

// A Jacobian by differences takes 1024 evaluations, and BDF makes one in some 50 steps.
TEST_F(LongChain, emitted_jacobians_save_nineteen_evaluations_in_twenty) {
  const std::unique_ptr<Answer> modes = uniform_chain(scene_);
  const Summary emitted = run(JacobianChoice::sparse, [&](const Row& row) { modes->compare(row); });
  EXPECT_GT(emitted.jacobians, 0);
  for (const Deviation& deviation : modes->deviations()) EXPECT_LT(deviation.value, 1e-3) << deviation.what;
  const Summary differences = run(JacobianChoice::differences);
  EXPECT_EQ(differences.jacobians, 0);
  fmt::print("evaluations: {} and {}\n", emitted.evaluations, differences.evaluations);
  EXPECT_GE(differences.evaluations, 20 * emitted.evaluations);
}

}  // namespace
}  // namespace kanec::hard::test
