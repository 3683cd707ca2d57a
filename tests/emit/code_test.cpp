// Emitted code compiled alone with strict warnings and run. Oracles: the program evaluated operation by operation (bit
// for bit), the generic numeric path, and a scalar that counts what is executed.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "generator/program/ledger.hpp"
#include "generator/read/read.hpp"
#include "runtime/base/process.hpp"
#include "tests/emit/driver.hpp"
#include "tests/emit/shipped.hpp"

namespace kanec::test {
namespace {

struct Case {
  const char* name;
  scene::Scene (*scene)();
  std::vector<std::string> functions = {};
  bool comparable = true;  // numbers within the range of a float, and a mass matrix that long double can factorise
  friend void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
};

scene::Scene random_of(const std::vector<int>& lower, const RandomSceneOptions& options) {
  Random random(11);
  return random_scene(random, lower, options);
}

// Powers of ten of every sort, negative zero, whole numbers beyond 2^63, and the longest names allowed.
scene::Scene odd_numbers() {
  scene::Scene scene = random_of({0, 1}, {});
  scene.name = std::string(63, 'n');
  scene.parameters = {{std::string(63, 'p'), 123456789012345680000.0}, {"T1", 1e-300}};
  scene.inputs = {{std::string(63, 'u'), 1e22}, {"c", -1e15}, {"x", 9007199254740993.0}};
  scene.bodies[0].name = std::string(63, 'b');
  scene.bodies[0].mass = scene::Number::constant(123456789012345680000.0);
  scene.bodies[0].r = {scene::Number::constant(-0.0), scene::Number::constant(1e-40), scene::Number::parameter(1)};
  scene.bodies[1].q = {scene::Number::constant(1e30), scene::Number::constant(12345678901234567890.0), {}};
  scene.bodies[1].mass = scene::Number::parameter(0);
  scene.bodies[1].force = {scene::Number::input(0), scene::Number::input(1), scene::Number::input(2)};
  return scene;
}

const Case cases[] = {
    {"one_body_without_numbers_to_spare", [] { return shipped("free_body"); }},
    {"source_tree", [] { return shipped("six_body"); }},
    {"symbolic_tree",
     [] {
       return scene::from_connection({0, 1, 1});
     }},
    {"forest_of_parameters_and_zeros",
     [] {
       return random_of({0, 0, 2, 2, 4}, {.parameter_share = 0.5, .input_share = 0.5, .zero_share = 0.4});
     }},
    {"no_gravity_no_loads",
     [] {
       return random_of({0, 1}, {.gravity = false, .loads = false});
     }},
    {"odd_numbers_and_long_names", odd_numbers, {}, false},
};

class EmittedCode : public testing::TestWithParam<Case> {
 protected:
  EmittedCode() {
    Random random(12);
    sample = sample_of(GetParam().scene(), random);
    generated = generate(sample.scene, {GetParam().functions});
  }

  Sample sample;
  Generated generated;
};

INSTANTIATE_TEST_SUITE_P(Scenes, EmittedCode, testing::ValuesIn(cases),
                         [](const auto& c) { return std::string(c.param.name); });

std::vector<std::uint64_t> bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> result;
  for (const double value : values) result.push_back(std::bit_cast<std::uint64_t>(value));
  return result;
}

// The sample's arguments as the driver reads them.
// The header prescribes the operations and their order; an optimiser that may not contract keeps both.
TEST_P(EmittedCode, gives_the_bits_of_its_program) {
  Driver driver(sample, generated);
  ASSERT_EQ(driver.compile("g++", {"-O2", "-ffp-contract=off", "-DKANEC_LIBM_COS_SIN"}, {"double"}), "");
  driver.run();
  const program::Arguments<double> at = double_arguments(sample);
  for (const program::Function& function : generated.program.functions)
    EXPECT_EQ(bits(driver.results<double>("double", function.name)), bits(evaluate(generated.program, function, at)))
        << function.name;
}

TEST_P(EmittedCode, is_a_template_over_any_scalar_and_executes_what_its_ledger_says) {
  Driver driver(sample, generated);
  ASSERT_EQ(driver.compile("g++", {"-O0"}, {"float", "long double", "counted"}), "");
  driver.run();
  expect_counts(driver.counts("prepare"), program::prepare_ledger(generated.program));
  const program::Arguments<long double> at = arguments<long double>(sample);
  for (const program::Function& function : generated.program.functions) {
    SCOPED_TRACE(function.name);
    expect_counts(driver.counts(function.name), program::ledger(generated.program, function));
    // a sign costs at most one operation a result
    EXPECT_LE(driver.counts(function.name).negations, function.n_out);
    if (!GetParam().comparable) continue;
    const std::vector<long double> expected = generic_result(sample, function.name, at);
    // folded constants are emitted as doubles
    EXPECT_LT(relative_difference(driver.results<long double>("long double", function.name), expected), 1e-13);
    // 6e-8 a rounding, some hundred roundings, enlarged as in double
    EXPECT_LT(relative_difference(driver.results<double>("float", function.name), expected), 1e-4);
  }
}

// g++ has its say, at -O0 and -O2, in the tests above.
TEST_P(EmittedCode, compiles_without_a_warning_of_clang) {
  if (!find_program("clang++")) GTEST_SKIP() << "clang++ is not installed";
  Driver driver(sample, generated);
  EXPECT_EQ(driver.compile("clang++", {"-fsyntax-only"}, {"float", "double", "long double", "counted"}), "");
}

// Oracle: the program, as for functions in one piece.
TEST(LongFunction, in_pieces_gives_the_bits_of_its_program_at_the_cost_of_its_ledger) {
  Random random(13);
  const Sample sample = sample_of(random_of(chain(15), {}), random);
  const Generated generated = generate(sample.scene, {{"mass_matrix"}});
  ASSERT_NE(generated.header.find("mass_matrix_pieces::piece_2"), std::string::npos);
  Driver driver(sample, generated);
  ASSERT_EQ(driver.compile("g++", {"-O0", "-ffp-contract=off", "-DKANEC_LIBM_COS_SIN"}, {"double", "counted"}), "");
  driver.run();
  const program::Function& function = generated.program.functions[0];
  EXPECT_EQ(bits(driver.results<double>("double", "mass_matrix")),
            bits(evaluate(generated.program, function, double_arguments(sample))));
  expect_counts(driver.counts("mass_matrix"), program::ledger(generated.program, function));
}

}  // namespace
}  // namespace kanec::test
