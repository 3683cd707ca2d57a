// Where blocks of derivatives stand in the whole. Oracle: central differences of the rates and of the residual.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/jacobian.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace kanec::integrate::test {
namespace {

// ẋ = (y1 + x2 y2, x1 y2), power = x1 y1 + y2²; A = diag(1 + x1², 2), f = (-x2 y1, x1 x2), and ẏ = A⁻¹ f.
void kinematics(const double* x, const double* y, double* out) {
  out[0] = y[0] + x[1] * y[1];
  out[1] = x[0] * y[1];
}

void rates(const void*, double, const double* x, const double* y, const double*, const double*, double* out) {
  kinematics(x, y, out);
  out[2] = -x[1] * y[0] / (1 + x[0] * x[0]);
  out[3] = x[0] * x[1] / 2;
  out[4] = x[0] * y[0] + y[1] * y[1];
}

void residual(const void*, double, const double* x, const double* y, const double* ydot, const double*, double* out) {
  kinematics(x, y, out);
  out[2] = (1 + x[0] * x[0]) * ydot[0] + x[1] * y[0];
  out[3] = 2 * ydot[1] - x[0] * x[1];
  out[4] = x[0] * y[0] + y[1] * y[1];
}

void put(std::initializer_list<double> values, double*& out) {
  for (const double value : values) *out++ = value;
}

void rate_derivatives(const void*, double, const double* x, const double* y, const double*, const double*,
                      double* out) {
  const double m = 1 + x[0] * x[0];
  put({0, y[1], y[1], 0}, out);
  put({1, x[1], 0, x[0]}, out);
  put({2 * x[0] * x[1] * y[0] / (m * m), -y[0] / m, x[1] / 2, x[0] / 2}, out);
  put({-x[1] / m, 0, 0, 0}, out);
  put({y[0], 0}, out);
  put({x[0], 2 * y[1]}, out);
}

void residual_derivatives(const void*, double, const double* x, const double* y, const double* ydot, const double*,
                          double* out) {
  put({0, y[1], y[1], 0}, out);
  put({1, x[1], 0, x[0]}, out);
  put({2 * x[0] * ydot[0], y[0], -x[1], -x[0]}, out);
  put({x[1], 0, 0, 0}, out);
  put({1 + x[0] * x[0], 0, 0, 2}, out);
  put({y[0], 0}, out);
  put({x[0], 2 * y[1]}, out);
}

kanec_function function(const char* name, int n_out, kanec_evaluate evaluate) {
  kanec_function result{};
  result.name = name;
  result.n_out = n_out;
  result.evaluate = evaluate;
  return result;
}

const kanec_model& model() {
  static const int first[] = {0, 1}, second[] = {1, 0}, upper[] = {0, 0, 1}, right[] = {0, 1, 1};
  static const int row[] = {0, 0, 1, 1}, column[] = {0, 1, 0, 1};
  static const kanec_pattern patterns[] = {
      {"kinematics_x", 2, 2, 2, first, second},  {"kinematics_y", 2, 2, 3, upper, right},
      {"accelerations_x", 2, 2, 4, row, column}, {"accelerations_y", 2, 2, 1, first, first},
      {"residual_x", 2, 2, 4, row, column},      {"residual_y", 2, 2, 1, first, first},
      {"residual_ydot", 2, 2, 2, first, first},  {"power_x", 1, 2, 1, row, first},
      {"power_y", 1, 2, 2, row, first}};
  static const kanec_function functions[] = {
      function("kinematics_and_accelerations_and_power", 5, rates),
      function("kinematics_and_residual_and_power", 5, residual),
      function("kinematics_x_and_kinematics_y_and_accelerations_x_and_accelerations_y_and_power_x_and_power_y", 20,
               rate_derivatives),
      function("kinematics_x_and_kinematics_y_and_residual_x_and_residual_y_and_residual_ydot_and_power_x_and_power_y",
               24, residual_derivatives)};
  static const char* const names[] = {"theta_1", "theta_2"};
  static const kanec_model model = [] {
    kanec_model made{};
    made.abi_version = KANEC_ABI_VERSION;
    made.struct_size = sizeof(kanec_model);
    made.name = "two";
    made.n_bodies = made.nx = made.ny = 2;
    made.n_functions = 4;
    made.prepared_size = 1;
    made.prepare = [](const double*, void*) {};
    made.functions = functions;
    made.coordinate_names = made.speed_names = names;
    made.n_patterns = 9;
    made.patterns = patterns;
    return made;
  }();
  return model;
}

using Vector = std::vector<double>;
const Vector z = {0.7, -0.4, 1.3, 0.9, 0.2}, zdot = {0.3, 0.8, -1.1, 0.6, 0.5};

// A step of 1e-5 leaves 1e-10 of a third derivative near 1, and 1e-11 of rounding.
void expect_derivatives(const Jacobian& jacobian, const std::function<Vector(const Vector& along, double step)>& at) {
  for (int j = 0; j < jacobian.size(); ++j) {
    Vector along(5), column(5);
    along[static_cast<std::size_t>(j)] = 1.0;
    for (auto k = jacobian.starts()[static_cast<std::size_t>(j)];
         k < jacobian.starts()[static_cast<std::size_t>(j) + 1]; ++k)
      column[static_cast<std::size_t>(jacobian.rows()[static_cast<std::size_t>(k)])] =
          jacobian.values()[static_cast<std::size_t>(k)];
    const Vector after = at(along, 1e-5), before = at(along, -1e-5);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(column[i], (after[i] - before[i]) / 2e-5, 1e-9) << i << " by " << j;
  }
}

Vector moved(const Vector& from, const Vector& along, double step) {
  Vector result = from;
  for (std::size_t i = 0; i < from.size(); ++i) result[i] += step * along[i];
  return result;
}

TEST(Jacobian, of_rates_is_the_limit_of_differences) {
  const Solver solver(model());
  System system(solver);
  auto jacobian = Jacobian::of_rates(system);
  ASSERT_TRUE(jacobian);
  ASSERT_TRUE(jacobian->evaluate(0.0, z.data(), nullptr, 0.0));
  expect_derivatives(*jacobian, [&](const Vector& along, double step) {
    Vector rates(5);
    system.rates(0.0, moved(z, along, step).data(), rates.data());
    return rates;
  });
}

TEST(Jacobian, of_the_residual_is_the_limit_of_differences_by_the_state_and_its_rates) {
  const Solver solver(model());
  System system(solver);
  auto jacobian = Jacobian::of_residual(system);
  ASSERT_TRUE(jacobian);
  const double c = 3.0;
  ASSERT_TRUE(jacobian->evaluate(0.0, z.data(), zdot.data(), c));
  expect_derivatives(*jacobian, [&](const Vector& along, double step) {
    Vector F(5);
    system.residual(0.0, moved(z, along, step).data(), moved(zdot, along, c * step).data(), F.data());
    return F;
  });
  EXPECT_EQ(jacobian->evaluations(), 1);
}

TEST(Residual, vanishes_for_the_rates) {
  const Solver solver(model());
  System system(solver);
  Vector rates(5), F(5);
  system.rates(0.0, z.data(), rates.data());
  system.residual(0.0, z.data(), rates.data(), F.data());
  for (const double entry : F) EXPECT_NEAR(entry, 0.0, 1e-15);  // a rounding or two of numbers below 2
}

}  // namespace
}  // namespace kanec::integrate::test
