// The LaTeX document. Oracle: what LaTeX asks of a document, and pdflatex itself where it is installed.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "generator/read/read.hpp"
#include "generator/symbolic/derive.hpp"
#include "generator/tables/grids.hpp"
#include "generator/tables/tables.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/process.hpp"
#include "tests/base/folder.hpp"
#include "tests/symbolic/latex_check.hpp"
#include "tests/symbolic/sample_documents.hpp"

namespace kanec::emit {
namespace {

using symbolic::Style;
using test::latex_faults;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr int n_random = 60;

symbolic::Equations six_bodies() { return symbolic::derive(scene::from_connection({0, 1, 2, 2, 1, 5})); }

// As the command derives them: joints where the scene has them.
symbolic::Equations as_typed(const scene::Scene& scene) {
  return symbolic::derive(scene, {}, {{.place_origins = false, .regroup = false, .turn_axes = false}});
}

int count(const std::string& text, const std::string& what) {
  int n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size())) ++n;
  return n;
}

// What pdflatex says of a document; empty where it makes a PDF of it.
std::string complaint(const std::string& document) {
  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "equations.tex";
  write_file(file, document);
  const ProcessResult result = run_process({"pdflatex", "-interaction=nonstopmode", "-halt-on-error",
                                            "-output-directory=" + folder.path().string(), file.string()});
  return result.status == 0 && std::filesystem::exists(folder.path() / "equations.pdf") ? "" : result.output;
}

TEST(Latex, is_a_whole_document_with_a_section_a_table) {
  const symbolic::Equations equations = six_bodies();
  const std::string text = latex_document(equations);
  const int n_tables = static_cast<int>(tables(equations, Style::latex).size());
  EXPECT_THAT(text, StartsWith("\\documentclass[a4paper]{article}\n"));
  EXPECT_THAT(text, EndsWith("\\end{document}\n"));
  EXPECT_EQ(count(text, "\\begin{document}"), 1);
  EXPECT_EQ(count(text, "\\subsection*{"), n_tables + 2);
  for (const char* part : {"\\begin{rows}", "\\end{rows}"}) EXPECT_EQ(count(text, part), n_tables);
  EXPECT_EQ(count(text, "\\begin{longtable}"), 2);
}

TEST(Latex, has_the_rows_of_the_text) {
  for (const char* name : {"six_body", "every_joint", "quadruped", "cart_pole"}) {
    const symbolic::Equations equations =
        as_typed(scene::read(std::string(KANEC_SOURCE_DIR "/models/") + name + "/scene.toml"));
    const std::vector<Table> text = tables(equations, Style::text);
    const std::vector<Table> latex = tables(equations, Style::latex);
    ASSERT_EQ(latex.size(), text.size());
    for (std::size_t i = 0; i < text.size(); ++i) EXPECT_EQ(latex[i].rows.size(), text[i].rows.size()) << text[i].title;
    EXPECT_EQ(load_grid(equations, Style::latex).lines.size(), load_grid(equations, Style::text).lines.size());
  }
}

TEST(Latex, writes_blocks_in_the_notation_of_the_source) {
  const std::string text = latex_document(six_bodies());
  EXPECT_THAT(text,
              HasSubstr("\\row{v_{3,\\omega_{1}}}{-R_{1}^{T} \\brkfac (\\tilde{q}_{2} \\brkin + \\tilde{s}_{2})}\n"));
  EXPECT_THAT(text, HasSubstr("\\row{v_{6,\\dot s_{6}}}{R_{5}^{T}}\n"));
  EXPECT_THAT(text,
              HasSubstr("\\row{\\dot\\varepsilon_{4}^{(2)}}{-\\tfrac12 \\brkfac e_{2} \\brkfac \\cdot \\omega_{2}}\n"));
}

TEST(Latex, writes_a_matrix_a_body_as_the_source_does) {
  std::vector<Row> rows;
  for (const Table& table : tables(six_bodies(), Style::latex))
    if (table.title.rfind("Partial velocities, one", 0) == 0) rows = table.rows;
  ASSERT_EQ(rows.size(), 12u);
  EXPECT_EQ(rows[4].first, "[v_{3,y_1}]");
  EXPECT_EQ(rows[4].second,
            "[-R_{1}^{T} (\\tilde{q}_{2} + \\tilde{s}_{2}), -R_{2}^{T} (\\tilde{q}_{3} + \\tilde{s}_{3}), "
            "-R_{3}^{T} \\tilde{r}_{3}, 0, 0, 0]");
}

