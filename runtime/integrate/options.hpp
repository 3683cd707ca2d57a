// From when to when to integrate, with which method, how finely. Not here: what the command line or the scene calls
// these.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/integrate/event.hpp"

namespace kanec::integrate {

enum class Method {
  rk4,          // classical Runge-Kutta, fixed step
  lie4,         // the same on the group of rotations, fixed step: attitudes turn by rotation vectors, none is projected
  gauss4,       // Gauss collocation of order 4, fixed step: keeps quadratic invariants, energy does not drift
  gauss6,       // the same of order 6
  dop853,       // explicit Runge-Kutta pair of order 8, Dormand's and Prince's, error control; rows within its steps
  arkode,       // SUNDIALS ARKODE, explicit Runge-Kutta pair of order 4 to 8, error control
  arkode_dirk,  // the same, diagonally implicit of order 2 to 5, for stiff loads
  cvode,        // SUNDIALS CVODE, Adams-Moulton of order 1 to 12, error control
  cvode_bdf,    // SUNDIALS CVODE, BDF of order 1 to 5, for stiff loads
  ida,          // SUNDIALS IDA, BDF of order 1 to 5 on r(x, y, ẏ) = 0, which A is not solved for
  taylor,       // Taylor series of order 4 to 24, error control
  taylor_extended,  // the same in long double, up to order 32: for references
};

// Where arkode_dirk, cvode_bdf and ida have the derivatives of the rates from, and how they solve with them.
enum class JacobianChoice {
  automatic,    // emitted and sparse where the model has them, else differences
  dense,        // emitted, L U
  sparse,       // emitted, KLU with their pattern of nonzeros
  differences,  // of rates, a column an evaluation; dense
};

struct Options {
  Method method = Method::dop853;
  double start = 0.0;         // [s]
  double work = 0.0;          // of the applied loads before the start [J]
  double duration = 10.0;     // where the run ends, from t = 0 [s]
  double output_step = 0.01;  // between rows [s]; the last row stands at the duration
  double step = 1e-3;         // of fixed steps, the longest [s]: each row interval is divided evenly into such steps
  double longest_step = 0.0;  // of the error-controlled methods [s]; 0: as long as the error allows
  double relative_tolerance = 1e-9;   // of the error-controlled methods, local error a step
  double absolute_tolerance = 1e-12;  // the same, in the unit of each component
  // of arkode: 4, 5, 6 or 8; 0 = 5 for relative tolerances above 1e-6 or with kinks, else 8. Of arkode_dirk: 2 to 5;
  // 0 = 5
  int order = 0;
  bool has_kinks = false;  // rates that are not smooth everywhere: Taylor series are compared with rates within a step
  JacobianChoice jacobian = JacobianChoice::automatic;
  std::int64_t max_steps = 100'000'000;
  std::vector<Event> events;  // watched for; by the entries of the model's function `events`
};

// Whether a method needs a model that was compiled with its Taylor series.
bool needs_series(Method method);

// Whether a method takes equal steps, Options::step at the longest.
bool has_fixed_step(Method method);

// In how many of them a stretch of time is divided.
std::int64_t equal_steps(double stretch, double longest);

// Whether a method solves with derivatives of the rates, or of the residual.
bool has_jacobian(Method method);

// What the generator has to be asked for, so that the model can be run with these options: "kinematics+accelerations".
// has_power: the scene has that function; nx: its coordinates.
std::vector<std::string> needed_functions(const Options& options, bool has_power, int nx);

// The order that arkode or arkode_dirk takes with these options.
int arkode_order(const Options& options);

// Throws InputError that names the option, what was found and what is allowed.
void check(const Options& options);

// All names, in order: "rk4", "lie4", … And one's method; throws InputError for another name.
std::vector<std::string> method_names();
Method method_of(std::string_view name);
std::string name_of(Method method);

// "auto", "dense", "sparse", "differences". Likewise.
JacobianChoice jacobian_of(std::string_view name);
std::string name_of(JacobianChoice choice);

// Times of the rows: the start, all multiples of output_step after it, and the duration, each computed on its own.
class RowTimes {
 public:
  RowTimes(double duration, double output_step, double start = 0.0);
  std::int64_t size() const { return last_ - first_ + 2; }
  double operator[](std::int64_t row) const {
    if (row == 0) return start_;
    const std::int64_t multiple = first_ + row - 1;
    return multiple == last_ ? duration_ : static_cast<double>(multiple) * step_;
  }

 private:
  double start_, duration_, step_;
  std::int64_t first_, last_;  // multiples of the step after the start
};

}  // namespace kanec::integrate
