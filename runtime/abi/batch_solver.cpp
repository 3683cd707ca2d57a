// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/abi/batch_solver.hpp"

#include <algorithm>
#include <string>

#include "runtime/base/error.hpp"

namespace kanec {
namespace {

constexpr std::int64_t piece_states = 256;  // what a thread takes at once: some ten microseconds

std::span<const double> batch_list(const double* values, int count) { return {values, static_cast<std::size_t>(count)}; }

void require_count(const char* what, std::size_t found, int wanted) {
  if (found != static_cast<std::size_t>(wanted))
    throw InputError(std::string("wrong number of ") + what + ": found " + std::to_string(found) +
                     "; allowed: " + std::to_string(wanted));
}

void require_scalar(const kanec_batch& batch, std::size_t size) {
  if (static_cast<std::size_t>(batch.scalar_size) != size)
    throw LoadError(std::string("batch of ") + batch.model->name + ": its numbers have " +
                    std::to_string(batch.scalar_size) + " bytes, expected " + std::to_string(size));
}

template <class Real>
std::vector<Real> rounded(std::span<const double> values) {
  std::vector<Real> result;
  for (const double value : values) result.push_back(static_cast<Real>(value));
  return result;
}

std::int64_t groups(std::int64_t count, int lanes) { return (count + lanes - 1) / lanes; }

}  // namespace

template <class Real>
BatchSolver<Real>::BatchSolver(const kanec_batch& batch, int threads)
    : batch_(&batch), workers_(std::make_unique<Workers>(threads)) {
  require_scalar(batch, sizeof(Real));
  if (batch.alignment > alignof(Line)) throw LoadError("a batch with an alignment of more than 64 bytes");
  while (static_cast<int>(scratch_.size()) < workers_->size())
    scratch_.push_back(std::make_unique<Line[]>(batch.scratch_size / sizeof(Line) + 1));
  set_parameters(batch_list(model().parameter_defaults, model().n_parameters));
  set_inputs(batch_list(model().input_defaults, model().n_inputs));
}

template <class Real>
void BatchSolver<Real>::prepare(std::int64_t count, std::int64_t stride, const Real* parameters) {
  const auto bytes = static_cast<std::size_t>(groups(count, lanes())) * batch_->prepared_size;
  prepared_.assign(bytes / sizeof(Line) + 1, Line{});
  batch_->prepare(0, count, stride, parameters, prepared_.data());
}

template <class Real>
void BatchSolver<Real>::set_parameters(std::span<const double> parameters) {
  require_count("parameters", parameters.size(), model().n_parameters);
  prepare(1, 1, rounded<Real>(parameters).data());
  n_prepared_ = 0;
}

template <class Real>
void BatchSolver<Real>::set_inputs(std::span<const double> inputs) {
  require_count("inputs", inputs.size(), model().n_inputs);
  inputs_ = rounded<Real>(inputs);
}

template <class Real>
void BatchSolver<Real>::set_parameters_each(std::int64_t count, const Real* parameters, std::int64_t stride) {
  if (count < 1) throw InputError("parameters for " + std::to_string(count) + " states; allowed: at least 1");
  BatchStates<Real> states;
  states.count = count;
  states.stride = stride;
  n_prepared_ = 0;
  check(states);
  prepare(count, stride == 0 ? std::max<std::int64_t>(count, 1) : stride, parameters);
  n_prepared_ = count;
}

template <class Real>
std::optional<int> BatchSolver<Real>::find(std::string_view name) const {
  for (int i = 0; i < model().n_functions; ++i)
    if (name == model().functions[i].name) return i;
  return std::nullopt;
}

template <class Real>
void BatchSolver<Real>::check(const BatchStates<Real>& states) const {
  const bool fits =
      states.stride == 0 || states.stride == 1 || states.stride >= states.count ||
      (states.stride > 0 && states.stride % lanes() == 0);
  if (states.count < 0 || !fits)
    throw InputError("a batch of " + std::to_string(states.count) + " states with a stride of " +
                     std::to_string(states.stride) + "; allowed: 0, 1, a multiple of the " + std::to_string(lanes()) +
                     " lanes, or no less than the number of states");
  if (n_prepared_ > 0 && states.count > n_prepared_)
    throw InputError("a batch of " + std::to_string(states.count) + " states; allowed: at most the " +
                     std::to_string(n_prepared_) + " that have parameters");
}

template <class Real>
void BatchSolver<Real>::evaluate_part(int function, const BatchStates<Real>& states, Real* out, std::int64_t begin,
                                      std::int64_t end, int worker) const {
  const bool one_inputs = states.u == nullptr;
  const kanec_states part{begin,
                          end,
                          states.stride == 0 ? states.count : states.stride,
                          prepared_.data(),
                          states.t,
                          states.x,
                          states.y,
                          states.ydot,
                          one_inputs ? inputs_.data() : states.u,
                          n_prepared_ == 0,
                          states.one_time,
                          one_inputs,
                          scratch_[static_cast<std::size_t>(worker)].get()};
  batch_->evaluate[function](&part, out);
}

template <class Real>
const void* BatchSolver<Real>::prepared(std::int64_t group) const {
  const auto* bytes = reinterpret_cast<const unsigned char*>(prepared_.data());
  return n_prepared_ == 0 ? bytes : bytes + static_cast<std::size_t>(group) * batch_->prepared_size;
}

template <class Real>
void BatchSolver<Real>::evaluate_group(int function, std::int64_t group, Real t, const Real* x, const Real* y,
                                       Real* out, int worker) const {
  const kanec_states states{0,
                            lanes(),
                            lanes(),
                            prepared(group),
                            &t,
                            x,
                            y,
                            nullptr,
                            inputs_.data(),
                            1,
                            1,
                            1,
                            scratch_[static_cast<std::size_t>(worker)].get()};
  batch_->evaluate[function](&states, out);
}

template <class Real>
void BatchSolver<Real>::evaluate(int function, const BatchStates<Real>& states, Real* out) {
  check(states);
  const std::int64_t pieces = (states.count + piece_states - 1) / piece_states;
  if (pieces <= 1 || workers_->size() == 1) {
    if (states.count > 0) evaluate_part(function, states, out, 0, states.count, 0);
    return;
  }
  workers_->run(pieces, [&](std::int64_t piece, int worker) {
    const std::int64_t begin = piece * piece_states;
    evaluate_part(function, states, out, begin, std::min(begin + piece_states, states.count), worker);
  });
}

template class BatchSolver<double>;
template class BatchSolver<float>;

}  // namespace kanec