TEST(Latex, every_load_has_letters_of_its_own) {
  const std::string text = latex_document(as_typed(scene::read(KANEC_SOURCE_DIR "/models/quadruped/scene.toml")));
  EXPECT_THAT(text, HasSubstr("\\tau_{\\text{fr\\_hip}}"));
  EXPECT_THAT(text, HasSubstr("\\tau_{\\text{rl\\_calf}}"));
  EXPECT_EQ(count(text, "\\tau}") + count(text, "\\tau)"), 0);
}

TEST(Latex, names_of_scenes_are_escaped) {
  EXPECT_THAT(latex_document(six_bodies()), HasSubstr("\\section*{tree\\_012215: 6 bodies"));
}

TEST(Latex, check_finds_what_is_wrong) {
  const auto faults = [](const std::string& body) {
    return latex_faults("\\begin{document}\n" + body + "\n\\end{document}\n");
  };
  EXPECT_THAT(faults("\\row{x_{1}^{2}}{\\tilde{a}_{2} (b_{3}{}^{T})} $r_{\\text{a\\_1}}$"), IsEmpty());
  for (const char* wrong : {"$x_{1}_{2}$",
                            "$x^{1}^{2}$",
                            "$x_{1}'^{2}$",
                            "$x_{}$",
                            "$x_{ }$",
                            "$(x + )_$",
                            "$_{1}$",
                            "x_1",
                            "x_{1}",
                            "{x",
                            "x}",
                            "$x",
                            "\\row{x}{$y}",
                            "\\undefined",
                            "$\\text{a_{1}}$",
                            "\\begin{rows}{x}",
                            "\\end{rows}",
                            "\\~",
                            "\\begin{rows}{x}\\begin{longtable}{l}\\end{rows}\\end{longtable}",
                            "\xc3\xa4"})
    EXPECT_THAT(faults(wrong), testing::Not(IsEmpty())) << wrong;
  EXPECT_THAT(latex_faults("x"), ElementsAre("no document: x"));
}

TEST(Latex, every_shipped_scene_is_in_order) {
  const std::vector<std::filesystem::path> files = test::shipped_scenes();
  EXPECT_GT(files.size(), 45u);
  for (const std::filesystem::path& file : files)
    EXPECT_THAT(latex_faults(latex_document(as_typed(scene::read(file)))), IsEmpty()) << file;
}

TEST(Latex, random_scenes_with_rough_names_are_in_order) {
  for (int seed = 0; seed < n_random; ++seed) {
    const scene::Scene scene = test::scene_with_rough_names(seed);
    EXPECT_THAT(latex_faults(latex_document(as_typed(scene))), IsEmpty()) << seed;
    EXPECT_THAT(latex_faults(latex_document(symbolic::derive(scene))), IsEmpty()) << seed;
  }
}

TEST(Latex, is_the_same_twice) {
  for (int seed = 0; seed < 8; ++seed) {
    const scene::Scene scene = test::scene_with_rough_names(seed);
    EXPECT_EQ(latex_document(as_typed(scene)), latex_document(as_typed(scene)));
  }
}

TEST(Latex, every_shipped_scene_compiles) {
  if (!find_program("pdflatex")) GTEST_SKIP() << "pdflatex is not installed";
  for (const std::filesystem::path& file : test::shipped_scenes())
    EXPECT_EQ(complaint(latex_document(as_typed(scene::read(file)))), "") << file;
}

TEST(Latex, random_scenes_compile) {
  if (!find_program("pdflatex")) GTEST_SKIP() << "pdflatex is not installed";
  for (int seed = 0; seed < n_random; seed += 4)
    EXPECT_EQ(complaint(latex_document(as_typed(test::scene_with_rough_names(seed)))), "") << seed;
}

}  // namespace
}  // namespace kanec::emit
