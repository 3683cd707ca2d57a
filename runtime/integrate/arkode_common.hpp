// What the explicit and the implicit methods of ARKODE have in common. Not: what CVODE and IDA share with them
// (sundials.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <arkode/arkode.h>

#include "runtime/integrate/norm.hpp"
#include "runtime/integrate/sundials.hpp"

namespace kanec::integrate {

// Called after every accepted step: unit norm, and how far off it was.
extern "C" inline int kanec_arkode_project(realtype, N_Vector z, void* data) {
  auto& callback = *static_cast<CallbackData*>(data);
  callback.norm_error = normalise(N_VGetArrayPointer(z), callback.system.attitudes());
  return 0;
}

// Whether a step failed because a rate is not finite.
inline bool failed_in_rates(int flag) {
  return flag == ARK_RHSFUNC_FAIL || flag == ARK_FIRST_RHSFUNC_ERR || flag == ARK_REPTD_RHSFUNC_ERR ||
         flag == ARK_UNREC_RHSFUNC_ERR;
}

}  // namespace kanec::integrate
