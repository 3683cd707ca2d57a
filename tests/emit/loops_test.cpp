// Functions emitted as loops over bodies, compiled alone with strict warnings and run. Oracles: the program evaluated
// operation by operation (bit for bit), and a scalar that counts what is executed.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "generator/program/ledger.hpp"
#include "generator/program/rolled.hpp"
#include "generator/read/read.hpp"
#include "runtime/base/process.hpp"
#include "tests/emit/driver.hpp"

namespace kanec::test {
namespace {

std::vector<int> connection(int n, int (*lower)(int)) {
  std::vector<int> list;
  for (int k = 1; k <= n; ++k) list.push_back(lower(k));
  return list;
}

int before(int k) { return k - 1; }
int hub(int k) { return k == 1 ? 0 : 1; }
int half(int k) { return k / 2; }

// Alike but for their numbers; joints repeat with a period of three.
scene::Scene regular(const std::vector<int>& lower, const RandomSceneOptions& options) {
  Random random(21);
  scene::Scene scene = random_scene(random, lower, options);
  const std::size_t period = 3;
  for (std::size_t k = period; k < scene.bodies.size(); ++k) scene.bodies[k].joint = scene.bodies[k - period].joint;
  return scene;
}

struct LoopCase {
  const char* name;
  scene::Scene scene;
  std::vector<std::string> functions;
};

std::vector<LoopCase> loop_cases() {
  const RandomSceneOptions hinges{.joints = {"revolute"}};
  const RandomSceneOptions parameters{.parameter_share = 0.5, .input_share = 0.5};
  return {{"chain", regular(connection(8, before), hinges), {"residual", "energy"}},
          {"star", regular(connection(8, hub), hinges), {"kinematics+residual"}},
          {"tree", regular(connection(9, half), hinges), {"residual", "energy"}},
          {"free", regular(connection(6, before), {}), {"residual", "accelerations"}},
          {"parameters", regular(connection(5, before), parameters), {"residual"}},
          {"symbolic", scene::from_connection(connection(4, half)), {"residual", "accelerations"}}};
}

void expect_same_numbers(Driver& driver, const Generated& generated, const Sample& sample) {
  const program::Arguments<double> at = double_arguments(sample);
  for (const program::Function& function : generated.program.functions) {
    SCOPED_TRACE(function.name);
    EXPECT_EQ(driver.results<double>("double", function.name), evaluate(generated.program, function, at));
    const Counts& executed = driver.counts(function.name);
    const program::Ledger promised = program::ledger(generated.program, function);
    EXPECT_EQ(executed.adds, promised.adds);
    EXPECT_EQ(executed.multiplies, promised.multiplies);
    EXPECT_EQ(executed.divides, promised.divides);
  }
}

TEST(Loops, give_the_bits_of_the_program_at_the_cost_of_its_ledger) {
  for (const LoopCase& c : loop_cases()) {
    SCOPED_TRACE(c.name);
    Random random(22);
    const Sample sample = sample_of(c.scene, random);
    const Generated generated = generate(sample.scene, {c.functions, {}, emit::Optimize::loops});
    ASSERT_NE(generated.header.find("_sections {"), std::string::npos);
    Driver driver(sample, generated);
    ASSERT_EQ(driver.compile("g++", {"-O0", "-ffp-contract=off", "-DKANEC_LIBM_COS_SIN"}, {"double", "counted"}), "");
    driver.run();
    expect_same_numbers(driver, generated, sample);
    if (!find_program("clang++")) continue;
    EXPECT_EQ(driver.compile("clang++", {"-fsyntax-only"}, {"float", "long double"}), "");
  }
}

// The program does not depend on how it is written.
TEST(Loops, change_no_program) {
  const scene::Scene scene = loop_cases()[0].scene;
  const Generated line = generate(scene, {{"residual"}}),
                  loops = generate(scene, {{"residual"}, {}, emit::Optimize::loops});
  EXPECT_EQ(program::ledger(line.program, line.program.functions[0]),
            program::ledger(loops.program, loops.program.functions[0]));
  EXPECT_NE(line.hash, loops.hash);
  EXPECT_EQ(line.header.find("_sections {"), std::string::npos);
}

TEST(Loops, are_the_same_twice) {
  const scene::Scene scene = loop_cases()[1].scene;
  EXPECT_EQ(generate(scene, {{"residual"}, {}, emit::Optimize::loops}).header,
            generate(scene, {{"residual"}, {}, emit::Optimize::loops}).header);
}

// Joints repeat, numbers and their signs are random. Measured: 1779, 2226 and 2375 operations of 24, 96 and 192 bodies.
TEST(Loops, over_a_chain_of_four_times_the_length_write_less_than_half_as_much_again) {
  const auto written = [](int n) {
    const scene::Scene scene = regular(connection(n, before), {.loads = false, .joints = {"revolute"}});
    const Generated generated = generate(scene, {{"residual"}});
    return program::rolled(generated.program, generated.program.functions[0])->written;
  };
  EXPECT_LT(2 * written(96), 3 * written(24));
}

// Beyond what fits a processor's caches a straight line is no faster: see docs/compile_time.md.
TEST(Loops, are_written_of_a_long_function_without_being_asked_for) {
  const auto is_looped = [](int n) {
    const scene::Scene scene = regular(connection(n, before), {.loads = false, .joints = {"revolute"}});
    return generate(scene, {{"residual"}}).header.find("residual_sections {") != std::string::npos;
  };
  EXPECT_FALSE(is_looped(8));
  EXPECT_TRUE(is_looped(160));
}

}  // namespace
}  // namespace kanec::test
