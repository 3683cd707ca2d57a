// Symmetric systems of a tree's pattern. Oracle: the matrix times the solution, exactly in a prime field.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/elimination.hpp"

#include <gtest/gtest.h>

#include "generator/program/evaluate.hpp"
#include "tests/program/field.hpp"

namespace kanec::lower {
namespace {

using program::Builder;
using program::Group;
using program::Ref;
using test::Field;
using test::Random;

// Rows from the leaves inward: row i is coupled with the rows on its way to the root, no others.
struct System {
  explicit System(std::uint64_t seed) {
    Random random(seed);
    for (int i = 0; i + 1 < n; ++i) next.push_back(i + 1 + random.below(std::min(3, n - 1 - i)));
    for (int j = 0; j < n; ++j)
      for (int i = j; i >= 0; i = i + 1 < n ? next[static_cast<std::size_t>(i)] : -1) {
        const int index = static_cast<int>(values.size());
        values.push_back(Field::random(random));
        matrix[{i, j}] = builder.variable(Group::x, index);
        place[{i, j}] = place[{j, i}] = index;
      }
  }

  Field A(int i, int j) const {
    const auto found = place.find({i, j});
    return found == place.end() ? Field(0.0) : values[static_cast<std::size_t>(found->second)];
  }
  std::vector<Field> evaluated(const std::vector<Ref>& results) {
    program::Function function{"f", "", {}, results, {}, static_cast<program::Index>(results.size())};
    return program::evaluate(program::Program{{}, builder.nodes(), {}}, function,
                             program::Arguments<Field>{{}, values, {}, {}, {}, Field(0.0)});
  }

  static constexpr int n = 9;
  std::vector<int> next;
  Builder builder;
  Entries matrix;
  std::map<std::pair<int, int>, int> place;
  std::vector<Field> values;
};

class Elimination : public testing::TestWithParam<std::uint64_t> {
 protected:
  System system{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Seeds, Elimination, testing::Range<std::uint64_t>(0, 20));

TEST_P(Elimination, solves_the_system) {
  std::vector<Ref> right;
  for (int i = 0; i < System::n; ++i) right.push_back(system.builder.variable(Group::x, i));
  const Factors factors = factorised(system.builder, system.matrix, System::n);
  const std::vector<Field> x = system.evaluated(solved(system.builder, factors, right));
  for (int i = 0; i < System::n; ++i) {
    Field sum(0.0);
    for (int j = 0; j < System::n; ++j) sum = sum + system.A(i, j) * x[static_cast<std::size_t>(j)];
    EXPECT_EQ(sum, system.values[static_cast<std::size_t>(i)]);
  }
}

TEST_P(Elimination, fills_in_nothing) {
  for (const auto& [at, factor] : factorised(system.builder, system.matrix, System::n).lower)
    EXPECT_EQ(system.matrix.count(at), 1U);
}

TEST_P(Elimination, gives_the_inverse) {
  const Factors factors = factorised(system.builder, system.matrix, System::n);
  const std::vector<Field> inverse = system.evaluated(inverted(system.builder, factors));
  for (int i = 0; i < System::n; ++i)
    for (int j = 0; j < System::n; ++j) {
      Field sum(0.0);
      for (int k = 0; k < System::n; ++k)
        sum = sum + system.A(i, k) * inverse[static_cast<std::size_t>(k * System::n + j)];
      EXPECT_EQ(sum, Field(i == j ? 1.0 : 0.0)) << i << ", " << j;
    }
}

}  // namespace
}  // namespace kanec::lower
