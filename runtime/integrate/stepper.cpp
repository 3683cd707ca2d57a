// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/stepper.hpp"

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/integrate/norm.hpp"

namespace kanec::integrate {

void StepBook::accepted(double t, double norm_error) {
  if (steps >= max_steps_)
    throw IntegrationError("integration stopped at t = " + shortest(t) + " s: the limit of " +
                           std::to_string(max_steps_) + " steps is reached");
  ++steps;
  worst_norm_error = worse(worst_norm_error, norm_error);
  if (at_time_) at_time_(t);
}

std::unique_ptr<Stepper> make_stepper(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  switch (options.method) {
    case Method::rk4:
      return make_rk4(system, std::move(z), options, book);
    case Method::lie4:
      return make_lie(system, std::move(z), options, book);
    case Method::gauss4:
    case Method::gauss6:
      return make_gauss(system, std::move(z), options, book);
    case Method::dop853:
      return make_dop853(system, std::move(z), options, book);
    case Method::arkode:
      return make_arkode(system, std::move(z), options, book);
    case Method::arkode_dirk:
      return make_dirk(system, std::move(z), options, book);
    case Method::cvode:
    case Method::cvode_bdf:
      return make_cvode(system, std::move(z), options, book);
    case Method::taylor:
    case Method::taylor_extended:
      return make_taylor(system, std::move(z), options, book);
    case Method::ida:
      return make_ida(system, std::move(z), options, book);
  }
  throw InternalError("integration method without a stepper");
}

}  // namespace kanec::integrate
