// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integrate/mixed_model.hpp"

#include <array>
#include <cmath>

namespace kanec::integrate::test {
namespace {

constexpr int nx = 6, ny = 5;
constexpr double A = 3.0, C = 1.5;  // moments of inertia of precession()

void kinematics(const void*, double, const double* x, const double* y, const double*, const double*, double* out) {
  const double *e = x + 1, *w = y + 1;
  out[0] = y[0];
  out[1] = 0.5 * (e[3] * w[0] + e[1] * w[2] - e[2] * w[1]);
  out[2] = 0.5 * (e[3] * w[1] + e[2] * w[0] - e[0] * w[2]);
  out[3] = 0.5 * (e[3] * w[2] + e[0] * w[1] - e[1] * w[0]);
  out[4] = -0.5 * (e[0] * w[0] + e[1] * w[1] + e[2] * w[2]);
  out[5] = y[4];
}

void accelerations(const void*, double t, const double* x, const double* y, const double*, const double*, double* out) {
  const double* w = y + 1;
  out[0] = std::cos(t);
  out[1] = (A - C) / A * w[1] * w[2];
  out[2] = (C - A) / A * w[0] * w[2];
  out[3] = 0.0;
  out[4] = -4.0 * x[5];
}

void power(const void*, double t, const double*, const double* y, const double*, const double*, double* out) {
  *out = std::cos(t) * y[0];
}

void energy(const void*, double, const double* x, const double* y, const double*, const double*, double* out) {
  out[0] = 0.5 * (y[0] * y[0] + A * (y[1] * y[1] + y[2] * y[2]) + C * y[3] * y[3] + y[4] * y[4]);
  out[1] = 2.0 * x[5] * x[5];
}

void two_in_one(const void* p, double t, const double* x, const double* y, const double* ydot, const double* u,
                double* out) {
  kinematics(p, t, x, y, ydot, u, out);
  accelerations(p, t, x, y, ydot, u, out + nx);
}

void three_in_one(const void* p, double t, const double* x, const double* y, const double* ydot, const double* u,
                  double* out) {
  two_in_one(p, t, x, y, ydot, u, out);
  power(p, t, x, y, ydot, u, out + nx + ny);
}

void prepare(const double*, void*) {}

kanec_function function(const char* name, int n_out, kanec_evaluate evaluate) {
  kanec_function result{};
  result.name = name;
  result.n_out = n_out;
  result.evaluate = evaluate;
  return result;
}

constexpr std::array<const char*, nx> coordinate_names = {"theta_1", "eps_2_1", "eps_2_2", "eps_2_3", "eps_2_4", "s_3"};
constexpr std::array<const char*, ny> speed_names = {"thetadot_1", "omega_2_1", "omega_2_2", "omega_2_3", "sdot_3"};
constexpr kanec_attitude attitude = {1, 1};

const std::array<kanec_function, 4> separate = {{function("kinematics", nx, kinematics),
                                                 function("accelerations", ny, accelerations),
                                                 function("power", 1, power), function("energy", 2, energy)}};
const std::array<kanec_function, 3> pair = {{function("kinematics_and_accelerations", nx + ny, two_in_one),
                                             function("power", 1, power), function("energy", 2, energy)}};
const std::array<kanec_function, 2> whole = {
    {function("kinematics_and_accelerations_and_power", nx + ny + 1, three_in_one), function("energy", 2, energy)}};

template <class Functions>
kanec_model with(const Functions& functions) {
  kanec_model model{};
  model.abi_version = KANEC_ABI_VERSION;
  model.struct_size = sizeof(kanec_model);
  model.name = "mixed";
  model.hash = "0000000000000000";
  model.n_bodies = 3;
  model.nx = nx;
  model.ny = ny;
  model.n_functions = static_cast<int>(functions.size());
  model.prepared_size = 1;
  model.prepare = prepare;
  model.functions = functions.data();
  model.coordinate_names = coordinate_names.data();
  model.speed_names = speed_names.data();
  model.n_attitudes = 1;
  model.attitudes = &attitude;
  return model;
}

}  // namespace

const kanec_model& mixed_model(Calls calls) {
  static const kanec_model one_each = with(separate), two = with(pair), three = with(whole);
  return calls == Calls::separate ? one_each : calls == Calls::two_in_one ? two : three;
}

State mixed_motion(double t) {
  const State ball = precession(t);
  State state;
  state.x = {0.2 + 0.5 * t + 1.0 - std::cos(t)};
  state.x.insert(state.x.end(), ball.x.begin(), ball.x.begin() + 4);
  state.x.push_back(0.3 * std::cos(2.0 * t));
  state.y = {0.5 + std::sin(t)};
  state.y.insert(state.y.end(), ball.y.begin(), ball.y.begin() + 3);
  state.y.push_back(-0.6 * std::sin(2.0 * t));
  return state;
}

double mixed_work(double t) { return 0.5 * (0.5 + std::sin(t)) * (0.5 + std::sin(t)) - 0.125; }

const kanec_model& motionless_model() {
  static const std::array<kanec_function, 2> functions = {
      {function("kinematics", 0, [](auto...) {}), function("accelerations", 0, [](auto...) {})}};
  static const kanec_model model = [] {
    kanec_model empty = with(functions);
    empty.nx = empty.ny = empty.n_attitudes = 0;
    return empty;
  }();
  return model;
}

}  // namespace kanec::integrate::test
