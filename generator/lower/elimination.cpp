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

Factors factorised(Builder& builder, Entries matrix, int size) {
  Factors result;
  for (int pivot = 0; pivot < size; ++pivot) {
    const Ref d = matrix.at({pivot, pivot});
    result.pivots.push_back(d);
    result.inverses.push_back(builder.divide(builder.constant(1.0), d));
    const std::vector<int> rows = rows_of(matrix, pivot, size);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Ref factor = builder.multiply(matrix.at({rows[i], pivot}), result.inverses.back());
      result.lower[{rows[i], pivot}] = factor;
      for (std::size_t j = 0; j <= i; ++j)
        subtract(builder, matrix, {rows[i], rows[j]}, builder.multiply(factor, matrix.at({rows[j], pivot})));
    }
  }
  return result;
}

std::vector<Ref> solved(Builder& builder, const Factors& factors, std::vector<Ref> right) {
  const auto at = [&right](int row) -> Ref& { return right[static_cast<std::size_t>(row)]; };
  const int n = static_cast<int>(right.size());
  for (int pivot = 0; pivot < n; ++pivot)
    for (const int row : rows_of(factors.lower, pivot, n))
      at(row) = builder.subtract(at(row), builder.multiply(factors.lower.at({row, pivot}), at(pivot)));
  for (int row = n - 1; row >= 0; --row) {
    at(row) = builder.multiply(at(row), factors.inverses[static_cast<std::size_t>(row)]);
    for (const int above : rows_of(factors.lower, row, n))
      at(row) = builder.subtract(at(row), builder.multiply(factors.lower.at({above, row}), at(above)));
  }
  return right;
}

// From A⁻¹ = D⁻¹ L⁻¹ + (1 − Lᵀ) A⁻¹ the entries on and above the diagonal, from the last on.
std::vector<Ref> inverted(Builder& builder, const Factors& factors) {
  const int n = static_cast<int>(factors.pivots.size());
  std::vector<Ref> result(static_cast<std::size_t>(n * n));
  const auto at = [&](int i, int j) -> Ref& { return result[static_cast<std::size_t>(i * n + j)]; };
  for (int column = n - 1; column >= 0; --column)
    for (int row = column; row >= 0; --row) {
      Ref value = row == column ? factors.inverses[static_cast<std::size_t>(row)] : builder.constant(0.0);
      for (const int above : rows_of(factors.lower, row, n))
        value = builder.subtract(value, builder.multiply(factors.lower.at({above, row}), at(above, column)));
      at(row, column) = at(column, row) = value;
    }
  return result;
}

}  // namespace kanec::lower
