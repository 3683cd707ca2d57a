// SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_arkstep.h>

#include "runtime/base/error.hpp"
#include "runtime/integrate/arkode_common.hpp"
#include "runtime/integrate/embedded_pair.hpp"

namespace kanec::integrate {
namespace {

struct DirkCalls {
  static constexpr Library library = {"arkode_dirk", arkode_rate_flags};
  static constexpr auto free = ARKStepFree;
  static constexpr auto set_init_step = ARKStepSetInitStep;
  static constexpr auto set_stop_time = ARKStepSetStopTime;
  static constexpr auto evolve = ARKStepEvolve;
  static int re_init(void* ark, double t, N_Vector z) {
    return ARKStepReInit(ark, nullptr, kanec_sundials_rates, t, z);
  }
  static std::int64_t failed(void* ark, const CallbackData& data) {
    return count(ARKStepGetNumErrTestFails, ark, "ARKStepGetNumErrTestFails", data) +
           count(ARKStepGetNumStepSolveFails, ark, "ARKStepGetNumStepSolveFails", data);
  }
};

// Diagonally implicit embedded pairs by Newton's method. Projection as in arkode.cpp.
class Dirk : public ArkodePair<DirkCalls> {
 public:
  Dirk(System& system, std::vector<double> z, double t, const Options& options) : ArkodePair(system, std::move(z), t) {
    linear_.emplace(system, options, LinearSolver::Form::rates, vector_.get(), context_);
    data_.linear = &*linear_;
    memory_.reset(ARKStepCreate(nullptr, kanec_sundials_rates, t, vector_.get(), context_));
    if (!memory_) throw InternalError("ARKStepCreate failed");
    void* ark = memory_.get();
    require(ARKStepSetErrHandlerFn(ark, kanec_sundials_message, &data_), "ARKStepSetErrHandlerFn", data_);
    require(ARKStepSetUserData(ark, &data_), "ARKStepSetUserData", data_);
    set_order(arkode_order(options));
    require(ARKStepSStolerances(ark, options.relative_tolerance, options.absolute_tolerance), "ARKStepSStolerances",
            data_);
    require(ARKStepSetMaxStep(ark, options.longest_step), "ARKStepSetMaxStep", data_);
    require(ARKStepSetMaxErrTestFails(ark, most_error_tests), "ARKStepSetMaxErrTestFails", data_);
    require(ARKStepSetLinearSolver(ark, linear_->solver(), linear_->matrix()), "ARKStepSetLinearSolver", data_);
    // The rate of convergence is remembered from stage to stage and step to step: where it was small once, the library
    // takes a first iterate unseen, also one by a matrix of another step size. Never below 1, it costs a fifth more
    // evaluations, and the error falls with the tolerance.
    require(ARKStepSetNonlinCRDown(ark, 1.0), "ARKStepSetNonlinCRDown", data_);
    if (linear_->has_jacobian()) require(ARKStepSetJacFn(ark, kanec_sundials_jacobian), "ARKStepSetJacFn", data_);
    require(ARKStepSetPostprocessStepFn(ark, kanec_arkode_project), "ARKStepSetPostprocessStepFn", data_);
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
};

}  // namespace

std::unique_ptr<Stepper> make_dirk(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  return std::make_unique<EmbeddedPair<Dirk>>(system, std::move(z), options, book);
}

}  // namespace kanec::integrate
