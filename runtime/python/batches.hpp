// A model's functions compiled for many states, each when it is first asked for. Not: arrays of Python (function.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "kanec/kanec.hpp"

namespace kanec::python {

// A value given by keyword: a number for all states, or one for each.
struct Given {
  int number = 0;  // among the model's parameters, then inputs
  double value = 0.0;
  std::span<const double> each = {};
};

// What many states are evaluated with, beside the states themselves.
struct Values {
  const Evaluator* defaults = nullptr;
  std::vector<Given> given = {};
};

// May be called from several threads at once, without Python's lock: they take turns, as each call has all threads.
class Batches {
 public:
  Batches(Scene scene, Emission emission, Compilation compilation, int threads);

  // states.inputs are left to `values`.
  template <class Real>
  void evaluate(const std::string& request, StatesView<Real> states, const Values& values, std::span<Real> out);

 private:
  struct Slot {
    Batch batch;
    Function function;
    std::vector<int> parameters, inputs;  // of the batch, as numbers among the model's
  };
  Slot& slot(const std::string& request, bool in_float, const Model& model);

  Scene scene_;
  Emission emission_;
  Compilation compilation_;
  int threads_;
  std::mutex turn_;
  std::map<std::pair<std::string, bool>, std::unique_ptr<Slot>> slots_;  // by request, and whether in float
};

}  // namespace kanec::python
