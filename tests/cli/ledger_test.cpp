// Oracle: the counts that `kanec generate` reports of each scene; the page is compared with what is committed.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/reductions.hpp"
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

class Ledger : public Program {
 protected:
  Ledger() { fs::create_directory_symlink(KANEC_SOURCE_DIR "/models", work() / "models"); }
};

TEST_F(Ledger, counts_what_generate_counts) {
  const json scenes = json_of({"ledger", "models/free_body", "models/bench_s6f/scene.toml", "--json"});
  ASSERT_EQ(scenes.size(), 2u);
  EXPECT_EQ(scenes[1].at("model"), "bench_s6f");
  const json report = json_of({"generate", model("bench_s6f"), "-o", "s6f.hpp", "--json"});
  EXPECT_EQ(scenes[1].at("functions"), report.at("functions"));
  EXPECT_EQ(scenes[1].at("nx"), report.at("nx"));
}

TEST_F(Ledger, of_a_folder_has_every_scene_in_it) {
  const json scenes = json_of({"ledger", "--json"});  // models is what it looks for
  std::vector<std::string> found;
  for (const json& scene : scenes) found.push_back(scene.at("model"));
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  std::vector<std::string> folders;
  for (const std::string& name : names(work() / "models"))
    if (fs::exists(work() / "models" / name / "scene.toml")) folders.push_back(name);
  EXPECT_EQ(found, folders);
}

TEST_F(Ledger, as_text_has_a_line_a_function) {
  const Answer answer = kanec({"ledger", "models/free_body"});
  EXPECT_EQ(answer.status, 0);
  EXPECT_THAT(answer.out, testing::StartsWith("scene      function "));
  EXPECT_THAT(answer.out, HasSubstr("\nfree_body  accelerations "));
}

TEST_F(Ledger, of_all_functions_has_those_on_request) {
  EXPECT_THAT(kanec({"ledger", "models/free_body"}).out, Not(HasSubstr("state_matrix")));
  EXPECT_THAT(kanec({"ledger", "models/free_body", "--all"}).out, HasSubstr("state_matrix"));
}

TEST_F(Ledger, page_of_the_shipped_scenes_is_that_in_docs) {
  const Answer answer = kanec({"ledger", "models", "--markdown"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(answer.out, read_file(KANEC_SOURCE_DIR "/docs/ledger.md"))
      << "if the new counts are meant: kanec ledger models --markdown -o docs/ledger.md";
}

TEST_F(Ledger, without_scenes_is_refused) {
  fs::create_directory(work() / "empty");
  const std::vector<std::string> there = {"empty", "models"};
  refuses({"ledger", "empty"}, "found 'empty', in which no folder holds a scene.toml", there);
  refuses({"ledger", "nowhere"}, "nowhere: No such file or directory", there);
  refuses({"ledger", "models", "--markdown", "--json"}, "--json: found it beside --markdown", there);
}

TEST(Reductions, are_a_line_each) {
  const std::vector<Reduction> list = {{"welded bodies", "plate is part of hub", 120}, {"locks", "theta_3 stands", 7}};
  EXPECT_EQ(reductions_text("arm", list),
            "arm\n\nreduction      operations saved  what\nwelded bodies               120  plate is part of hub\n"
            "locks                         7  theta_3 stands\n");
  EXPECT_EQ(reductions_text("arm", {}), "arm: nothing to reduce\n");
  EXPECT_EQ(reductions_json("arm", list).at("reductions").at(1).at("operations_saved"), 7);
}

}  // namespace
}  // namespace kanec::cli::test
