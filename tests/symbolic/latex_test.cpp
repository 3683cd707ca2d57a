// The LaTeX document. Oracle: what LaTeX asks of a document, and pdflatex itself where it is installed.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "generator/emit/tables.hpp"
#include "generator/scene/read.hpp"
#include "generator/symbolic/derive.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/process.hpp"
#include "tests/base/folder.hpp"

namespace kanec::emit {
namespace {

using symbolic::Style;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

symbolic::Equations six_bodies() { return symbolic::derive(scene::from_connection({0, 1, 2, 2, 1, 5})); }

int count(const std::string& text, const std::string& what) {
  int n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size())) ++n;
  return n;
}

TEST(Latex, is_a_whole_document_with_a_section_and_an_alignment_a_table) {
  const symbolic::Equations equations = six_bodies();
  const std::string text = latex_document(equations);
  const int n_tables = static_cast<int>(tables(equations, Style::latex).size());
  EXPECT_THAT(text, StartsWith("\\documentclass{article}\n"));
  EXPECT_THAT(text, EndsWith("\\end{document}\n"));
  EXPECT_EQ(count(text, "\\begin{document}"), 1);
  for (const char* part : {"\\subsection*{", "\\begin{align*}", "\\end{align*}"})
    EXPECT_EQ(count(text, part), n_tables);
}

TEST(Latex, has_the_rows_of_the_text) {
  const symbolic::Equations equations = six_bodies();
  const std::vector<Table> text = tables(equations, Style::text);
  const std::vector<Table> latex = tables(equations, Style::latex);
  ASSERT_EQ(latex.size(), text.size());
  for (std::size_t i = 0; i < text.size(); ++i) EXPECT_EQ(latex[i].rows.size(), text[i].rows.size()) << text[i].title;
}

TEST(Latex, writes_blocks_in_the_notation_of_the_source) {
  const std::string text = latex_document(six_bodies());
  EXPECT_THAT(text, HasSubstr("v_{3,\\omega_{1}} &= -R_{1}^{T} (\\tilde{q}_{2} + \\tilde{s}_{2}) \\\\\n"));
  EXPECT_THAT(text, HasSubstr("v_{6,\\dot s_{6}} &= R_{5}^{T}\n"));
  EXPECT_THAT(text, HasSubstr("\\dot\\varepsilon_{4}^{(2)} &= -\\tfrac12 e_{2} \\cdot \\omega_{2} \\\\\n"));
}

TEST(Latex, braces_parentheses_and_double_subscripts_are_in_order) {
  const std::string text = latex_document(six_bodies());
  for (const auto& [open, close] : {std::pair('{', '}'), std::pair('(', ')')})
    EXPECT_EQ(std::count(text.begin(), text.end(), open), std::count(text.begin(), text.end(), close));
  EXPECT_THAT(text, Not(testing::ContainsRegex("_\\{[^{}]*\\}_")));
  EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
}

TEST(Latex, names_of_scenes_are_escaped) {
  EXPECT_THAT(latex_document(six_bodies()), HasSubstr("\\section*{tree\\_012215: 6 bodies"));
}

TEST(Latex, compiles_as_it_is) {
  if (!find_program("pdflatex")) GTEST_SKIP() << "pdflatex is not installed";
  const test::Folder folder;
  for (const std::vector<int>& lower :
       {std::vector<int>{0}, {0, 1, 2, 2, 1, 5}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}}) {
    const std::filesystem::path file = folder.path() / "tables.tex";
    write_file(file, latex_document(symbolic::derive(scene::from_connection(lower))));
    const ProcessResult result = run_process({"pdflatex", "-interaction=nonstopmode", "-halt-on-error",
                                              "-output-directory=" + folder.path().string(), file.string()});
    EXPECT_EQ(result.status, 0) << result.output;
    EXPECT_THAT(test::names(folder.path()), testing::Contains("tables.pdf"));
  }
}

}  // namespace
}  // namespace kanec::emit
