// What the adapters of ARKODE, CVODE and IDA share: handles, the callback into System, errors. Not: any stepping.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "runtime/integrate/system.hpp"

namespace kanec::integrate {

// Trials of one step before it is given up: each is some times as short as the one before it. After a kink or a start
// more may be needed than the libraries' 7 to 10.
inline constexpr int most_error_tests = 40;

struct VectorDeleter {
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
};
using VectorHandle = std::unique_ptr<std::remove_pointer_t<N_Vector>, VectorDeleter>;

// An N_Vector over the entries of `values`, which must outlive it and keep their place.
VectorHandle view(std::vector<double>& values, const sundials::Context& context);

class LinearSolver;

// What the C callbacks are given.
struct CallbackData {
  System& system;
  const std::vector<double>* state = nullptr;  // at the end of the last step
  LinearSolver* linear = nullptr;              // of methods with Newton's iteration
  double norm_error = 0.0;                     // before the last projection made inside the library
  std::string message = {};                    // last error that the library reported
};

// Signatures of ARKRhsFn and CVRhsFn (1: not finite), and of their error handlers: messages are kept, warnings dropped.
extern "C" int kanec_sundials_rates(realtype t, N_Vector z, N_Vector zdot, void* data);
extern "C" void kanec_sundials_message(int code, const char* module, const char* function, char* message, void* data);

// Throws InternalError for a failed call other than a step (flag < 0).
void require(int flag, const char* call, const CallbackData& data);

// A count that the library keeps.
std::int64_t count(int (*get)(void*, long*), void* memory, const char* call, const CallbackData& data);

struct Library {
  const char* name;                 // in messages
  std::span<const int> rate_flags;  // of a step that failed because a rate, or the residual, is not finite
};

// One step on from t: `take` makes it, writes where it ends, and returns the library's flag. Returns the end. Throws
// IntegrationError for a failed step, with the rate that is not finite or the library's own words, and for one that did
// not move: the step size has collapsed, or a rate is not finite.
double take_step(const Library& library, double t, CallbackData& data, const std::function<int(double*)>& take);

}  // namespace kanec::integrate
