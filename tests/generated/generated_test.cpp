// The committed solvers in generated/ are what the generator makes of the shipped models. Oracle: the committed bytes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "generator/pipeline.hpp"
#include "generator/read/read.hpp"
#include "runtime/base/files.hpp"
#include "tests/generated/difference.hpp"

namespace kanec::test {
namespace {

namespace fs = std::filesystem;

const fs::path root = KANEC_SOURCE_DIR;

// The one command that accepts what the generator makes now.
const char* const accept = "KANEC_ACCEPT=1 " KANEC_BINARY_DIR "/tests/generated_test";

bool is_accepting() {
  const char* wish = std::getenv("KANEC_ACCEPT");
  return wish != nullptr && std::string(wish) == "1";
}

std::vector<std::string> shipped_models() {
  std::vector<std::string> models;
  for (const auto& entry : fs::directory_iterator(root / "models"))
    if (fs::exists(entry.path() / "scene.toml")) models.push_back(entry.path().filename().string());
  std::sort(models.begin(), models.end());
  return models;
}

class Model : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Generated, Model, testing::ValuesIn(shipped_models()),
                         [](const auto& model) { return model.param; });

TEST_P(Model, has_its_solver_committed_as_the_generator_makes_it) {
  const Generated made = generate(scene::read(root / "models" / GetParam() / "scene.toml"));
  EXPECT_EQ(made.name, GetParam()) << "the folder of a model bears its name";
  const fs::path file = root / "generated" / made.name / (made.name + ".hpp");
  if (is_accepting()) {
    fs::create_directories(file.parent_path());
    if (!fs::exists(file) || read_file(file) != made.header) write_file(file, made.header);
  }
  ASSERT_TRUE(fs::exists(file)) << file << " is missing; to write it: " << accept;
  const std::string committed = read_file(file);
  EXPECT_TRUE(committed == made.header) << file << " is not what the generator makes now:\n"
                                        << first_difference(committed, made.header) << "to accept it: " << accept;
}

TEST(GeneratedFolder, holds_the_solvers_of_the_shipped_models_and_nothing_else) {
  if (is_accepting()) GTEST_SKIP() << "the files are being written";
  std::vector<std::string> expected;
  for (const std::string& model : shipped_models()) expected.push_back(model + "/" + model + ".hpp");
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(root / "generated"))
    if (!entry.is_directory()) found.push_back(fs::relative(entry.path(), root / "generated").generic_string());
  EXPECT_THAT(found, testing::UnorderedElementsAreArray(expected));
}

TEST(FirstDifference, shows_the_first_lines_that_differ_with_their_number) {
  EXPECT_EQ(first_difference("a\nb\nc\n", "a\nB\nC\n"), "line 2:\n- b\n- c\n+ B\n+ C\n");
  EXPECT_EQ(first_difference("a\n", "a\nb\n"), "line 2:\n+ b\n");
  EXPECT_EQ(first_difference("a\nb\n", "a\n"), "line 2:\n- b\n");
  EXPECT_EQ(first_difference("a", "a\n"), "the last line ends differently\n");
}

TEST(FirstDifference, shows_five_lines_at_most) {
  std::string before, after;
  for (int i = 0; i < 20; ++i) before += "x\n", after += "y\n";
  EXPECT_EQ(first_difference(before, after), "line 1:\n- x\n- x\n- x\n- x\n- x\n+ y\n+ y\n+ y\n+ y\n+ y\n");
}

}  // namespace
}  // namespace kanec::test
