// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/elimination.hpp"

namespace kanec::lower {

using program::Builder;
using program::Ref;

namespace {

// Rows below the pivot that have an entry in its column, ascending.
std::vector<int> rows_of(const Entries& matrix, int pivot, int size) {
  std::vector<int> rows;
  for (int row = pivot + 1; row < size; ++row)
    if (matrix.count({row, pivot}) > 0) rows.push_back(row);
  return rows;
}

void subtract(Builder& builder, Entries& matrix, std::pair<int, int> at, Ref amount) {
  const auto known = matrix.find(at);
  if (known == matrix.end())
    matrix.emplace(at, -amount);
  else
    known->second = builder.subtract(known->second, amount);
}

}  // namespace

Elimination eliminate(Builder& builder, Entries matrix, std::vector<Ref> right) {
  const int n = static_cast<int>(right.size());
  Elimination result;
  std::vector<Ref> inverse;
  for (int pivot = 0; pivot < n; ++pivot) {
    const Ref d = matrix.at({pivot, pivot});
    result.pivots.push_back(d);
    inverse.push_back(builder.divide(builder.constant(1.0), d));
    const std::vector<int> rows = rows_of(matrix, pivot, n);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Ref a = matrix.at({rows[i], pivot});
      const Ref factor = builder.multiply(a, inverse.back());
      result.factors[{rows[i], pivot}] = factor;
      for (std::size_t j = 0; j <= i; ++j)
        subtract(builder, matrix, {rows[i], rows[j]}, builder.multiply(factor, matrix.at({rows[j], pivot})));
      const auto at = static_cast<std::size_t>(rows[i]);
      right[at] = builder.subtract(right[at], builder.multiply(factor, right[static_cast<std::size_t>(pivot)]));
    }
  }
  result.solution.resize(right.size());
  for (int row = n - 1; row >= 0; --row) {
    const auto at = static_cast<std::size_t>(row);
    Ref value = builder.multiply(right[at], inverse[at]);
    for (const int above : rows_of(result.factors, row, n))
      value = builder.subtract(
          value, builder.multiply(result.factors.at({above, row}), result.solution[static_cast<std::size_t>(above)]));
    result.solution[at] = value;
  }
  return result;
}

}  // namespace kanec::lower
