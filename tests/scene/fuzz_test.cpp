// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "generator/read/expression_names.hpp"
#include "generator/read/parse_expression.hpp"
#include "runtime/base/files.hpp"
#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

namespace fs = std::filesystem;

const fs::path seeds = fs::path(KANEC_SOURCE_DIR) / "tests/data/fuzz";

std::vector<fs::path> files(const std::string& folder) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(seeds / folder)) out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

bool is_good(const fs::path& path) { return path.filename().string().starts_with("good_"); }

// SplitMix64 (Steele, Lea, Flood 2014): the same numbers on every machine.
class Sequence {
 public:
  explicit Sequence(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }

 private:
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

constexpr std::array words = {"nan",         "-1",    "1e999",    "0",      "[",   "]",   "{ x = 'x' }",
                              "\"theta_1\"", "\"t\"", "'free'",   "true",   "^-(", "''",  "\n[",
                              "[[load]]",    "joint", "\"hold\"", "1e-320", ",",   "\xff"};

// Where the line that holds `at` begins, and where the next one does.
std::pair<std::size_t, std::size_t> line_at(const std::string& text, std::size_t at) {
  const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const std::size_t end = text.find('\n', at);
  return {before == std::string::npos ? 0 : before + 1, end == std::string::npos ? text.size() : end + 1};
}

// One change: a bit; a piece deleted or doubled; a word set in; a line deleted; what follows "= " a word; a digit.
std::string mutated(std::string text, Sequence& sequence) {
  const std::size_t at = sequence.below(text.size() + 1);
  const std::size_t length = std::min(text.size() - at, 1 + sequence.below(40));
  const std::string word = words[sequence.below(words.size())];
  const auto [begin, end] = line_at(text, at);
  switch (sequence.below(7)) {
    case 0:
      if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << sequence.below(8)));
      return text;
    case 1:
      return text.erase(at, length);
    case 2:
      return text.insert(at, text.substr(at, length));
    case 3:
      return text.insert(at, word);
    case 4:
      return text.erase(begin, end - begin);
    case 5:
      if (const std::size_t value = text.find("= ", begin); value < end)
        return text.replace(value + 2, text.find('\n', value) - value - 2, word);
      return text;
    default:
      if (const std::size_t digit = text.find_first_of("0123456789", at); digit != std::string::npos)
        text[digit] = static_cast<char>('0' + sequence.below(10));
      return text;
  }
}

// `visit` with the seed's mutations, of one to three changes each.
template <class Visit>
void for_mutations(const std::string& seed, int count, const Visit& visit) {
  Sequence sequence(seed.size());
  for (int i = 0; i < count; ++i) {
    std::string text = seed;
    for (std::size_t changes = 1 + sequence.below(3); changes > 0; --changes) text = mutated(std::move(text), sequence);
    visit(text);
  }
}

bool is_within(int index, std::size_t size) { return index >= 0 && index < static_cast<int>(size); }

bool is_sound(const Expression& expression, std::size_t nx, std::size_t ny, const Scene& scene) {
  using Kind = ExpressionNode::Kind;
  for (std::size_t i = 0; i < expression.nodes.size(); ++i) {
    const ExpressionNode& node = expression.nodes[i];
    if (node.kind == Kind::coordinate && !is_within(node.index, nx)) return false;
    if (node.kind == Kind::speed && !is_within(node.index, ny)) return false;
    if (node.kind == Kind::parameter && !is_within(node.index, scene.parameters.size())) return false;
    if (node.kind == Kind::input && !is_within(node.index, scene.inputs.size())) return false;
    const bool operates = node.kind >= Kind::negate;
    const bool two = operates && node.kind != Kind::negate && (node.kind != Kind::call || n_arguments(node.call) == 2);
    if (operates != is_within(node.a, i) || two != is_within(node.b, i)) return false;
  }
  return !expression.nodes.empty();
}

// What later stages take for granted.
void expect_sound(const Scene& scene) {
  const std::vector<double> x = initial_coordinates(scene), y = initial_speeds(scene);
  for (const double value : x) EXPECT_TRUE(std::isfinite(value));
  for (const double value : y) EXPECT_TRUE(std::isfinite(value));
  EXPECT_EQ(coordinate_names(scene).size(), x.size());
  EXPECT_EQ(speed_names(scene).size(), y.size());
  for (const Expression& expression : scene.expressions) EXPECT_TRUE(is_sound(expression, x.size(), y.size(), scene));
  for (const Load& load : scene.loads) {
    EXPECT_TRUE(is_within(load.point.body, scene.bodies.size() + 1));
    if (load.kind != Load::Kind::joint) continue;
    const Joint& joint = scene.bodies.at(static_cast<std::size_t>(load.point.body - 1)).joint;
    EXPECT_TRUE(is_within(load.coordinate, (load.turn ? joint.turns : joint.slides).size()));
  }
}

// A scene or an error of kanec; any other exception leaves the test.
bool reads(const std::string& text) {
  try {
    expect_sound(parse(text, "f"));
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(Fuzz, every_scene_of_the_corpus_is_what_it_says) {
  for (const fs::path& path : files("scenes")) EXPECT_EQ(reads(read_file(path)), is_good(path)) << path;
}

TEST(Fuzz, every_mutation_of_a_scene_is_a_scene_or_an_error) {
  int good = 0, bad = 0;
  for (const fs::path& path : files("scenes"))
    for_mutations(read_file(path), 300, [&](const std::string& text) { ++(reads(text) ? good : bad); });
  // both must occur often, else the mutations test nothing
  EXPECT_GT(good, 100);
  EXPECT_GT(bad, 100);
}

class FuzzExpressions : public testing::Test {
 protected:
  static Scene sample() {
    return parse("name = 'a'\nconnection = [0, 1, 2, 3]\n" + good_body("cart") + "joint = 'prismatic'\naxis = 'x'\n" +
                     good_body("arm") + "joint = 'revolute'\naxis = 'z'\n" + good_body("hub") + "joint = 'ball'\n" +
                     good_body("tool") + "joint = 'revolute'\naxis = 'x'\n[body.motion]\ntheta = 1\n" +
                     "[parameters]\na = 1\n[inputs]\nu = 1\n",
                 "f");
  }

  bool reads(const std::string& text) {
    try {
      EXPECT_TRUE(is_sound(parse_expression(text, {"f"}, names_), x_, y_, scene_)) << text;
      return true;
    } catch (const Error&) {
      return false;
    }
  }

  const Scene scene_ = sample();
  const std::vector<ExpressionName> names_ = names_for_loads(scene_);
  const std::size_t x_ = initial_coordinates(scene_).size(), y_ = initial_speeds(scene_).size();
};

TEST_F(FuzzExpressions, every_one_of_the_corpus_is_what_it_says) {
  for (const fs::path& path : files("expressions")) EXPECT_EQ(reads(read_file(path)), is_good(path)) << path;
}

TEST_F(FuzzExpressions, every_mutation_is_an_expression_or_an_error) {
  int good = 0, bad = 0;
  for (const fs::path& path : files("expressions"))
    for_mutations(read_file(path), 400, [&](const std::string& text) { ++(reads(text) ? good : bad); });
  EXPECT_GT(good, 100);
  EXPECT_GT(bad, 100);
}

}  // namespace
}  // namespace kanec::scene
