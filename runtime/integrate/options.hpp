// How long to integrate, with which method, how finely. Not here: what the command line or the scene calls these.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kanec::integrate {

enum class Method {
  rk4,        // classical Runge-Kutta, fixed step
  gauss4,     // Gauss collocation of order 4, fixed step: keeps quadratic invariants, energy does not drift
  gauss6,     // the same of order 6
  arkode,     // SUNDIALS ARKODE, explicit Runge-Kutta pair of order 4 to 8, error control
  cvode,      // SUNDIALS CVODE, Adams-Moulton of order 1 to 12, error control
  cvode_bdf,  // SUNDIALS CVODE, BDF of order 1 to 5 with a dense difference-quotient Jacobian, for stiff loads
};

struct Options {
  Method method = Method::arkode;
  double duration = 10.0;             // from t = 0 [s]
  double output_step = 0.01;          // between rows [s]; the last row stands at the duration
  double step = 1e-3;                 // of rk4, gauss4 and gauss6, the longest [s]: each row interval is divided evenly into such steps
  double relative_tolerance = 1e-9;   // of the error-controlled methods, local error a step
  double absolute_tolerance = 1e-12;  // the same, in the unit of each component
  int order = 0;                      // of arkode: 4, 5, 6 or 8; 0 = 5 for relative tolerances above 1e-6, else 8
  std::int64_t max_steps = 100'000'000;
};

// Whether a method takes equal steps, Options::step at the longest.
bool has_fixed_step(Method method);

// In how many of them a stretch of time is divided.
std::int64_t equal_steps(double stretch, double longest);

// The order that arkode takes with these options.
int arkode_order(const Options& options);

// Throws InputError that names the option, what was found and what is allowed.
void check(const Options& options);

// "rk4", "gauss4", "gauss6", "arkode", "cvode", "cvode_bdf". Throws InputError for another name.
Method method_of(std::string_view name);
std::string name_of(Method method);

// All names, in order.
std::vector<std::string> method_names();

// Times of the rows: 0, output_step, 2 output_step, …, duration, each computed on its own.
class RowTimes {
 public:
  RowTimes(double duration, double output_step);
  std::int64_t size() const { return last_ + 1; }
  double operator[](std::int64_t row) const { return row == last_ ? duration_ : static_cast<double>(row) * step_; }

 private:
  double duration_, step_;
  std::int64_t last_;
};

}  // namespace kanec::integrate
