// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/sundials.hpp"

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"

namespace kanec::integrate {
namespace {

std::string stopped(double t, const char* library) {
  return "integration stopped at t = " + shortest(t) + " s: " + library + ": ";
}

std::string fastest(double t, const CallbackData& data) {
  return data.state ? "; fastest changes " + data.system.fastest(t, data.state->data()) : "";
}

}  // namespace

VectorHandle view(std::vector<double>& values, const sundials::Context& context) {
  VectorHandle handle(N_VMake_Serial(static_cast<sunindextype>(values.size()), values.data(), context));
  if (!handle) throw InternalError("N_VMake_Serial failed");
  return handle;
}

extern "C" int kanec_sundials_rates(realtype t, N_Vector z, N_Vector zdot, void* data) {
  System& system = static_cast<CallbackData*>(data)->system;
  return system.rates(t, N_VGetArrayPointer(z), N_VGetArrayPointer(zdot)) ? 0 : 1;
}

extern "C" void kanec_sundials_message(int code, const char*, const char*, char* message, void* data) {
  if (code >= 0) return;
  try {
    static_cast<CallbackData*>(data)->message = message;
  } catch (...) {  // out of memory: the flag still tells of the failure
  }
}

void throw_step_failure(const char* library, double t, bool in_rates, const CallbackData& data) {
  if (in_rates && data.system.fault()) data.system.throw_fault();
  throw IntegrationError(stopped(t, library) + (data.message.empty() ? "no cause given" : data.message) +
                         fastest(t, data));
}

void require(int flag, const char* call, const CallbackData& data) {
  if (flag < 0) throw InternalError(std::string(call) + " failed: " + data.message);
}

void require_progress(const char* library, double t, double next, const CallbackData& data) {
  if (next > t) return;
  if (data.system.fault()) data.system.throw_fault();
  throw IntegrationError(stopped(t, library) + "the step size has collapsed" + fastest(t, data));
}

}  // namespace kanec::integrate
