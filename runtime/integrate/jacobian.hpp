// The emitted derivatives of a system as one sparse matrix, by compressed columns. Not: linear systems
// (linear_solver.hpp), nor differences.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/integrate/system.hpp"

namespace kanec::integrate {

class Jacobian {
 public:
  // ∂ż/∂z of ż = g(t, z). Empty where the model has not all that it is made of.
  static std::optional<Jacobian> of_rates(const System& system);
  // ∂F/∂z + c ∂F/∂ż of F(t, z, ż) (System::residual). Likewise.
  static std::optional<Jacobian> of_residual(const System& system);

  // The functions that these are made of, as the generator is asked for them: "kinematics_x+kinematics_y+...".
  static std::string request_of_rates(bool has_work);
  static std::string request_of_residual(bool has_work);

  // False where an entry is not finite. zdot and c are read of a residual's alone. No allocation.
  bool evaluate(double t, const double* z, const double* zdot, double c) noexcept;
  std::int64_t evaluations() const { return evaluations_; }

  // Square, the diagonal always among the entries: column j has those from starts[j] to starts[j + 1] - 1.
  int size() const { return static_cast<int>(starts_.size()) - 1; }
  std::span<const std::int64_t> starts() const { return starts_; }
  std::span<const std::int64_t> rows() const { return rows_; }
  std::span<const double> values() const { return values_; }

 private:
  // A matrix among the results of the function: where it stands there and in the whole, and what it counts for.
  struct Block {
    std::string name;
    int row, column;
    double sign = 1.0;
    bool by_c = false;  // times c
  };
  // values_[entry] += sign results_[source]
  struct Term {
    std::int64_t entry;
    std::int64_t source;
    double sign;
    bool by_c;
  };

  static std::optional<Jacobian> made_of(const System& system, const std::vector<Block>& blocks,
                                         std::vector<int> diagonal);
  static std::vector<Block> rate_blocks(int nx, int ny, bool has_work);
  static std::vector<Block> residual_blocks(int nx, int ny, bool has_work);

  const System* system_ = nullptr;
  const kanec_function* function_ = nullptr;
  std::vector<std::int64_t> starts_, rows_;
  std::vector<Term> terms_;
  std::vector<std::int64_t> by_c_;  // entries to which c is added
  std::vector<double> results_, values_;
  std::int64_t evaluations_ = 0;
};

}  // namespace kanec::integrate
