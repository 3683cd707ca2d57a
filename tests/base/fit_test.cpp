// Oracles: rules of each language on the text; where its program is installed, that program (bash, gnuplot, g++).
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/base/files.hpp"
#include "runtime/base/process.hpp"
#include "runtime/base/utf8.hpp"
#include "tests/base/folder.hpp"
#include "tests/base/nasty.hpp"

namespace kanec {
namespace {

using test::Folder;
using test::names;
using test::nasty_texts;
using testing::Not;

bool is_printable(const std::string& text) {
  bool printable = true;
  for_characters(text, [&](const Character& c) {
    const bool is_control = c.value < 0x20 || (c.value >= 0x7f && c.value < 0xa0);
    const bool turns = (c.value >= 0x200e && c.value <= 0x200f) || (c.value >= 0x2028 && c.value <= 0x202e) ||
                       (c.value >= 0x2066 && c.value <= 0x2069);
    printable = printable && c.is_valid && !is_control && !turns;
  });
  return printable;
}

TEST(Fit, everything_is_one_line_of_printable_characters) {
  for (const std::string& text : nasty_texts())
    for (auto* fit : {fit::line, fit::comment, fit::latex, fit::gnuplot, fit::xml, fit::markdown, fit::code, fit::link,
                      fit::shell, fit::csv, fit::toml})
      EXPECT_TRUE(is_printable(fit(text))) << fit(text);
}

TEST(Fit, letters_of_all_scripts_stay_readable) {
  const std::string name = "Pendel_\u00e4\u00f6\u00fc_\u632f\u308a\u5b50_\U0001f600";
  for (auto* fit : {fit::line, fit::lines, fit::xml, fit::csv, fit::json}) EXPECT_EQ(fit(name), name);
  EXPECT_EQ(fit::shell(name), "'" + name + "'");
  EXPECT_EQ(fit::gnuplot(name), "'" + name + "'");
  EXPECT_EQ(fit::toml(name), "\"" + name + "\"");
  EXPECT_EQ(fit::comment("a\u00e4\u632f\U0001f600b"), "a___b");
}

TEST(Fit, line_shows_what_a_terminal_would_obey) {
  EXPECT_EQ(fit::line("a\nb\r\t\x1b[0m\x7f"), "a\\x0ab\\x0d\\x09\\x1b[0m\\x7f");
  EXPECT_EQ(fit::line("\u202ea\u2066\u200f\u0085\u2028\ufeff"), "\\u202ea\\u2066\\u200f\\u0085\\u2028\\ufeff");
  EXPECT_EQ(fit::line("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(fit::line(std::string_view("a\0b", 3)), "a\\x00b");
}

TEST(Fit, line_of_a_line_is_the_same) {
  for (const std::string& text : nasty_texts()) EXPECT_EQ(fit::line(fit::line(text)), fit::line(text));
}

TEST(Fit, lines_keep_line_feeds_and_tabs_alone) {
  EXPECT_EQ(fit::lines("a.cpp:1:\r\n\terror \x1b[1m\u202e\n"), "a.cpp:1:\n\terror \\x1b[1m\\u202e\n");
  EXPECT_EQ(fit::lines("a\rb"), "a\\x0db");
  EXPECT_EQ(fit::lines("\n\n"), "\n\n");
  EXPECT_EQ(fit::lines(""), "");
}

TEST(Fit, comment_is_ascii_without_what_ends_or_continues_one) {
  for (const std::string& text : nasty_texts()) {
    const std::string comment = fit::comment(text);
    EXPECT_TRUE(std::all_of(comment.begin(), comment.end(), [](char c) { return c >= ' ' && c <= '~'; })) << comment;
    for (const char* part : {"\\", "?\?", "*/", "/*"}) EXPECT_EQ(comment.find(part), std::string::npos) << comment;
  }
  EXPECT_EQ(fit::comment("six_body/scene.toml"), "six_body/scene.toml");
  EXPECT_EQ(fit::comment("\u00e9\u00e9/scene.toml"), "__/scene.toml");
}

// In any standard, also one with trigraphs, no comment reaches the line below it.
TEST(Fit, comments_do_not_reach_beyond_their_line) {
  const auto compiler = find_program("g++");
  if (!compiler) GTEST_SKIP() << "g++ is not installed";
  std::string source;
  int count = 0;
  for (const std::string& text : nasty_texts())
    source += "// " + fit::comment(text) + "\nint a" + std::to_string(count++) + " /* " + fit::comment(text) + "*/;\n";
  source += "int sum() { return 0";
  for (int i = 0; i < count; ++i) source += " + a" + std::to_string(i);
  source += "; }\n";
  for (const char* standard : {"-std=c++98", "-std=c++14", "-std=c++20"}) {
    const ProcessResult result = run_process(
        {compiler->string(), standard, "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-xc++", "-"}, source);
    EXPECT_EQ(result.status, 0) << result.output;
  }
}

TEST(Fit, latex_has_no_command_but_ours) {
  EXPECT_EQ(fit::latex("a_b 5% #1 {x} $y$ & z"), "a\\_b 5\\% \\#1 \\{x\\} \\$y\\$ \\& z");
  EXPECT_EQ(fit::latex("\\input{x}~^"), "\\textbackslash{}input\\{x\\}\\textasciitilde{}\\textasciicircum{}");
}

TEST(Fit, gnuplot_reads_the_same_text_and_runs_nothing) {
  EXPECT_EQ(fit::gnuplot("it's"), "\"it\\047s\"");
  EXPECT_EQ(fit::gnuplot("a\n`b`"), "\"a\\012\\140b\\140\"");
  const auto gnuplot = find_program("gnuplot");
  if (!gnuplot) GTEST_SKIP() << "gnuplot is not installed (Debian package gnuplot-nox)";
  const Folder folder;
  const std::string path = (folder.path() / "out").string();
  std::string script = "cd " + fit::gnuplot(folder.path().string()) + "\nset print " + fit::gnuplot(path) + "\n",
              expected;
  for (const std::string& text : nasty_texts()) {
    if (text.find('\0') != std::string::npos) continue;
    script += "print " + fit::gnuplot(text) + "\n";
    expected += text + "\n";
  }
  const ProcessResult result = run_process({gnuplot->string(), "-d", "-"}, script + "unset print\n");
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_EQ(read_file(path), expected);
  EXPECT_THAT(names(folder.path()), testing::ElementsAre("out"));
}

TEST(Fit, xml_has_no_markup_but_ours) {
  for (const std::string& text : nasty_texts())
    EXPECT_EQ(fit::xml(text).find_first_of("<>\"'"), std::string::npos) << fit::xml(text);
  EXPECT_EQ(fit::xml("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c&#39;");
}

TEST(Fit, markdown_is_text_and_names_stay_as_they_are) {
  EXPECT_EQ(fit::markdown("models/six_body"), "models/six_body");
  EXPECT_EQ(fit::markdown("a|b *c* [d](e) `f` <g> & $h$ _i_ \\"),
            "a\\|b \\*c\\* \\[d\\](e) \\`f\\` \\<g\\> \\& \\$h\\$ \\_i\\_ \\\\");
  EXPECT_EQ(fit::markdown("# 1\n- 2"), "\\# 1\\\\x0a- 2");
}

TEST(Fit, code_is_longer_fenced_than_what_is_in_it) {
  EXPECT_EQ(fit::code("kanec report 'a b'"), "`kanec report 'a b'`");
  EXPECT_EQ(fit::code("a `` b"), "``` a `` b ```");
  EXPECT_EQ(fit::code("`"), "`` ` ``");
}

TEST(Fit, link_is_a_relative_path_and_no_scheme) {
  EXPECT_EQ(fit::link("../hard/far_away"), "../hard/far_away");
  EXPECT_EQ(fit::link("javascript:a b)\xff"), "javascript%3aa%20b%29%ff");
}

TEST(Fit, shell_hands_on_the_same_word_and_runs_nothing) {
  const auto bash = find_program("bash");
  if (!bash) GTEST_SKIP() << "bash is not installed";
  const Folder folder;
  std::string script = "cd " + fit::shell(folder.path().string()) + "\n", expected;
  for (const std::string& text : nasty_texts()) {
    if (text.find('\0') != std::string::npos) continue;
    script += "printf '%s' a" + fit::shell(text) + "\n";
    expected += "a" + text;
  }
  EXPECT_EQ(run_process({bash->string()}, script).output, expected);
  EXPECT_THAT(names(folder.path()), testing::IsEmpty());
}

TEST(Fit, shell_leaves_plain_words_and_quotes_the_others) {
  for (const char* word : {"models/six_body", "-O2", "-std=c++17", "a,b", "0.5", "/usr/bin/g++-12"})
    EXPECT_EQ(fit::shell(word), word);
  EXPECT_EQ(fit::shell(""), "''");
  EXPECT_EQ(fit::shell("a b"), "'a b'");
  EXPECT_EQ(fit::shell("it's"), "'it'\\''s'");
  EXPECT_EQ(fit::shell("PATH=x"), "'PATH=x'");
  EXPECT_EQ(fit::shell("a\n!"), "$'a\\012\\041'");
}

TEST(Fit, csv_quotes_what_would_end_a_field) {
  EXPECT_EQ(fit::csv("a b"), "a b");
  EXPECT_EQ(fit::csv("a,\"b\"\n"), "\"a,\"\"b\"\"\\x0a\"");
}

TEST(Fit, json_has_the_same_values_without_what_is_obeyed) {
  EXPECT_EQ(fit::json("{\n  \"a\": \"\u00e4\u202e\x7f\u0085\"\n}\n"),
            "{\n  \"a\": \"\u00e4\\u202e\\u007f\\u0085\"\n}\n");
}

TEST(Fit, toml_is_a_basic_string) {
  EXPECT_EQ(fit::toml("a\"\\\n\u202e"), "\"a\\\"\\\\\\u000a\\u202e\"");
  EXPECT_EQ(fit::toml("\xff"), "\"\\ufffd\"");
}

}  // namespace
}  // namespace kanec
