// The loop over groups of lanes around emitted functions, behind the ABI's batch calls. Not: lanes themselves, nor
// threads (runtime/abi/batch_solver.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <new>

#include "abi.h"
#include "lane_functions.hpp"

namespace kanec::lanes::batch {

// Where the states j .. j + lanes - 1 of an argument with n entries stand, and how many of them there are.
template <class Lane>
struct Group {
  using Scalar = typename Lane::Scalar;
  std::int64_t first, stride;
  int count;

  std::int64_t place(int n, int i) const noexcept { return (first / stride * n + i) * stride + first % stride; }
  bool is_direct(const void* argument) const noexcept {
    return stride == Lane::size && count == Lane::size &&
           reinterpret_cast<std::uintptr_t>(argument) % alignof(Lane) == 0;
  }

  // From one state's entry to the next one's, of n.
  int step(int n) const noexcept { return stride == 1 ? n : 1; }

  // Lanes without a state take the last one's numbers: no exception is raised that no state would raise.
  Lane load(const Scalar* from, int step = 1) const noexcept {
    if (count == Lane::size && step == 1) return Lane::load(from);
    Scalar gathered[Lane::size];
    for (int l = 0; l < Lane::size; ++l) gathered[l] = from[(l < count ? l : count - 1) * step];
    return Lane::load(gathered);
  }
  void store(const Lane& lanes, Scalar* to, int step = 1) const noexcept {
    if (count == Lane::size && step == 1) return lanes.store(to);
    for (int l = 0; l < count; ++l) to[l * step] = lanes[l];
  }
};

// The entries of one argument, in place where they can be read there, else copied; nothing where it is not read.
template <class Lane, int N, bool IsRead>
class Argument {
 public:
  using Scalar = typename Lane::Scalar;
  explicit Argument(const void* argument, bool one_for_all = false) noexcept
      : from_(static_cast<const Scalar*>(argument)), one_for_all_(one_for_all) {
    for (int i = 0; IsRead && one_for_all && i < N; ++i) copy_[i] = Lane(static_cast<double>(from_[i]));
  }

  const Lane* at(const Group<Lane>& group) noexcept {
    if (!IsRead) return nullptr;
    if (one_for_all_) return copy_;
    if (group.is_direct(from_)) return reinterpret_cast<const Lane*>(from_ + group.place(N, 0));
    for (int i = 0; i < N; ++i) copy_[i] = group.load(from_ + group.place(N, i), group.step(N));
    return copy_;
  }

 private:
  const Scalar* from_;
  bool one_for_all_;
  Lane copy_[IsRead && N > 0 ? N : 1];
};

// Likewise for results, which finish() copies to their places from the caller's scratch: they may be many.
template <class Lane, int N>
class Results {
 public:
  using Scalar = typename Lane::Scalar;
  Results(const Group<Lane>& group, void* out, void* scratch) noexcept
      : group_(group),
        out_(static_cast<Scalar*>(out)),
        direct_(group.is_direct(out)),
        at_(direct_ ? reinterpret_cast<Lane*>(out_ + group.place(N, 0)) : static_cast<Lane*>(scratch)) {}
  Lane* get() noexcept { return at_; }
  void finish() const noexcept {
    for (int i = 0; i < N && !direct_; ++i) group_.store(at_[i], out_ + group_.place(N, i), group_.step(N));
  }

 private:
  Group<Lane> group_;
  Scalar* out_;
  bool direct_;
  Lane* at_;
};

template <class Lane>
Group<Lane> group_at(std::int64_t first, std::int64_t end, std::int64_t stride) noexcept {
  return {first, stride, end - first < Lane::size ? static_cast<int>(end - first) : Lane::size};
}

// Sizes: nx, ny, n_inputs, n_parameters. Function: which arguments it reads, n_out, and call().
template <class Lane, class Prepared, class Sizes, class Function>
void evaluate(const kanec_states* states, void* out) noexcept {
  Argument<Lane, Sizes::nx, Function::reads_x> x(states->x);
  Argument<Lane, Sizes::ny, Function::reads_y> y(states->y);
  Argument<Lane, Sizes::ny, Function::reads_ydot> ydot(states->ydot);
  Argument<Lane, Sizes::n_inputs, Function::reads_inputs> u(states->u, states->one_inputs != 0);
  for (std::int64_t j = states->begin; j < states->end; j += Lane::size) {
    const Group<Lane> group = group_at<Lane>(j, states->end, states->stride);
    const auto* time = static_cast<const typename Lane::Scalar*>(states->t);
    Lane t(0);
    if constexpr (Function::reads_time)
      t = states->one_time != 0 ? Lane(static_cast<double>(*time)) : group.load(time + j);
    const auto* prepared = static_cast<const Prepared*>(states->prepared);
    Results<Lane, Function::n_out> results(group, out, states->scratch);
    Function::call(prepared[states->one_parameters != 0 ? 0 : j / Lane::size], t, x.at(group), y.at(group),
                   ydot.at(group), u.at(group), results.get());
    results.finish();
  }
}

// Function: call() makes a group of prepared parameters.
template <class Lane, class Prepared, class Sizes, class Function>
void prepare(std::int64_t begin, std::int64_t end, std::int64_t stride, const void* parameters,
             void* prepared) noexcept {
  Argument<Lane, Sizes::n_parameters, true> p(parameters);
  for (std::int64_t j = begin; j < end; j += Lane::size) {
    const Group<Lane> group = group_at<Lane>(j, end, stride);
    ::new (static_cast<void*>(static_cast<Prepared*>(prepared) + j / Lane::size)) Prepared(Function::call(p.at(group)));
  }
}

}  // namespace kanec::lanes::batch
