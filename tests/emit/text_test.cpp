// The text of emitted headers: the contract that a reader and a version control system rely on. Oracle: rules on the
// text, and headers emitted under other circumstances.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

#include "generator/emit/section.hpp"
#include "generator/emit/statements.hpp"
#include "generator/pipeline.hpp"
#include "generator/read/read.hpp"
#include "runtime/base/process.hpp"
#include "tests/emit/every_node.hpp"
#include "tests/emit/shipped.hpp"
#include "tests/support/random_scene.hpp"

namespace kanec::test {
namespace {

std::vector<scene::Scene> sample_scenes() {
  Random random(14);
  std::vector<scene::Scene> scenes = {shipped("free_body"), shipped("six_body"),
                                      scene::from_connection({0, 1, 1, 0, 3})};
  scenes.push_back(random_scene(random, 9, {.parameter_share = 0.3, .input_share = 0.3, .zero_share = 0.3}));
  scenes.push_back(random_scene(random, 4));
  scenes.back().name = std::string(63, 'n');
  for (scene::Body& body : scenes.back().bodies) body.name.append(50, 'b');
  scenes.back().inputs = {{std::string(63, 'u'), 1}};
  scenes.back().bodies[1].force[0] = scene::Number::input(0);
  return scenes;
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> list;
  for (std::string line; std::getline(stream, line);) list.push_back(line);
  return list;
}

std::vector<std::string> sample_headers() {
  std::vector<std::string> headers = {every_node_model(every_node_sample().scene).header};
  for (const scene::Scene& scene : sample_scenes()) headers.push_back(generate(scene).header);
  return headers;
}

TEST(Header, has_ascii_lines_of_at_most_120_columns_and_ends_with_one) {
  for (const std::string& header : sample_headers()) {
    EXPECT_EQ(header.back(), '\n');
    EXPECT_NE(header[header.size() - 2], '\n');
    for (const std::string& line : lines(header)) {
      EXPECT_LE(line.size(), 120u) << line;
      EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
      EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; })) << line;
    }
  }
}

// What comments say is another matter: "new" may stand there. A choice between two values is no branch.
TEST(Header, allocates_throws_branches_and_keeps_nothing) {
  const std::regex forbidden(
      "\\b(new|delete|malloc|free|std::vector|std::string|throw|try|catch|thread_local|mutable|extern|virtual|goto|if|"
      "while|switch|asm|volatile|abort|exit|printf|iostream|rand|time)\\b");
  for (const std::string& header : sample_headers())
    for (std::string line : lines(header)) {
      line = line.substr(0, line.find("//"));
      EXPECT_FALSE(std::regex_search(line, forbidden)) << line;
      const bool holds_state = std::regex_search(line, std::regex("\\bstatic\\b")) &&
                               line.find("static constexpr int places[][2]") == std::string::npos;
      EXPECT_FALSE(holds_state) << line;
      // nothing but constants outside of functions and structs
      EXPECT_TRUE(line.rfind("inline", 0) != 0 || line.rfind("inline constexpr int", 0) == 0 ||
                  line.rfind("inline constexpr char", 0) == 0)
          << line;
    }
}

TEST(Header, every_function_is_noexcept) {
  const std::string header = generate(shipped("six_body")).header;
  const auto count = [&](const char* pattern) {
    const std::regex regex(pattern);
    return std::distance(std::sregex_iterator(header.begin(), header.end(), regex), std::sregex_iterator());
  };
  EXPECT_EQ(count("\ntemplate <class T>\n(void|constexpr Prepared<T>) "), 12);
  EXPECT_EQ(count("\\)\\s+noexcept \\{\n"), 12);
}

TEST(Header, includes_nothing_where_it_needs_nothing) {
  const std::string header = generate(shipped("six_body")).header;
  EXPECT_EQ(header.find("#include"), std::string::npos);
  EXPECT_NE(header.find("#pragma once\n"), std::string::npos);
}

TEST(Header, has_no_struct_of_inputs_and_no_argument_for_them_where_no_function_reads_one) {
  EXPECT_EQ(generate(shipped("free_body")).header.find("Inputs"), std::string::npos);
  EXPECT_NE(generate(shipped("six_body")).header.find("const Inputs<T>& u, T* ydot)"), std::string::npos);
}

TEST(Header, says_what_it_is_of_where_it_comes_from_and_what_it_costs) {
  const Generated generated = generate(shipped("six_body"));
  const std::string top = generated.header.substr(0, generated.header.find("#pragma once"));
  for (const std::string& part :
       {"six_body: equations of motion of 6 rigid bodies, made by kanec " + version(), generated.hash,
        std::string("the usual functions"), std::string("//   3 panel on 2: free\n"),
        std::string("//   1 hub on the inertial frame: free\n"), std::string("Units SI"),
        std::string("residual                1237 (619 add, 618 multiply)")})
    EXPECT_NE(top.find(part), std::string::npos) << part;
}

TEST(Header, is_the_same_twice_and_after_other_scenes) {
  for (const scene::Scene& scene : sample_scenes()) {
    const Generated first = generate(scene);
    generate(shipped("random_12"));
    const Generated second = generate(scene);
    EXPECT_EQ(first.header, second.header) << scene.name;
    EXPECT_EQ(first.abi, second.abi) << scene.name;
  }
}

// Hashes in GiNaC depend on addresses, which differ from process to process.
TEST(Header, is_the_same_in_every_process) {
  const scene::Scene scene = shipped("six_body");
  const std::string expected = generate(scene).header;
  for (int i = 0; i < 5; ++i) {
    const ProcessResult result =
        run_process({KANEC_BINARY_DIR "/tests/print_header", KANEC_SOURCE_DIR "/models/six_body/scene.toml"});
    ASSERT_EQ(result.status, 0) << result.output;
    EXPECT_TRUE(result.output == expected);
  }
}

