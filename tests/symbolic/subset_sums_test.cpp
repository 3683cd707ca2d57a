// Oracle: the sum over a set written out term by term, and one addition a child for sums over nested subtrees.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "generator/symbolic/partials.hpp"
#include "tests/support/random_scene.hpp"
#include "tests/symbolic/closed_forms.hpp"

namespace kanec::symbolic {
namespace {

using GiNaC::ex;

std::vector<ex> masses(const Derivation& derivation) {
  std::vector<ex> terms = {ex(0)};
  for (int k = 1; k <= derivation.size(); ++k) terms.push_back(derivation.letters(k).mass);
  return terms;
}

// Bodies of the subtree that K carries, itself included, ascending.
std::vector<int> subtree(const Derivation& derivation, int k) {
  std::vector<int> bodies = {k};
  for (int c = k + 1; c <= derivation.size(); ++c)
    if (std::find(bodies.begin(), bodies.end(), derivation.lower(c)) != bodies.end()) bodies.push_back(c);
  return bodies;
}

ex plain_sum(const std::vector<ex>& terms, const std::vector<int>& bodies) {
  ex result = 0;
  for (const int k : bodies) result += terms[static_cast<std::size_t>(k)];
  return result;
}

// Names of sums replaced by what they stand for.
ex written_in_terms(const Derivation& derivation, ex e) {
  const auto& quantities = derivation.equations.quantities;
  for (auto quantity = quantities.rbegin(); quantity != quantities.rend(); ++quantity)
    e = e.subs(quantity->symbol == quantity->value, GiNaC::subs_options::no_pattern);
  return e;
}

TEST(SubsetSums, over_subtrees_from_the_leaves_cost_one_addition_a_child) {
  for (const scene::Scene& scene : sample_scenes()) {
    Derivation derivation(scene);
    const std::size_t before = derivation.equations.quantities.size();
    SubsetSums sums(masses(derivation), "m_sub", "m", "");
    int n_children = 0;
    for (int k = derivation.size(); k >= 1; --k) {
      const ex sum = sums.over(derivation, subtree(derivation, k));
      EXPECT_TRUE(written_in_terms(derivation, sum).is_equal(plain_sum(masses(derivation), subtree(derivation, k))));
      n_children += derivation.lower(k) > 0;
    }
    int n_additions = 0;
    for (std::size_t i = before; i < derivation.equations.quantities.size(); ++i)
      n_additions += static_cast<int>(derivation.equations.quantities[i].value.nops()) - 1;
    EXPECT_EQ(n_additions, n_children);
  }
}

TEST(SubsetSums, of_any_sets_in_any_order_have_their_terms) {
  test::Random random(3);
  Derivation derivation(test::random_scene(random, 9));
  SubsetSums sums(masses(derivation), "m_sub", "m", "");
  for (int i = 0; i < 100; ++i) {
    std::vector<int> bodies;
    for (int k = 1; k <= 9; ++k)
      if (random.chance(0.5)) bodies.push_back(k);
    if (bodies.empty()) continue;
    const ex sum = sums.over(derivation, bodies);
    EXPECT_TRUE(written_in_terms(derivation, sum).is_equal(plain_sum(masses(derivation), bodies)));
  }
}

TEST(SubsetSums, of_one_body_are_its_term_and_of_a_known_set_its_name) {
  test::Random random(4);
  Derivation derivation(test::random_scene(random, 5));
  SubsetSums sums(masses(derivation), "m_sub", "m", "");
  EXPECT_TRUE(sums.over(derivation, {3}).is_equal(derivation.letters(3).mass));
  const std::size_t before = derivation.equations.quantities.size();
  const ex sum = sums.over(derivation, {2, 4});
  EXPECT_TRUE(sums.over(derivation, {2, 4}).is_equal(sum));
  ASSERT_EQ(derivation.equations.quantities.size(), before + 1);
  EXPECT_EQ(derivation.equations.quantities.back().body, 2);
}

TEST(Groups, hold_the_bodies_of_one_block) {
  const ex a = GiNaC::symbol("a");
  const ex b = GiNaC::symbol("b");
  const std::vector<Group> found = groups({{{0, a}}, {{0, b}, {1, a}}, {}, {{0, a}}}, 0);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found[0].block.is_equal(a));
  EXPECT_EQ(found[0].bodies, (std::vector<int>{1, 4}));
  EXPECT_TRUE(found[1].block.is_equal(b));
  EXPECT_EQ(found[1].bodies, (std::vector<int>{2}));
}

}  // namespace
}  // namespace kanec::symbolic
