// SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_erkstep.h>

#include "runtime/base/error.hpp"
#include "runtime/integrate/arkode_common.hpp"
#include "runtime/integrate/embedded_pair.hpp"

namespace kanec::integrate {
namespace {

struct ErkDeleter {
  void operator()(void* memory) const { ERKStepFree(&memory); }
};

// Explicit embedded pairs, projection inside every accepted step (before its end rate is computed: none of the pairs
// for orders 4, 5, 6, 8 carries the last stage over).
class Erk {
 public:
  Erk(System& system, std::vector<double> z, double t, const Options& options)
      : data_{system}, z_(std::move(z)), vector_(view(z_, context_)), t_(t) {
    data_.state = &z_;
    memory_.reset(ERKStepCreate(kanec_sundials_rates, t, vector_.get(), context_));
    if (!memory_) throw InternalError("ERKStepCreate failed");
    void* erk = memory_.get();
    require(ERKStepSetErrHandlerFn(erk, kanec_sundials_message, &data_), "ERKStepSetErrHandlerFn", data_);
    require(ERKStepSetUserData(erk, &data_), "ERKStepSetUserData", data_);
    require(ERKStepSetOrder(erk, arkode_order(options)), "ERKStepSetOrder", data_);
    require(ERKStepSStolerances(erk, options.relative_tolerance, options.absolute_tolerance), "ERKStepSStolerances",
            data_);
    require(ERKStepSetPostprocessStepFn(erk, kanec_arkode_project), "ERKStepSetPostprocessStepFn", data_);
  }

  double t() const { return t_; }
  const std::vector<double>& z() const { return z_; }
  double norm_error() const { return data_.norm_error; }
  std::int64_t failed() const { return failed_before_ + failed_; }
  static std::int64_t jacobians() { return 0; }

  void begin(double t, const std::vector<double>& z, double h) {
    failed_before_ += std::exchange(failed_, 0);
    z_ = z;
    t_ = t;
    require(ERKStepReInit(memory_.get(), kanec_sundials_rates, t, vector_.get()), "ERKStepReInit", data_);
    require(ERKStepSetInitStep(memory_.get(), h), "ERKStepSetInitStep", data_);
  }

  void step(double limit) {
    require(ERKStepSetStopTime(memory_.get(), limit), "ERKStepSetStopTime", data_);
    data_.system.clear_fault();
    double next = t_;
    const int flag = ERKStepEvolve(memory_.get(), limit, vector_.get(), &next, ARK_ONE_STEP);
    if (flag < 0) throw_step_failure("arkode", next, failed_in_rates(flag), data_);
    require_progress("arkode", t_, next, data_);
    t_ = next;
    require(ERKStepGetNumErrTestFails(memory_.get(), &failed_), "ERKStepGetNumErrTestFails", data_);
  }

 private:
  CallbackData data_;
  sundials::Context context_;
  std::vector<double> z_;
  VectorHandle vector_;
  std::unique_ptr<void, ErkDeleter> memory_;
  double t_;
  std::int64_t failed_before_ = 0;
  long failed_ = 0;  // since the last start
};

}  // namespace

std::unique_ptr<Stepper> make_arkode(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  return std::make_unique<EmbeddedPair<Erk>>(system, std::move(z), options, book);
}

}  // namespace kanec::integrate
