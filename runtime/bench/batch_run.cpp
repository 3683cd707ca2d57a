// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/bench/batch_run.hpp"

#include <algorithm>
#include <limits>

#include "runtime/abi/batch_solver.hpp"
#include "runtime/base/error.hpp"

namespace kanec {
namespace {

// Entries of all states in blocks of `stride` states, aligned as lanes are.
template <class Real>
class Blocks {
 public:
  Blocks(std::size_t n_entries, std::size_t n_states, std::size_t stride)
      : n_entries_(n_entries), stride_(stride), lines_(n_entries * n_states / per_line + 1) {}

  Real& at(std::size_t entry, std::size_t state) {
    return data()[(state / stride_ * n_entries_ + entry) * stride_ + state % stride_];
  }
  Real* data() { return lines_.front().entries; }
  const Real* data() const { return lines_.front().entries; }

 private:
  static constexpr std::size_t per_line = 64 / sizeof(Real);
  struct alignas(64) Line {
    Real entries[per_line];
  };

  std::size_t n_entries_, stride_;
  std::vector<Line> lines_;
};

template <class Real>
class Run : public BatchRun {
 public:
  Run(const kanec_batch& batch, const std::vector<State>& pool)
      : solver_(batch),
        count_(pool.size()),
        x_(blocks(pool.front().x.size())),
        y_(blocks(pool.front().y.size())),
        ydot_(blocks(pool.front().ydot.size())),
        out_(blocks(most_results(*batch.model))) {
    for (std::size_t j = 0; j < count_; ++j) {
      t_.push_back(static_cast<Real>(pool[j].t));
      fill(x_, j, pool[j].x);
      fill(y_, j, pool[j].y);
      fill(ydot_, j, pool[j].ydot);
    }
  }

  int find(const std::string& function) const override {
    const std::optional<int> found = solver_.find(function);
    if (!found) throw InternalError("a batch without " + function);
    return *found;
  }

  void evaluate(int function) override {
    const auto count = static_cast<std::int64_t>(count_);
    solver_.evaluate(function, {count, solver_.lanes(), t_.data(), x_.data(), y_.data(), ydot_.data()}, out_.data());
  }

  // Results of another function stand in blocks of another size.
  std::vector<long double> result(int function, std::size_t state) const override {
    const auto n = static_cast<std::size_t>(solver_.n_out(function)), stride = lanes();
    std::vector<long double> list;
    for (std::size_t i = 0; i < n; ++i) list.push_back(out_.data()[(state / stride * n + i) * stride + state % stride]);
    return list;
  }

  double rounding() const override { return static_cast<double>(std::numeric_limits<Real>::epsilon()) / 2; }

 private:
  std::size_t lanes() const { return static_cast<std::size_t>(solver_.lanes()); }
  Blocks<Real> blocks(std::size_t n_entries) const { return {n_entries, count_, lanes()}; }

  static std::size_t most_results(const kanec_model& model) {
    int most = 1;
    for (int i = 0; i < model.n_functions; ++i) most = std::max(most, static_cast<int>(model.functions[i].n_out));
    return static_cast<std::size_t>(most);
  }

  static void fill(Blocks<Real>& blocks, std::size_t state, const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) blocks.at(i, state) = static_cast<Real>(values[i]);
  }

  BatchSolver<Real> solver_;
  std::size_t count_;
  std::vector<Real> t_;
  Blocks<Real> x_, y_, ydot_, out_;
};

}  // namespace

std::unique_ptr<BatchRun> batch_run(const kanec_batch& batch, const std::vector<State>& pool) {
  if (batch.scalar_size == sizeof(float)) return std::make_unique<Run<float>>(batch, pool);
  return std::make_unique<Run<double>>(batch, pool);
}

}  // namespace kanec
