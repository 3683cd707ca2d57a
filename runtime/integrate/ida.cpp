// SPDX-License-Identifier: BSD-3-Clause
#include <ida/ida.h>
#include <ida/ida_ls.h>

#include <algorithm>

#include "runtime/base/error.hpp"
#include "runtime/integrate/linear_solver.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/integrate/stepper.hpp"
#include "runtime/integrate/sundials.hpp"

namespace kanec::integrate {
namespace {

extern "C" int kanec_ida_residual(realtype t, N_Vector z, N_Vector zdot, N_Vector F, void* data) {
  System& system = static_cast<CallbackData*>(data)->system;
  return system.residual(t, N_VGetArrayPointer(z), N_VGetArrayPointer(zdot), N_VGetArrayPointer(F)) ? 0 : 1;
}

extern "C" int kanec_ida_jacobian(realtype t, realtype c, N_Vector z, N_Vector zdot, N_Vector, SUNMatrix matrix,
                                  void* data, N_Vector, N_Vector, N_Vector) {
  return static_cast<CallbackData*>(data)->linear->fill(matrix, t, z, zdot, c);
}

bool failed_in_residual(int flag) {
  return flag == IDA_RES_FAIL || flag == IDA_FIRST_RES_FAIL || flag == IDA_REP_RES_ERR;
}

struct IdaDeleter {
  void operator()(void* memory) const { IDAFree(&memory); }
};

// BDF of variable coefficients on F(t, z, ż) = 0, which asks for A ẏ - f and never for A⁻¹. Rows are interpolated by
// the method's own polynomial, then projected. IDA has no projection: as Adams in cvode.cpp it starts anew from
// projected values once the norm is off by `drift_limit_`.
class Ida final : public Stepper {
 public:
  Ida(System& system, std::vector<double> z, const Options& options, StepBook& book)
      : book_(book),
        data_{system},
        drift_limit_(100.0 * std::max(options.relative_tolerance, 1e-13)),
        end_(options.duration),
        t_(options.start),
        z_(std::move(z)),
        zdot_(z_.size()),
        row_(z_),
        vector_(view(z_, context_)),
        rate_vector_(view(zdot_, context_)),
        row_vector_(view(row_, context_)) {
    if (!system.has_residual())
      throw InputError("ida: found a model without the function 'kinematics+residual" +
                       std::string(system.has_work() ? "+power" : "") + "'; allowed: one that has it");
    data_.state = &z_;
    find_rates();
    linear_.emplace(system, options, LinearSolver::Form::residual, vector_.get(), context_);
    data_.linear = &*linear_;
    set_up(options);
  }

  double time() const override { return t_; }

  std::span<const double> at(double t) override {
    if (!has_stepped_) return z_;
    require(IDAGetDky(memory_.get(), t, 0, row_vector_.get()), "IDAGetDky", data_);
    normalise(row_.data(), data_.system.attitudes());
    return row_;
  }

  void restart(double t, std::span<const double> z) override {
    std::copy(z.begin(), z.end(), z_.begin());
    t_ = t;
    start_anew();
  }

  void step(double) override {
    if (norm_error(z_.data(), data_.system.attitudes()) > drift_limit_) {
      start_anew();
      ++book_.restarts;
    }
    require(IDASetStopTime(memory_.get(), end_), "IDASetStopTime", data_);
    data_.system.clear_fault();
    double next = t_;
    const int flag = IDASolve(memory_.get(), end_, &next, vector_.get(), rate_vector_.get(), IDA_ONE_STEP);
    if (flag < 0) throw_step_failure("ida", next, failed_in_residual(flag), data_);
    require_progress("ida", t_, next, data_);
    t_ = next;
    has_stepped_ = true;
    book_.failed = failed_before_restart_ + failed();
    book_.jacobians = linear_->evaluations();
    book_.accepted(t_, norm_error(z_.data(), data_.system.attitudes()));
  }

 private:
  void set_up(const Options& options) {
    memory_.reset(IDACreate(context_));
    if (!memory_) throw InternalError("IDACreate failed");
    void* ida = memory_.get();
    require(IDASetErrHandlerFn(ida, kanec_sundials_message, &data_), "IDASetErrHandlerFn", data_);
    require(IDAInit(ida, kanec_ida_residual, t_, vector_.get(), rate_vector_.get()), "IDAInit", data_);
    require(IDASetUserData(ida, &data_), "IDASetUserData", data_);
    require(IDASStolerances(ida, options.relative_tolerance, options.absolute_tolerance), "IDASStolerances", data_);
    require(IDASetLinearSolver(ida, linear_->solver(), linear_->matrix()), "IDASetLinearSolver", data_);
    if (linear_->has_jacobian()) require(IDASetJacFn(ida, kanec_ida_jacobian), "IDASetJacFn", data_);
  }

  // Consistent with z_.
  void find_rates() {
    if (!data_.system.rates(t_, z_.data(), zdot_.data())) data_.system.throw_fault();
  }

  void start_anew() {
    failed_before_restart_ += failed();
    normalise(z_.data(), data_.system.attitudes());
    find_rates();
    require(IDAReInit(memory_.get(), t_, vector_.get(), rate_vector_.get()), "IDAReInit", data_);
    has_stepped_ = false;
  }

  // steps rejected since the last start
  std::int64_t failed() {
    long error_test = 0, convergence = 0;
    require(IDAGetNumErrTestFails(memory_.get(), &error_test), "IDAGetNumErrTestFails", data_);
    require(IDAGetNumStepSolveFails(memory_.get(), &convergence), "IDAGetNumStepSolveFails", data_);
    return error_test + convergence;
  }

  StepBook& book_;
  CallbackData data_;
  double drift_limit_;
  double end_, t_;
  sundials::Context context_;
  std::vector<double> z_, zdot_, row_;  // at the end of the last step, its rates; at the last row
  VectorHandle vector_, rate_vector_, row_vector_;
  std::optional<LinearSolver> linear_;
  std::unique_ptr<void, IdaDeleter> memory_;
  bool has_stepped_ = false;  // since the last start
  std::int64_t failed_before_restart_ = 0;
};

}  // namespace

std::unique_ptr<Stepper> make_ida(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  return std::make_unique<Ida>(system, std::move(z), options, book);
}

}  // namespace kanec::integrate
