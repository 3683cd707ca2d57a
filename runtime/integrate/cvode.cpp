// SPDX-License-Identifier: BSD-3-Clause
#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <cvode/cvode_proj.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>

#include "runtime/base/error.hpp"
#include "runtime/integrate/linear_solver.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/integrate/stepper.hpp"
#include "runtime/integrate/sundials.hpp"

namespace kanec::integrate {
namespace {

// Correction to unit norm, and the error estimate without its radial part, which the projection removes.
extern "C" int kanec_cvode_project(realtype, N_Vector z, N_Vector correction, realtype, N_Vector error, void* data) {
  auto& callback = *static_cast<CallbackData*>(data);
  N_VConst(0.0, correction);
  const double* now = N_VGetArrayPointer(z);
  double* c = N_VGetArrayPointer(correction);
  double* e = error ? N_VGetArrayPointer(error) : nullptr;
  callback.norm_error = norm_error(now, callback.system.attitudes());
  for (const int at : callback.system.attitudes()) {
    const double length = norm(now + at);
    double radial = 0.0;
    for (int i = at; i < at + 4; ++i) {
      c[i] = now[i] / length - now[i];
      if (e) radial += e[i] * now[i] / (length * length);
    }
    for (int i = at; e && i < at + 4; ++i) e[i] -= radial * now[i];
  }
  return 0;
}

bool failed_in_rates(int flag) {
  return flag == CV_RHSFUNC_FAIL || flag == CV_FIRST_RHSFUNC_ERR || flag == CV_REPTD_RHSFUNC_ERR ||
         flag == CV_UNREC_RHSFUNC_ERR;
}

struct CvodeDeleter {
  void operator()(void* memory) const { CVodeFree(&memory); }
};
struct NonlinearDeleter {
  void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
};

// Multistep methods take their own steps; rows are interpolated by the method's own polynomial (its full order), then
// projected. BDF projects inside every step. CVODE has no projection for Adams, and changing the newest value alone
// would spoil the history: so Adams runs free, and starts anew from projected values once the norm is off by
// `drift_limit_`. A start costs some twenty short steps and a drift of about the tolerance; a limit of a hundred times
// that keeps starts hundreds of steps apart, and the norm is not the largest of the errors.
class Cvode final : public Stepper {
 public:
  Cvode(System& system, std::vector<double> z, const Options& options, StepBook& book)
      : book_(book),
        data_{system},
        bdf_(options.method == Method::cvode_bdf),
        drift_limit_(100.0 * std::max(options.relative_tolerance, 1e-13)),
        end_(options.duration),
        t_(options.start),
        z_(std::move(z)),
        row_(z_),
        vector_(view(z_, context_)),
        row_vector_(view(row_, context_)) {
    data_.state = &z_;
    memory_.reset(CVodeCreate(bdf_ ? CV_BDF : CV_ADAMS, context_));
    if (!memory_) throw InternalError("CVodeCreate failed");
    void* cvode = memory_.get();
    require(CVodeSetErrHandlerFn(cvode, kanec_sundials_message, &data_), "CVodeSetErrHandlerFn", data_);
    require(CVodeInit(cvode, kanec_sundials_rates, t_, vector_.get()), "CVodeInit", data_);
    require(CVodeSetUserData(cvode, &data_), "CVodeSetUserData", data_);
    require(CVodeSStolerances(cvode, options.relative_tolerance, options.absolute_tolerance), "CVodeSStolerances",
            data_);
    if (bdf_)
      set_newton(options);
    else
      set_fixed_point();
  }

  double time() const override { return t_; }

  std::span<const double> at(double t) override {
    if (!has_stepped_) return z_;
    require(CVodeGetDky(memory_.get(), t, 0, row_vector_.get()), "CVodeGetDky", data_);
    normalise(row_.data(), data_.system.attitudes());
    return row_;
  }

  void restart(double t, std::span<const double> z) override {
    std::copy(z.begin(), z.end(), z_.begin());
    t_ = t;
    start_anew();
  }

  void step(double) override {
    if (!bdf_ && norm_error(z_.data(), data_.system.attitudes()) > drift_limit_) {
      start_anew();
      ++book_.restarts;
    }
    require(CVodeSetStopTime(memory_.get(), end_), "CVodeSetStopTime", data_);
    data_.system.clear_fault();
    double next = t_;
    const int flag = CVode(memory_.get(), end_, vector_.get(), &next, CV_ONE_STEP);
    if (flag < 0) throw_step_failure("cvode", next, failed_in_rates(flag), data_);
    require_progress("cvode", t_, next, data_);
    t_ = next;
    has_stepped_ = true;
    book_.failed = failed_before_restart_ + failed();
    if (linear_) book_.jacobians = linear_->evaluations();
    book_.accepted(t_, bdf_ ? data_.norm_error : norm_error(z_.data(), data_.system.attitudes()));
  }

 private:
  void set_fixed_point() {
    fixed_point_.reset(SUNNonlinSol_FixedPoint(vector_.get(), 0, context_));
    if (!fixed_point_) throw InternalError("SUNNonlinSol_FixedPoint failed");
    require(CVodeSetNonlinearSolver(memory_.get(), fixed_point_.get()), "CVodeSetNonlinearSolver", data_);
    // a tenth of the default: one more iteration, but a third fewer steps at the same error, fewer evaluations in all
    require(CVodeSetNonlinConvCoef(memory_.get(), 0.01), "CVodeSetNonlinConvCoef", data_);
  }

  void set_newton(const Options& options) {
    linear_.emplace(data_.system, options, LinearSolver::Form::rates, vector_.get(), context_);
    data_.linear = &*linear_;
    require(CVodeSetLinearSolver(memory_.get(), linear_->solver(), linear_->matrix()), "CVodeSetLinearSolver", data_);
    if (linear_->has_jacobian()) require(CVodeSetJacFn(memory_.get(), kanec_sundials_jacobian), "CVodeSetJacFn", data_);
    if (data_.system.attitudes().empty()) return;
    require(CVodeSetProjFn(memory_.get(), kanec_cvode_project), "CVodeSetProjFn", data_);
  }

  void start_anew() {
    failed_before_restart_ += failed();
    normalise(z_.data(), data_.system.attitudes());
    require(CVodeReInit(memory_.get(), t_, vector_.get()), "CVodeReInit", data_);
    has_stepped_ = false;
  }

  // steps rejected since the last start
  std::int64_t failed() {
    long error_test = 0, convergence = 0;
    require(CVodeGetNumErrTestFails(memory_.get(), &error_test), "CVodeGetNumErrTestFails", data_);
    require(CVodeGetNumStepSolveFails(memory_.get(), &convergence), "CVodeGetNumStepSolveFails", data_);
    return error_test + convergence;
  }

  StepBook& book_;
  CallbackData data_;
  bool bdf_;
  double drift_limit_;
  double end_, t_;
  sundials::Context context_;
  std::vector<double> z_, row_;  // at the end of the last step; at the last row
  VectorHandle vector_, row_vector_;
  std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, NonlinearDeleter> fixed_point_;
  std::optional<LinearSolver> linear_;
  std::unique_ptr<void, CvodeDeleter> memory_;
  bool has_stepped_ = false;  // since the last start
  std::int64_t failed_before_restart_ = 0;
};

}  // namespace

std::unique_ptr<Stepper> make_cvode(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  return std::make_unique<Cvode>(system, std::move(z), options, book);
}

}  // namespace kanec::integrate