// The sections of one function by their headings: "body 3 (panel) on body 2".
std::map<std::string, std::string> sections(const std::string& header, const std::string& function) {
  const std::size_t from = header.find("\nvoid " + function + "(");
  const std::string text = header.substr(from, header.find("\n}\n", from) - from);
  std::map<std::string, std::string> found;
  const std::string mark = "\n  // ---- ";
  for (std::size_t at = text.find(mark); at != std::string::npos;) {
    const std::size_t next = text.find(mark, at + 1);
    const std::size_t end_of_line = text.find('\n', at + 1);
    found[text.substr(at + mark.size(), end_of_line - at - mark.size())] = text.substr(end_of_line, next - end_of_line);
    at = next;
  }
  return found;
}

// Sections of `function` that differ between two scenes.
std::vector<std::string> changed(const scene::Scene& a, const scene::Scene& b, const std::string& function) {
  const auto before = sections(generate(a).header, function);
  const auto after = sections(generate(b).header, function);
  std::vector<std::string> headings;
  for (const auto& [heading, text] : before) {
    const auto found = after.find(heading);
    if (found == after.end() || found->second != text) headings.push_back(heading);
  }
  EXPECT_EQ(before.size(), after.size());
  return headings;
}

using testing::Each;
using testing::ElementsAre;
using testing::StartsWith;

// Oracle: the contract that a change to one body leaves the sections of others alone.
class OneBodyChanged : public testing::Test {
 protected:
  const scene::Scene before = shipped("six_body");
  scene::Scene after = before;
  scene::Body& panel = after.bodies[2];
};

TEST_F(OneBodyChanged, in_nothing_differs_in_nothing) {
  EXPECT_THAT(changed(before, after, "accelerations"), testing::IsEmpty());
}

TEST_F(OneBodyChanged, by_its_mass_differs_in_its_own_sections) {
  panel.mass = scene::Number::constant(1.9);
  for (const char* function : {"accelerations", "forcing", "residual"})
    EXPECT_THAT(changed(before, after, function), ElementsAre("body 3 (panel) on body 2")) << function;
}

TEST_F(OneBodyChanged, by_its_inertia_differs_in_its_own_sections) {
  panel.inertia.xy = {};
  for (const char* function : {"accelerations", "forcing", "residual", "energy", "momentum"})
    EXPECT_THAT(changed(before, after, function), ElementsAre("body 3 (panel) on body 2")) << function;
}

// Values of the same sign: a zero or another sign is felt by sums elsewhere.
TEST_F(OneBodyChanged, by_its_mass_centre_joint_point_and_loads_differs_in_its_own_sections) {
  const auto enlarged = [](scene::Vector& v) {
    for (scene::Number& number : v) number.value *= 1.01;
  };
  for (scene::Vector* vector : {&panel.r, &panel.q, &panel.force, &panel.moment}) enlarged(*vector);
  for (const char* function : {"accelerations", "forcing", "residual", "energy", "momentum", "poses"})
    EXPECT_THAT(changed(before, after, function), Each(StartsWith("body 3 (panel)"))) << function;
}

TEST_F(OneBodyChanged, to_a_parameter_differs_in_its_own_sections) {
  after.parameters.push_back({"m_panel", 1.8});
  panel.mass = panel.inertia.xx = scene::Number::parameter(1);
  for (const char* function : {"accelerations", "forcing", "residual"})
    EXPECT_THAT(changed(before, after, function), ElementsAre("body 3 (panel) on body 2")) << function;
}

TEST(Literal, reads_back_as_the_same_double_and_is_no_integer_beyond_int) {
  for (const auto& [value, text] : std::map<double, std::string>{{0.1, "0.1"},
                                                                 {2, "2"},
                                                                 {-3.5, "-3.5"},
                                                                 {123456789, "123456789"},
                                                                 {4294967296, "4294967296.0"},
                                                                 {12345678901234567168.0, "12345678901234567168.0"},
                                                                 {1e22, "1e+22"},
                                                                 {1e-300, "1e-300"}}) {
    EXPECT_EQ(emit::literal(value), text);
    EXPECT_EQ(std::stod(emit::literal(value)), value);
  }
}

TEST(Wrapped, breaks_long_lines_at_blanks_and_keeps_what_cannot_be_broken) {
  EXPECT_THAT(emit::wrapped("short", "  "), ElementsAre("short"));
  const std::string word(60, 'a');
  EXPECT_THAT(emit::wrapped("  " + word + " " + word + " b", "    "), ElementsAre("  " + word, "    " + word + " b"));
  const std::string held = word + emit::no_break + word;
  EXPECT_THAT(emit::wrapped("a " + held, ""), ElementsAre("a", word + " " + word));
  const std::string unbroken(130, 'c');
  EXPECT_THAT(emit::wrapped("  // " + unbroken, "  //   "), ElementsAre("  // " + unbroken));
}

// Patterns of large matrices are such lists: 7 MB, 62,500 lines.
TEST(Wrapped, breaks_a_list_of_a_million_entries) {
  std::string list;
  for (int i = 0; i < 1'000'000; ++i) list += (i == 0 ? "" : " ") + std::to_string(100'000 + i % 900'000);
  const std::vector<std::string> lines = emit::wrapped(list, "    ");
  ASSERT_EQ(lines.size(), 62'500u);
  EXPECT_EQ(lines.front().size(), 118u);
  std::string again = lines[0];
  for (std::size_t i = 1; i < lines.size(); ++i) again += " " + lines[i].substr(4);
  EXPECT_EQ(again, list);
}

}  // namespace
}  // namespace kanec::test
