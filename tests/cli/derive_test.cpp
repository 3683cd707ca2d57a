// Oracle: the sizes and tables that the source prints; pdflatex. The tables' blocks are tested with the derivation.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

class Derive : public Program {
 protected:
  const std::vector<std::string> source_tree_ = {"derive", "--connection", "0,1,2,2,1,5"};
  std::vector<std::string> with(std::vector<std::string> more) const {
    std::vector<std::string> arguments = source_tree_;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};

TEST_F(Derive, text_has_the_tables_of_the_source) {
  const std::string text = kanec(source_tree_).out;
  for (const char* line :
       {"L(K) = (0, 1, 2, 2, 1, 5)", "u(K) = (0, 1, 2, 2, 1, 2)", "size of x = 42", "size of y = 36"})
    EXPECT_THAT(text, HasSubstr(line));
  for (const char* title : {"State vectors", "Kinematical equations", "Positions", "Velocities", "Partial velocities",
                            "Partial angular velocities", "Partial velocities, one matrix a body",
                            "Time derivatives of the partial velocities", "Equations of motion", "Loads"})
    EXPECT_THAT(text, HasSubstr(title));
}

TEST_F(Derive, json_has_bodies_and_loads_by_the_heads_of_their_columns) {
  const json tables = json_of(with({"--json"}));
  EXPECT_EQ(tables.at("bodies").size(), 6u);
  EXPECT_EQ(
      tables.at("bodies")[1],
      json({{"K", "2"}, {"name", "body_2"}, {"joint", "free"}, {"coordinates", "eps_body_2_1 to 4, s_body_2_1 to 3"}}));
  EXPECT_EQ(tables.at("loads").size(), 12u);
  EXPECT_EQ(tables.at("loads")[0].at("letter"), "F1");
  EXPECT_EQ(tables.at("loads")[0].at("unit"), "N");
}

TEST_F(Derive, json_has_the_same_tables_as_text) {
  const json tables = json_of(with({"--json"}));
  EXPECT_EQ(tables.at("nx"), 42);
  EXPECT_EQ(tables.at("ny"), 36);
  EXPECT_EQ(tables.at("connection"), json({0, 1, 2, 2, 1, 5}));
  EXPECT_EQ(tables.at("depth"), json({0, 1, 2, 2, 1, 2}));
  const std::string text = kanec(source_tree_).out;
  for (const json& table : tables.at("tables")) {
    EXPECT_THAT(text, HasSubstr(table.at("title").get<std::string>()));
    for (const json& row : table.at("rows"))
      EXPECT_THAT(text, HasSubstr(row.at("left").get<std::string>() + " = " + row.at("right").get<std::string>()));
  }
}

TEST_F(Derive, latex_compiles_as_it_is) {
  EXPECT_EQ(kanec(with({"--format", "latex", "-o", "six.tex"})).status, 0);
  const std::string latex = read_file(work() / "six.tex");
  EXPECT_THAT(latex, HasSubstr("\\row{\\dim x}{42}"));
  EXPECT_THAT(latex, HasSubstr("\\row{\\dim y}{36}"));
  EXPECT_EQ(names(work()), std::vector<std::string>{"six.tex"});
  if (!find_program("pdflatex")) GTEST_SKIP() << "pdflatex is not installed";
  const ProcessResult result = run_process({"pdflatex", "-interaction=nonstopmode", "-halt-on-error",
                                            "-output-directory", work().string(), (work() / "six.tex").string()});
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_TRUE(fs::exists(work() / "six.pdf"));
}

TEST_F(Derive, unwritable_output_leaves_nothing) {
  refuses(with({"-o", "nowhere/six.txt"}), "nowhere/six.txt: No such file or directory");
  refuses(with({"-o", "."}), ".: Is a directory");
  refuses(with({"-o", "/dev/full"}), "/dev/full: No space left on device");
}

}  // namespace
}  // namespace kanec::cli::test
