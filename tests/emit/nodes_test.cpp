// Emitted code of programs with every kind of node, and what a header says besides. Oracles: the program evaluated
// operation by operation, the ledger, and rules on the text.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "generator/emit/header.hpp"
#include "generator/program/ledger.hpp"
#include "runtime/base/process.hpp"
#include "tests/emit/driver.hpp"
#include "tests/emit/every_node.hpp"

namespace kanec::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class EveryNode : public testing::Test {
 protected:
  template <class T>
  std::vector<T> expected(const program::Function& function) const {
    program::Arguments<T> at = arguments<T>(sample);
    at.time = Driver::time;
    return evaluate(generated.program, function, at);
  }

  const Sample sample = every_node_sample();
  const Generated generated = every_node_model(sample.scene);
};

TEST_F(EveryNode, gives_the_values_of_the_program_in_every_scalar_at_the_cost_of_its_ledger) {
  Driver driver(sample, generated);
  ASSERT_EQ(driver.compile("g++", {"-O0", "-ffp-contract=off", "-DKANEC_LIBM_COS_SIN"},
                           {"float", "double", "long double", "counted"}),
            "");
  driver.run();
  expect_counts(driver.counts("prepare"), program::prepare_ledger(generated.program));
  for (const program::Function& function : generated.program.functions) {
    SCOPED_TRACE(function.name);
    const std::vector<long double> wanted = expected<long double>(function);
    const std::vector<double> in_double = expected<double>(function);
    EXPECT_EQ(driver.results<double>("double", function.name), in_double);
    // the long double functions of the library differ in their last bit from compiler to compiler
    EXPECT_LT(relative_difference(driver.results<long double>("long double", function.name), wanted), 1e-17);
    EXPECT_LT(relative_difference(driver.results<double>("float", function.name), wanted), 1e-5);  // 6e-8 a rounding
    // of the Jacobian the ledger is an upper bound: a derivative that is not selected may not be computed
    if (function.name != "every_x")
      expect_counts(driver.counts(function.name), program::ledger(generated.program, function));
  }
}

TEST_F(EveryNode, of_long_functions_stands_in_pieces_that_take_time_inputs_and_every_result) {
  const Generated longer = every_node_model(sample.scene, 180);
  ASSERT_THAT(longer.header, HasSubstr("every_and_still_pieces::piece_2(c, t, x, y, u, out, out_still, shared);"));
  Driver driver(sample, longer);
  ASSERT_EQ(driver.compile("g++", {"-O0", "-ffp-contract=off", "-DKANEC_LIBM_COS_SIN"}, {"double"}), "");
  driver.run();
  program::Arguments<double> at = arguments<double>(sample);
  at.time = Driver::time;
  for (const program::Function& function : longer.program.functions)
    EXPECT_EQ(driver.results<double>("double", function.name), evaluate(longer.program, function, at)) << function.name;
}

TEST_F(EveryNode, compiles_without_a_warning_of_clang) {
  if (!find_program("clang++")) GTEST_SKIP() << "clang++ is not installed";
  Driver driver(sample, generated);
  EXPECT_EQ(driver.compile("clang++", {"-fsyntax-only"}, {"float", "double", "long double", "counted"}), "");
}

TEST_F(EveryNode, takes_time_and_inputs_where_it_reads_them_whatever_its_signature_says) {
  EXPECT_THAT(generated.header, HasSubstr("void every(const Prepared<T>& c, T t, const T* x, const T* y, const "
                                          "Inputs<T>& u, T* out) noexcept {"));
  EXPECT_THAT(generated.header, HasSubstr("void still([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, "
                                          "[[maybe_unused]]"));
}

TEST_F(EveryNode, combined_returns_each_result_by_a_pointer_of_its_own) {
  const std::size_t at = generated.header.find("void every_and_still(");
  ASSERT_NE(at, std::string::npos);
  const std::string text = generated.header.substr(at, generated.header.find("\n}\n", at) - at);
  EXPECT_THAT(text, HasSubstr("T* out, T* out_still)"));
  EXPECT_THAT(text, HasSubstr("out_still[1] = "));
  EXPECT_THAT(generated.header, HasSubstr("// out: values\n// out_still: v and its square\n"));
}

