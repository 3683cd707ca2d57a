// Oracles: texts written by hand; strtod of the C library as the reader of printed numbers.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace kanec {
namespace {

TEST(Text, number_is_printed_as_shortest_text) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(2.0), "2");
  EXPECT_EQ(shortest(-0.0), "-0");
  EXPECT_EQ(shortest(1e-300), "1e-300");
  EXPECT_EQ(shortest(9.80665), "9.80665");
  EXPECT_EQ(shortest(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(shortest(std::numeric_limits<double>::denorm_min()), "5e-324");
  EXPECT_EQ(shortest(-std::numeric_limits<double>::max()), "-1.7976931348623157e+308");
}

TEST(Text, number_reads_back_to_the_same_bits) {
  std::mt19937_64 random(20240517);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const double back = std::strtod(shortest(value).c_str(), nullptr);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value)) << shortest(value);
  }
}

TEST(Text, identifiers_are_those_of_cpp_without_reserved_ones) {
  for (const char* name : {"a", "Arm", "six_body", "b2", "a_", "override", "z9_Z"})
    EXPECT_TRUE(is_identifier(name)) << name;
  for (const char* name :
       {"", "2b", "_a", "a__b", "a-b", "a b", "a.b", "a/b", "\xc3\xa4", "a\n", "class", "and", "char8_t", "xor_eq"})
    EXPECT_FALSE(is_identifier(name)) << name;
}

TEST(Text, identifier_ends_at_63_characters) {
  EXPECT_TRUE(is_identifier(std::string(63, 'a')));
  EXPECT_FALSE(is_identifier(std::string(64, 'a')));
}

TEST(Text, nearest_known_name_is_found) {
  const std::vector<std::string> known = {"mass", "inertia", "gravity", "connection"};
  EXPECT_EQ(nearest("mas", known), "mass");
  EXPECT_EQ(nearest("Gravity", known), "gravity");
  EXPECT_EQ(nearest("conection", known), "connection");
  EXPECT_EQ(nearest("inertai", known), "inertia");
  EXPECT_EQ(nearest("mass", known), "mass");
}

TEST(Text, nothing_is_near_an_unlike_name) {
  EXPECT_EQ(nearest("temperature", {"mass", "inertia", "gravity"}), "");
  EXPECT_EQ(nearest("mass", {}), "");
}

TEST(Text, first_of_equally_near_names_is_taken) { EXPECT_EQ(nearest("ax", {"ab", "ac"}), "ab"); }

}  // namespace
}  // namespace kanec
