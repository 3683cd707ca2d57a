// SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_erkstep.h>

#include "runtime/base/error.hpp"
#include "runtime/integrate/arkode_common.hpp"
#include "runtime/integrate/embedded_pair.hpp"

namespace kanec::integrate {
namespace {

struct ErkCalls {
  static constexpr Library library = {"arkode", arkode_rate_flags};
  static constexpr auto free = ERKStepFree;
  static constexpr auto set_init_step = ERKStepSetInitStep;
  static constexpr auto set_stop_time = ERKStepSetStopTime;
  static constexpr auto evolve = ERKStepEvolve;
  static int re_init(void* erk, double t, N_Vector z) { return ERKStepReInit(erk, kanec_sundials_rates, t, z); }
  static std::int64_t failed(void* erk, const CallbackData& data) {
    return count(ERKStepGetNumErrTestFails, erk, "ERKStepGetNumErrTestFails", data);
  }
};

// Explicit embedded pairs, projection inside every accepted step (before its end rate is computed: none of the pairs
// for orders 4, 5, 6, 8 carries the last stage over).
class Erk : public ArkodePair<ErkCalls> {
 public:
  Erk(System& system, std::vector<double> z, double t, const Options& options) : ArkodePair(system, std::move(z), t) {
    memory_.reset(ERKStepCreate(kanec_sundials_rates, t, vector_.get(), context_));
    if (!memory_) throw InternalError("ERKStepCreate failed");
    void* erk = memory_.get();
    require(ERKStepSetErrHandlerFn(erk, kanec_sundials_message, &data_), "ERKStepSetErrHandlerFn", data_);
    require(ERKStepSetUserData(erk, &data_), "ERKStepSetUserData", data_);
    require(ERKStepSetOrder(erk, arkode_order(options)), "ERKStepSetOrder", data_);
    require(ERKStepSStolerances(erk, options.relative_tolerance, options.absolute_tolerance), "ERKStepSStolerances",
            data_);
    require(ERKStepSetMaxStep(erk, options.longest_step), "ERKStepSetMaxStep", data_);
    require(ERKStepSetMaxErrTestFails(erk, most_error_tests), "ERKStepSetMaxErrTestFails", data_);
    require(ERKStepSetPostprocessStepFn(erk, kanec_arkode_project), "ERKStepSetPostprocessStepFn", data_);
  }
};

}  // namespace

std::unique_ptr<Stepper> make_arkode(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  return std::make_unique<EmbeddedPair<Erk>>(system, std::move(z), options, book);
}

}  // namespace kanec::integrate
