// GiNaC sorts by hashes that depend on which symbols were made before. Oracle: the text of the first derivation.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/order.hpp"

#include <gtest/gtest.h>

#include "generator/symbolic/derive.hpp"
#include "generator/tables/tables.hpp"
#include "tests/symbolic/alphabet.hpp"
#include "tests/symbolic/closed_forms.hpp"

namespace kanec::symbolic {
namespace {

using GiNaC::ex;

std::string everything(const Equations& equations) {
  std::string text = emit::text_document(equations);
  for (const Quantity& quantity : equations.quantities)
    text += notation(quantity.symbol, equations.table, Style::text) + " = " +
            notation(quantity.value, equations.table, Style::text) + "\n";
  return text;
}

TEST(Order, derivation_reads_the_same_whatever_symbols_were_made_before) {
  const std::vector<scene::Scene> scenes = sample_scenes();
  std::vector<std::string> texts;
  for (const scene::Scene& scene : scenes) texts.push_back(everything(derive(scene)));
  for (int round = 1; round <= 5; ++round) {
    std::vector<GiNaC::symbol> others(static_cast<std::size_t>(round * round * 37));
    for (std::size_t i = 0; i < scenes.size(); ++i) ASSERT_EQ(everything(derive(scenes[i])), texts[i]);
  }
}

TEST(Order, operands_follow_their_letters_numbers_first) {
  for (int round = 0; round < 20; ++round) {
    const Alphabet l;  // new symbols, new hashes
    const std::vector<ex> sum = ordered(l.R * l.c + l.a + skew(l.b) * l.c - l.R * l.b);
    ASSERT_EQ(sum.size(), 4u);
    EXPECT_TRUE(sum[0].is_equal(l.a));
    EXPECT_TRUE(sum[1].is_equal(skew(l.b) * l.c));
    EXPECT_TRUE(sum[2].is_equal(-l.R * l.b) || sum[2].is_equal(l.R * l.c));
    const std::vector<ex> product = ordered(l.n * l.m * 3 * (l.R * l.a));
    ASSERT_EQ(product.size(), 4u);
    EXPECT_TRUE(product[0].is_equal(3));
    EXPECT_TRUE(product[1].is_equal(l.m));
    EXPECT_TRUE(product[2].is_equal(l.n));
    EXPECT_TRUE(product[3].is_equal(l.R * l.a));
  }
}

TEST(Order, precedes_is_a_strict_order_that_does_not_depend_on_hashes) {
  std::vector<bool> first;
  for (int round = 0; round < 20; ++round) {
    const Alphabet l;
    const std::vector<ex> factors = {l.a, l.b, l.R, skew(l.a), skew(l.b), l.R * l.a, skew(l.a) * l.b, l.a + l.b, l.m};
    std::vector<bool> found;
    for (const ex& u : factors)
      for (const ex& v : factors) {
        found.push_back(precedes(u, v));
        EXPECT_EQ(precedes(u, v) || precedes(v, u), !u.is_equal(v)) << u << " and " << v;
        EXPECT_FALSE(precedes(u, v) && precedes(v, u));
      }
    if (round == 0) first = found;
    EXPECT_EQ(found, first);
  }
}

}  // namespace
}  // namespace kanec::symbolic
