// SPDX-License-Identifier: BSD-3-Clause
#include <ida/ida.h>
#include <ida/ida_ls.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/base/error.hpp"
#include "runtime/integrate/multistep.hpp"

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

constexpr int residual_flags[] = {IDA_RES_FAIL, IDA_FIRST_RES_FAIL, IDA_REP_RES_ERR};
constexpr Library ida_library = {"ida", residual_flags};

struct IdaDeleter {
  void operator()(void* memory) const { IDAFree(&memory); }
};

// BDF of variable coefficients on F(t, z, ż) = 0, which asks for A ẏ - f and never for A⁻¹. IDA has no projection.
class Ida final : public Multistep {
 public:
  Ida(System& system, std::vector<double> z, const Options& options, StepBook& book)
      : Multistep(ida_library, /*projects=*/false, system, std::move(z), options, book),
        relative_(options.relative_tolerance),
        absolute_(options.absolute_tolerance),
        zdot_(z_.size()),
        rate_vector_(view(zdot_, context_)) {
    if (!system.has_residual())
      throw InputError("ida: found a model without the function 'kinematics+residual" +
                       std::string(system.has_work() ? "+power" : "") + "'; allowed: one that has it");
    find_rates();
    linear_.emplace(system, options, LinearSolver::Form::residual, vector_.get(), context_);
    data_.linear = &*linear_;
    set_up(options);
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
    require(IDASetMaxStep(ida, options.longest_step), "IDASetMaxStep", data_);
    require(IDASetMaxErrTestFails(ida, most_error_tests), "IDASetMaxErrTestFails", data_);
    require(IDASetLinearSolver(ida, linear_->solver(), linear_->matrix()), "IDASetLinearSolver", data_);
    if (linear_->has_jacobian()) require(IDASetJacFn(ida, kanec_ida_jacobian), "IDASetJacFn", data_);
  }

  // Consistent with z_.
  void find_rates() {
    if (!data_.system.rates(t_, z_.data(), zdot_.data())) data_.system.throw_fault();
  }

  void interpolate(double t, N_Vector row) override {
    require(IDAGetDky(memory_.get(), t, 0, row), "IDAGetDky", data_);
  }

  int evolve(double* next) override {
    require(IDASetStopTime(memory_.get(), end_), "IDASetStopTime", data_);
    return IDASolve(memory_.get(), end_, next, vector_.get(), rate_vector_.get(), IDA_ONE_STEP);
  }

  void re_init() override {
    find_rates();
    require(IDAReInit(memory_.get(), t_, vector_.get(), rate_vector_.get()), "IDAReInit", data_);
    set_first_step();
  }

  // The library begins with a change of half a tolerance, which takes less than a rounding of the time where a
  // component passes zero and its tolerance is tiny.
  void set_first_step() {
    double fastest = 0.0;  // tolerances a second
    for (std::size_t i = 0; i < z_.size(); ++i)
      fastest = std::max(fastest, std::fabs(zdot_[i]) / (relative_ * std::fabs(z_[i]) + absolute_));
    const double least = 1e3 * std::numeric_limits<double>::epsilon() * t_;
    require(IDASetInitStep(memory_.get(), 0.5 < least * fastest ? least : 0.0), "IDASetInitStep", data_);
  }

  std::int64_t failed() override {
    return count(IDAGetNumErrTestFails, memory_.get(), "IDAGetNumErrTestFails", data_) +
           count(IDAGetNumStepSolveFails, memory_.get(), "IDAGetNumStepSolveFails", data_);
  }

  double relative_, absolute_;  // tolerances
  std::vector<double> zdot_;    // the rates at z_
  VectorHandle rate_vector_;
  std::unique_ptr<void, IdaDeleter> memory_;
};

}  // namespace

std::unique_ptr<Stepper> make_ida(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  return std::make_unique<Ida>(system, std::move(z), options, book);
}

}  // namespace kanec::integrate
