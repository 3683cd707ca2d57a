// What the explicit and the implicit methods of ARKODE have in common: the state, starts, steps. Not: their set-up
// (arkode.cpp, dirk.cpp), nor what CVODE and IDA share with them (sundials.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <arkode/arkode.h>

#include <optional>
#include <utility>

#include "runtime/integrate/linear_solver.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/integrate/sundials.hpp"

namespace kanec::integrate {

// Called after every accepted step: unit norm, and how far off it was.
extern "C" inline int kanec_arkode_project(realtype, N_Vector z, void* data) {
  auto& callback = *static_cast<CallbackData*>(data);
  callback.norm_error = normalise(N_VGetArrayPointer(z), callback.system.attitudes());
  return 0;
}

inline constexpr int arkode_rate_flags[] = {ARK_RHSFUNC_FAIL, ARK_FIRST_RHSFUNC_ERR, ARK_REPTD_RHSFUNC_ERR,
                                            ARK_UNREC_RHSFUNC_ERR};

// A pair as EmbeddedPair takes it, once `memory_` is set up. Calls: `library`, and the library's functions for this
// kind of method: free, re_init(memory, t, z), set_init_step, set_stop_time, evolve; failed(memory, data), the steps
// rejected since the last start.
template <class Calls>
class ArkodePair {
 public:
  double t() const { return t_; }
  const std::vector<double>& z() const { return z_; }
  double norm_error() const { return data_.norm_error; }
  std::int64_t failed() const { return failed_before_ + failed_; }
  std::int64_t jacobians() const { return linear_ ? linear_->evaluations() : 0; }

  void begin(double t, const std::vector<double>& z, double h) {
    failed_before_ += std::exchange(failed_, 0);
    z_ = z;
    t_ = t;
    require(Calls::re_init(memory_.get(), t, vector_.get()), "ReInit", data_);
    require(Calls::set_init_step(memory_.get(), h), "SetInitStep", data_);
  }

  void step(double limit) {
    require(Calls::set_stop_time(memory_.get(), limit), "SetStopTime", data_);
    t_ = take_step(Calls::library, t_, data_, [this, limit](double* next) {
      return Calls::evolve(memory_.get(), limit, vector_.get(), next, ARK_ONE_STEP);
    });
    failed_ = Calls::failed(memory_.get(), data_);
  }

 protected:
  ArkodePair(System& system, std::vector<double> z, double t)
      : data_{system}, z_(std::move(z)), vector_(view(z_, context_)), t_(t) {
    data_.state = &z_;
  }

  struct Deleter {
    void operator()(void* memory) const { Calls::free(&memory); }
  };

  CallbackData data_;
  sundials::Context context_;
  std::vector<double> z_;
  VectorHandle vector_;
  std::optional<LinearSolver> linear_;  // of methods with Newton's iteration
  std::unique_ptr<void, Deleter> memory_;

 private:
  double t_;
  std::int64_t failed_before_ = 0, failed_ = 0;  // the last start, since it
};

}  // namespace kanec::integrate
