// The hard cases at modest length. Oracles: known answers (closed forms, runs in higher precision), what physics keeps,
// and for rounding the generic path in long double.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/study/hard/outcome.hpp"
#include "tests/base/environment.hpp"

namespace kanec::hard::test {
namespace {

namespace fs = std::filesystem;
using kanec::test::Variable;

const fs::path folder = KANEC_SOURCE_DIR "/models/hard";

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const fs::path& path : hard_cases(folder)) list.push_back(path.filename().string());
  return list;
}

class Cases : public testing::TestWithParam<std::string> {
 private:
  // one cache for all runs of this build; each scene is compiled once, without optimisation, which is quick
  Variable cache_{"KANEC_CACHE", KANEC_BINARY_DIR "/tests/hard_cache"};
  Variable flags_{"KANEC_CXXFLAGS", "-O0"};
};

INSTANTIATE_TEST_SUITE_P(Hard, Cases, testing::ValuesIn(names()), [](const auto& one) { return one.param; });

TEST_P(Cases, keep_to_their_bounds_and_round_no_worse_than_twice_the_generic_path) {
  const HardCase one = read_hard_case(folder / GetParam());
  EXPECT_EQ(one.scene.name, GetParam());
  EXPECT_TRUE(fs::exists(folder / GetParam() / "README.md"));
  const CompiledModel model = compiled(one);
  for (const hard::Run& run : one.runs) {
    SCOPED_TRACE(run.brief.settings.integrator);
    EXPECT_FALSE(run.brief.keeps.empty());
    const Outcome found = outcome(one, run.brief, model);
    EXPECT_EQ(found.failure, "");
    for (const Kept& kept : found.kept)
      EXPECT_TRUE(kept.holds()) << kept.what << ": " << kept.found << ", at most " << kept.most;
    EXPECT_TRUE(found.accelerations.holds())
        << "accelerations: " << found.accelerations.emitted << " ulps, generic path " << found.accelerations.generic;
  }
}

}  // namespace
}  // namespace kanec::hard::test