TEST_F(EveryNode, leaves_out_parameters_and_inputs_that_nothing_reads_and_says_so) {
  EXPECT_THAT(generated.header, HasSubstr("struct Parameters {\n  T a = T(0.4);\n  T b = T(1.2);\n};"));
  EXPECT_THAT(generated.header, HasSubstr("struct Inputs {\n  T drive = T(-0.7);\n};"));
  EXPECT_THAT(generated.header,
              HasSubstr("inline constexpr int n_parameters = 2;\ninline constexpr int n_inputs = 1;"));
  EXPECT_THAT(generated.header, HasSubstr("nothing here reads are left out: unread, idle.\n"));
  EXPECT_THAT(generated.abi, Not(HasSubstr("unread")));
}

TEST_F(EveryNode, gives_the_pattern_of_its_matrices) {
  // every output of the state depends on x[1], on x[4], or on both; those of parameters on neither
  std::size_t n = 0;
  const program::Function& jacobian = generated.program.functions[2];
  for (const program::Ref ref : jacobian.outputs) {
    const auto* constant = std::get_if<program::Constant>(&generated.program.nodes[static_cast<std::size_t>(ref.node)]);
    n += constant == nullptr || !(constant->value == program::Number(0.0));
  }
  ASSERT_EQ(jacobian.name, "every_x");
  EXPECT_THAT(generated.header, HasSubstr("inline constexpr int every_x_nonzeros = " + std::to_string(n) + ";"));
  EXPECT_THAT(generated.header, HasSubstr("inline constexpr int every_x_rows[] = {0, 0, 1, 1, 2, 2, 3, 3, 4, 5, "));
  EXPECT_THAT(generated.header, HasSubstr("inline constexpr int every_x_columns[] = {1, 4, 1, 4, 1, 4, 1, 4, 1, 1, "));
}

TEST_F(EveryNode, says_where_the_scene_was_and_what_the_scalar_must_have) {
  EXPECT_THAT(generated.header, HasSubstr("// model 0123456789abcdef of models/every_node.toml; all functions\n"));
  EXPECT_THAT(generated.header, HasSubstr("abs, acos, asin, atan2, cos, exp, log, max, min,"));
  EXPECT_THAT(generated.header, HasSubstr("#include <cmath>\n"));
}

// A scene with a joint of each sort; only its state and names are looked at, so a program without functions will do.
TEST(State, is_named_by_constants_and_listed_in_the_preamble) {
  scene::Scene scene = every_node_sample().scene;
  scene.lower = {0, 1, 2, 0};
  scene.bodies.resize(4, scene.bodies[0]);
  for (int i = 1; i <= 4; ++i) scene.bodies[static_cast<std::size_t>(i - 1)].name = "body" + std::to_string(i);
  scene.bodies[1].name = "elbow";
  scene::Joint turning;
  turning.kind = "revolute";
  turning.ball = false;
  turning.turns.resize(1);
  turning.slides.clear();
  scene.bodies[1].joint = scene.bodies[2].joint = turning;
  scene.bodies[2].joint.turns[0].motion = scene::Coordinate::Motion::locked;
  scene.bodies[2].joint.turns[0].value = 0.5;
  scene.bodies[3].joint.held = true;
  scene.bodies[3].joint.slides[1].motion = scene::Coordinate::Motion::prescribed;
  scene.bodies[3].joint.slides[1].expression = 0;
  scene.expressions = {{"0.1*sin(t)", {}}};
  const std::string header = emit::emit_header({&scene, "0", "0", "no functions"}, {});
  for (const char* part :
       {"//   2 elbow on 1: revolute\n", "//   x = (eps_1_1 .. eps_1_4, theta_2, s_1_1 .. s_1_3, s_4_1, s_4_3)\n",
        "//   y = (omega_1_1 .. omega_1_3, thetadot_2, sdot_1_1 .. sdot_1_3, sdot_4_1, sdot_4_3)\n",
        "//   locked: theta_3 = 0.5, eps_4\n", "//   prescribed: s_4_2 = 0.1*sin(t)\n", "thetadot  rate of theta",
        "namespace at {\ninline constexpr int eps_1_1 = 0, eps_1_2 = 1,", "theta_2 = 4,", "s_4_3 = 9;\n",
        "inline constexpr int omega_1_1 = 0,", "thetadot_2 = 3,", "theta_elbow = 4;\n", "thetadot_elbow = 3;\n"})
    EXPECT_THAT(header, HasSubstr(part));
  EXPECT_THAT(header, Not(HasSubstr("body1_")));
}

}  // namespace
}  // namespace kanec::test
