// A compiled batch with a pool of states in blocks of its lanes: how emitted code is timed in lanes. Not: batches in
// use (runtime/abi/batch_solver.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/abi/abi.h"
#include "runtime/model/state_file.hpp"

namespace kanec {

class BatchRun {
 public:
  virtual ~BatchRun() = default;

  // The number of a function, InternalError where the batch has none of that name.
  virtual int find(const std::string& function) const = 0;
  // All states of the pool, in one thread, with the scene's default parameters and inputs.
  virtual void evaluate(int function) = 0;
  // Of one state, after evaluate().
  virtual std::vector<long double> result(int function, std::size_t state) const = 0;
  // 2^-53 of double, 2^-24 of float.
  virtual double rounding() const = 0;
};

// In the batch's own scalar. The pool has whole blocks of lanes. The batch must outlive it.
std::unique_ptr<BatchRun> batch_run(const kanec_batch& batch, const std::vector<State>& pool);

}  // namespace kanec
