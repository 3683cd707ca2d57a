// SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_arkstep.h>

#include "runtime/base/error.hpp"
#include "runtime/integrate/arkode_common.hpp"
#include "runtime/integrate/embedded_pair.hpp"
#include "runtime/integrate/linear_solver.hpp"

namespace kanec::integrate {
namespace {

struct StepDeleter {
  void operator()(void* memory) const { ARKStepFree(&memory); }
};

// Diagonally implicit embedded pairs by Newton's method. Projection as in arkode.cpp.
class Dirk {
 public:
  Dirk(System& system, std::vector<double> z, double t, const Options& options)
      : data_{system}, z_(std::move(z)), vector_(view(z_, context_)), t_(t) {
    linear_.emplace(system, options, LinearSolver::Form::rates, vector_.get(), context_);
    data_.state = &z_;
    data_.linear = &*linear_;
    memory_.reset(ARKStepCreate(nullptr, kanec_sundials_rates, t, vector_.get(), context_));
    if (!memory_) throw InternalError("ARKStepCreate failed");
    void* ark = memory_.get();
    require(ARKStepSetErrHandlerFn(ark, kanec_sundials_message, &data_), "ARKStepSetErrHandlerFn", data_);
    require(ARKStepSetUserData(ark, &data_), "ARKStepSetUserData", data_);
    set_order(arkode_order(options));
    require(ARKStepSStolerances(ark, options.relative_tolerance, options.absolute_tolerance), "ARKStepSStolerances",
            data_);
    require(ARKStepSetLinearSolver(ark, linear_->solver(), linear_->matrix()), "ARKStepSetLinearSolver", data_);
    // The rate of convergence is remembered from stage to stage and step to step: where it was small once, the library
    // takes a first iterate unseen, also one by a matrix of another step size. Never below 1, it costs a fifth more
    // evaluations, and the error falls with the tolerance.
    require(ARKStepSetNonlinCRDown(ark, 1.0), "ARKStepSetNonlinCRDown", data_);
    if (linear_->has_jacobian()) require(ARKStepSetJacFn(ark, kanec_sundials_jacobian), "ARKStepSetJacFn", data_);
    require(ARKStepSetPostprocessStepFn(ark, kanec_arkode_project), "ARKStepSetPostprocessStepFn", data_);
  }

  double t() const { return t_; }
  const std::vector<double>& z() const { return z_; }
  double norm_error() const { return data_.norm_error; }
  std::int64_t failed() const { return failed_before_ + failed_; }
  std::int64_t jacobians() const { return linear_->evaluations(); }

  void begin(double t, const std::vector<double>& z, double h) {
    failed_before_ += std::exchange(failed_, 0);
    z_ = z;
    t_ = t;
    require(ARKStepReInit(memory_.get(), nullptr, kanec_sundials_rates, t, vector_.get()), "ARKStepReInit", data_);
    require(ARKStepSetInitStep(memory_.get(), h), "ARKStepSetInitStep", data_);
  }

  void step(double limit) {
    require(ARKStepSetStopTime(memory_.get(), limit), "ARKStepSetStopTime", data_);
    data_.system.clear_fault();
    double next = t_;
    const int flag = ARKStepEvolve(memory_.get(), limit, vector_.get(), &next, ARK_ONE_STEP);
    if (flag < 0) throw_step_failure("arkode_dirk", next, failed_in_rates(flag), data_);
    require_progress("arkode_dirk", t_, next, data_);
    t_ = next;
    long error_test = 0, convergence = 0;
    require(ARKStepGetNumErrTestFails(memory_.get(), &error_test), "ARKStepGetNumErrTestFails", data_);
    require(ARKStepGetNumStepSolveFails(memory_.get(), &convergence), "ARKStepGetNumStepSolveFails", data_);
    failed_ = error_test + convergence;
  }

 private:
  // Of order 5 not the library's choice, whose errors on a stiff chain were 50 to 200 times as large at the same
  // tolerance, but Kennedy & Carpenter's of 2019.
  void set_order(int order) {
    void* ark = memory_.get();
    if (order == 5)
      require(ARKStepSetTableNum(ark, ARKODE_ESDIRK547L2SA_7_4_5, ARKODE_ERK_NONE), "ARKStepSetTableNum", data_);
    else
      require(ARKStepSetOrder(ark, order), "ARKStepSetOrder", data_);
  }

  CallbackData data_;
  sundials::Context context_;
  std::vector<double> z_;
  VectorHandle vector_;
  std::optional<LinearSolver> linear_;
  std::unique_ptr<void, StepDeleter> memory_;
  double t_;
  std::int64_t failed_before_ = 0;
  long failed_ = 0;  // since the last start
};

}  // namespace

std::unique_ptr<Stepper> make_dirk(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  return std::make_unique<EmbeddedPair<Dirk>>(system, std::move(z), options, book);
}

}  // namespace kanec::integrate
