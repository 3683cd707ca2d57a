// A model's functions for many states at once, in lanes and, on request, in threads. Not: one state at a time
// (solver.hpp), nor how the batch was compiled (runtime/compile); the batch must outlive its solvers.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "runtime/abi/abi.h"
#include "runtime/base/workers.hpp"

namespace kanec {

// Where the states of a batch stand. Of an argument with n entries, entry i of state j is
// a[(j / stride * n + i) * stride + j % stride]: with stride = count, which 0 stands for, a[i * count + j]; with stride
// = lanes() blocks that need no copying, where a is aligned to a block's row: the fastest; with stride = 1 state after
// state, a[j * n + i], which are gathered. Other strides are multiples of lanes(). One of a large power of two is slow:
// rows fall on each other in the cache.
template <class Real>
struct BatchStates {
  std::int64_t count = 0;
  std::int64_t stride = 0;
  // What the function does not read may be null.
  const Real* t = nullptr;     // [s] (count), or one with one_time
  const Real* x = nullptr;     // (nx)
  const Real* y = nullptr;     // (ny)
  const Real* ydot = nullptr;  // (ny)
  const Real* u = nullptr;     // (n_inputs); null: those of set_inputs() for all states
  bool one_time = false;
};

// Real: double or float, as the batch was compiled. Results do not depend on the number of threads, nor on the other
// states. They differ from Solver's by rounding: lanes have libmvec's sine and cosine, and fuse other multiply-adds.
template <class Real>
class BatchSolver {
 public:
  // With the model's default parameters and inputs. threads: in all, 0: one a processor. LoadError where the batch was
  // compiled for another scalar.
  explicit BatchSolver(const kanec_batch& batch, int threads = 1);

  const kanec_batch& batch() const { return *batch_; }
  const kanec_model& model() const { return *batch_->model; }
  int lanes() const { return batch_->lanes; }

  void set_parameters(std::span<const double> parameters);  // for all states; InputError unless n_parameters
  void set_inputs(std::span<const double> inputs);          // for all states; InputError unless n_inputs
  // For each state of later batches its own, as BatchStates stand (stride 0: count). InputError where a later batch has
  // more states, or count is not positive.
  void set_parameters_each(std::int64_t count, const Real* parameters, std::int64_t stride = 0);

  // The number of the function of that name; empty where the batch was emitted without it.
  std::optional<int> find(std::string_view name) const;
  int n_out(int function) const { return model().functions[function].n_out; }

  // Results stand in `out` as arguments do: n_out entries a state. InputError for a stride that is neither.
  void evaluate(int function, const BatchStates<Real>& states, Real* out);
  // One thread, states begin .. end - 1, begin a multiple of the lanes; by the worker's own scratch. Safe from several
  // threads with different workers.
  void evaluate_part(int function, const BatchStates<Real>& states, Real* out, std::int64_t begin, std::int64_t end,
                     int worker) const;
  // One function for one full group of lanes, the `group`th of those with parameters of their own; x, y and out are
  // blocks (lanes() numbers an entry). Safe as evaluate_part.
  void evaluate_group(int function, std::int64_t group, Real t, const Real* x, const Real* y, Real* out,
                      int worker) const;
  // The prepared parameters of that group.
  const void* prepared(std::int64_t group) const;
  Workers& workers() const { return *workers_; }

 private:
  struct alignas(64) Line {
    unsigned char bytes[64];
  };

  void prepare(std::int64_t count, std::int64_t stride, const Real* parameters);
  void check(const BatchStates<Real>& states) const;

  const kanec_batch* batch_;
  std::unique_ptr<Workers> workers_;
  std::vector<Real> inputs_;
  std::vector<Line> prepared_;                    // one group for all, or one a group of lanes
  std::int64_t n_prepared_ = 0;                   // states with parameters of their own; 0: one set for all
  std::vector<std::unique_ptr<Line[]>> scratch_;  // of each worker
};

extern template class BatchSolver<double>;
extern template class BatchSolver<float>;

}  // namespace kanec
