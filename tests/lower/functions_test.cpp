// Every function of the optimised program on random scenes. Oracle: the generic numeric path in long double.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "generator/choice/requests.hpp"
#include "tests/lower/sample.hpp"

namespace kanec::test {
namespace {

struct Kind {
  const char* name;
  RandomSceneOptions options;
  bool whole_vectors_zero = false;  // r and q of some bodies
  friend void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }
};

const Kind kinds[] = {
    {"constants", {}},
    {"trees", {.forest = false}},
    {"parameters_and_inputs", {.parameter_share = 1, .input_share = 1}},
    {"some_parameters_and_inputs", {.parameter_share = 0.3, .input_share = 0.3, .zero_share = 0.1}},
    {"zeros", {.zero_share = 0.5}, true},
    {"parameters_and_zeros", {.parameter_share = 0.5, .input_share = 0.5, .zero_share = 0.5}, true},
    {"no_gravity", {.gravity = false}},
    {"no_loads", {.loads = false}},
    {"neither", {.gravity = false, .loads = false, .zero_share = 0.3}, true},
};

class Functions : public testing::TestWithParam<Kind> {
 protected:
  static constexpr int scenes_of_each_size = 2;

  // 24 scenes of 1 to 12 bodies.
  template <class Test>
  static void for_samples(Test test) {
    Random random(100 + static_cast<std::uint64_t>(&GetParam() - kinds));
    for (int n_bodies = 1; n_bodies <= 12; ++n_bodies)
      for (int i = 0; i < scenes_of_each_size; ++i) {
        scene::Scene scene = random_scene(random, n_bodies, GetParam().options);
        for (scene::Body& body : scene.bodies)
          for (scene::Vector* vector : {&body.r, &body.q})
            if (GetParam().whole_vectors_zero && random.chance(0.4)) *vector = {};
        SCOPED_TRACE(std::to_string(n_bodies) + " bodies, scene " + std::to_string(i));
        test(sample_of(scene, random));
      }
  }
};

INSTANTIATE_TEST_SUITE_P(Scenes, Functions, testing::ValuesIn(kinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

template <class T>
double error(const Sample& s, const program::Program& program, const program::Function& function) {
  const program::Arguments<T> at = arguments<T>(s);
  return relative_difference(evaluate(program, function, at), generic_result(s, function.name, widened(at)));
}

// Some hundred roundings of 1.1e-16 a result, enlarged by sums of up to 12 bodies that cancel and, for the
// accelerations, by the inverses of inertias with condition numbers near 10.
TEST_P(Functions, agree_with_the_generic_path_in_double) {
  for_samples([&](const Sample& s) {
    const program::Program program = program_of(s.scene);
    for (const program::Function& function : program.functions)
      EXPECT_LT(error<double>(s, program, function), 1e-12) << function.name;
  });
}

// What is left are the folded constants, which are emitted as doubles: each off by 1.1e-16 at most, enlarged as above.
// Where all numbers are parameters nothing is folded, and it is long double's own 5.4e-20, enlarged by the generic
// path's factorisation of A with condition numbers near 1e3.
TEST_P(Functions, agree_with_the_generic_path_in_long_double) {
  const double tolerance = GetParam().options.parameter_share == 1 ? 5e-16 : 5e-14;
  for_samples([&](const Sample& s) {
    const program::Program program = program_of(s.scene);
    for (const program::Function& function : program.functions)
      EXPECT_LT(error<long double>(s, program, function), tolerance) << function.name;
  });
}

TEST_P(Functions, are_those_that_the_generic_path_has) {
  for_samples([](const Sample& s) {
    std::vector<std::string> names, expected;
    for (const Available& available : available_functions(s.scene)) names.push_back(available.name);
    for (const std::string_view name : generic::function_names(s.scene)) expected.emplace_back(name);
    EXPECT_THAT(names, testing::UnorderedElementsAreArray(expected));
  });
}

// The passes re-associate sums and fold constants; anything beyond rounding is a mistake in one of them.
TEST(Lower, program_has_the_same_values_before_and_after_the_passes) {
  Random random(7);
  for (int n_bodies = 1; n_bodies <= 8; ++n_bodies) {
    const RandomSceneOptions options{.parameter_share = 0.3, .input_share = 0.3, .zero_share = 0.2};
    const Sample s = sample_of(random_scene(random, n_bodies, options), random);
    const program::Program lowered = kanec::program_of(s.scene, requested_functions(s.scene, {}));
    const program::Program optimised = program_of(s.scene);
    ASSERT_EQ(lowered.functions.size(), optimised.functions.size());
    for (std::size_t i = 0; i < lowered.functions.size(); ++i) {
      const auto plain = evaluate(lowered, lowered.functions[i], arguments<long double>(s));
      const auto improved = evaluate(optimised, optimised.functions[i], arguments<long double>(s));
      // folded constants are rounded once to a double, 1.1e-16, and enter results enlarged as above
      EXPECT_LT(relative_difference(improved, plain), 1e-14) << lowered.functions[i].name;
    }
  }
}

}  // namespace
}  // namespace kanec::test
