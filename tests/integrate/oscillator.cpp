// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integrate/oscillator.hpp"

#include <array>

namespace kanec::integrate::test {
namespace {

double acceleration(const double* x, const double* u) { return u[0] - 4.0 * x[0]; }

void rates(const void*, double, const double* x, const double* y, const double*, const double* u, double* out) {
  out[0] = y[0];
  out[1] = acceleration(x, u);
  out[2] = u[0] * y[0];
}

void residual(const void*, double, const double* x, const double* y, const double* ydot, const double* u, double* out) {
  out[0] = y[0];
  out[1] = ydot[0] - acceleration(x, u);
  out[2] = u[0] * y[0];
}

void energy(const void*, double, const double* x, const double* y, const double*, const double*, double* out) {
  out[0] = 0.5 * y[0] * y[0];
  out[1] = 2.0 * x[0] * x[0];
}

void events(const void*, double t, const double* x, const double* y, const double*, const double*, double* out) {
  out[0] = x[0];
  out[1] = y[0];
  out[2] = t - 0.5;
}

kanec_function function(const char* name, int n_out, kanec_evaluate evaluate) {
  kanec_function result{};
  result.name = name;
  result.n_out = n_out;
  result.evaluate = evaluate;
  return result;
}

}  // namespace

const kanec_model& oscillator() {
  static const std::array<kanec_function, 4> functions = {{function("kinematics_and_accelerations_and_power", 3, rates),
                                                           function("kinematics_and_residual_and_power", 3, residual),
                                                           function("energy", 2, energy),
                                                           function("events", 3, events)}};
  static const char *const coordinate = "s_1", *const speed = "sdot_1", *const input = "u";
  static const double no_input = 0.0;
  static const kanec_model model = [] {
    kanec_model made{};
    made.abi_version = KANEC_ABI_VERSION;
    made.struct_size = sizeof(kanec_model);
    made.name = "oscillator";
    made.hash = "0000000000000000";
    made.n_bodies = made.nx = made.ny = made.n_inputs = 1;
    made.n_functions = static_cast<int>(functions.size());
    made.input_names = &input;
    made.input_defaults = &no_input;
    made.prepared_size = 1;
    made.prepare = [](const double*, void*) {};
    made.functions = functions.data();
    made.coordinate_names = &coordinate;
    made.speed_names = &speed;
    return made;
  }();
  return model;
}

}  // namespace kanec::integrate::test
