// The shipped benchmark trees. Oracle: published states computed by another engine in other coordinates (tests/data),
// converted.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <map>

#include "tests/models/model.hpp"
#include "tests/support/reference.hpp"

namespace kanec::test {
namespace {

std::vector<double> list(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

// The reference's inputs in the order of the shipped scene, by their names.
std::vector<double> by_name(const scene::Scene& from, const Eigen::VectorXd& values, const scene::Scene& to) {
  std::map<std::string, double> named;
  for (std::size_t i = 0; i < from.inputs.size(); ++i)
    named[from.inputs[i].name] = values[static_cast<Eigen::Index>(i)];
  std::vector<double> out;
  for (const scene::Named& input : to.inputs) out.push_back(named.at(input.name));
  return out;
}

class Benchmark : public testing::TestWithParam<std::string> {
 protected:
  // Calls test(arguments of the shipped model with the published accelerations).
  template <class Test>
  void for_states(Test test) const {
    const Reference reference = read_reference(KANEC_SOURCE_DIR "/tests/data/reference_" + GetParam() + ".json");
    ASSERT_FALSE(reference.states.empty());
    for (const ReferenceState& state : reference.states) {
      const Converted<double> at = convert<double>(reference.scene, state);
      test(program::Arguments<double>{
          {}, list(at.x), list(at.y), list(at.ydot), by_name(reference.scene, at.u, model.scene())});
    }
  }

  const Model model{shipped_scene("bench_" + GetParam()), {"accelerations", "residual", "forcing"}};
};

INSTANTIATE_TEST_SUITE_P(Trees, Benchmark, testing::Values("s6f", "s6b", "s6r", "cr7", "cb6"),
                         [](const auto& name) { return name.param; });

// The published figures are doubles; the conversion and the program round some thousand times, and mass matrices with
// condition numbers of up to 1e4 enlarge that.
constexpr double benchmark_tolerance = 1e-11;

TEST_P(Benchmark, accelerations_are_the_published_ones) {
  for_states([this](const program::Arguments<double>& at) {
    EXPECT_LT(relative_difference(model("accelerations", at), as<long double>(at.ydot)), benchmark_tolerance);
  });
}

TEST_P(Benchmark, residual_of_the_published_accelerations_vanishes) {
  for_states([this](const program::Arguments<double>& at) {
    const std::vector<double> f = model("forcing", at);
    std::vector<double> sum = model("residual", at);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += f[i];
    EXPECT_LT(relative_difference(sum, as<long double>(f)), benchmark_tolerance);
  });
}

}  // namespace
}  // namespace kanec::test
