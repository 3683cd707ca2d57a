// A model's functions for many states at once, in lanes and threads. Not: one state (model.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "kanec/model.hpp"

struct kanec_batch;

namespace kanec {

// How the numbers of many states stand, of n a state.
enum class Order {
  states,   // state after state (count × n, row by row)
  entries,  // entry after entry (n × count): a little faster
};

// What the function does not read may be empty.
template <class Real>
struct StatesView {
  std::int64_t count = 0;
  Order order = Order::states;        // of x, y, ydot, inputs and of the results
  std::span<const Real> t = {};       // [s] (count), or one for all; empty: 0
  std::span<const Real> x = {};       // (count × nx)
  std::span<const Real> y = {};       // (count × ny)
  std::span<const Real> ydot = {};    // (count × ny)
  std::span<const Real> inputs = {};  // (count × the model's inputs); empty: those that were set, for all
};

// Results do not depend on the number of threads, nor on the other states. They differ from Evaluator's by rounding:
// lanes have sines and cosines of their own. Moved, not copied; from one thread at a time.
class KANEC_API Batch {
 public:
  // A shared library of a batch. threads: in all, 0: one a processor. Throws FileError, LoadError.
  static Batch load(const std::filesystem::path& library, int threads = 0);
  // A batch that something else keeps loaded as long as `model`, which is the batch's.
  Batch(const kanec_batch& batch, Model model, int threads);
  Batch(Batch&&) noexcept;
  Batch& operator=(Batch&&) noexcept;
  ~Batch();

  const Model& model() const;  // names and sizes; its functions cannot be evaluated one by one
  int lanes() const;           // states that are computed at once
  bool is_float() const;       // compiled for float, else for double
  int threads() const;

  // For all states. Throw InputError as Evaluator does.
  void set_parameters(std::span<const double> values);
  void set_inputs(std::span<const double> values);
  void set_parameter(std::string_view name, double value);
  void set_input(std::string_view name, double value);
  // For each state its own (count × parameters); later batches have as many states at most.
  void set_parameters_each(std::int64_t count, std::span<const double> values, Order order = Order::states);

  // Into out (count × function.size). Throws InputError for arguments of another size, and for a batch of the other
  // kind of number.
  void evaluate(const Function& function, const StatesView<double>& states, std::span<double> out);
  void evaluate(const Function& function, const StatesView<float>& states, std::span<float> out);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace kanec
