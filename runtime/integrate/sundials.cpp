// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/sundials.hpp"

#include <algorithm>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"

namespace kanec::integrate {
namespace {

std::string stopped(double t, const Library& library) {
  return "integration stopped at t = " + shortest(t) + " s: " + library.name + ": ";
}

std::string fastest(double t, const CallbackData& data) {
  return data.state ? "; fastest changes " + data.system.fastest(t, data.state->data()) : "";
}

[[noreturn]] void throw_step_failure(const Library& library, double t, int flag, const CallbackData& data) {
  const bool in_rates =
      std::find(library.rate_flags.begin(), library.rate_flags.end(), flag) != library.rate_flags.end();
  if (in_rates && data.system.fault()) data.system.throw_fault();
  throw IntegrationError(stopped(t, library) + (data.message.empty() ? "no cause given" : data.message) +
                         fastest(t, data));
}

[[noreturn]] void throw_collapse(const Library& library, double t, const CallbackData& data) {
  if (data.system.fault()) data.system.throw_fault();
  throw IntegrationError(stopped(t, library) + "the step size has collapsed" + fastest(t, data));
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

void require(int flag, const char* call, const CallbackData& data) {
  if (flag < 0) throw InternalError(std::string(call) + " failed: " + data.message);
}

std::int64_t count(int (*get)(void*, long*), void* memory, const char* call, const CallbackData& data) {
  long value = 0;
  require(get(memory, &value), call, data);
  return value;
}

double take_step(const Library& library, double t, CallbackData& data, const std::function<int(double*)>& take) {
  data.system.clear_fault();
  double next = t;
  const int flag = take(&next);
  if (flag < 0) throw_step_failure(library, next, flag, data);
  if (!(next > t)) throw_collapse(library, t, data);
  return next;
}

}  // namespace kanec::integrate
