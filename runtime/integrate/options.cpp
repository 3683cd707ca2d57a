// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/integrate/jacobian.hpp"

namespace kanec::integrate {
namespace {

constexpr std::array<std::pair<std::string_view, Method>, 12> methods = {
    {{"rk4", Method::rk4},
     {"lie4", Method::lie4},
     {"gauss4", Method::gauss4},
     {"gauss6", Method::gauss6},
     {"dop853", Method::dop853},
     {"arkode", Method::arkode},
     {"arkode_dirk", Method::arkode_dirk},
     {"cvode", Method::cvode},
     {"cvode_bdf", Method::cvode_bdf},
     {"ida", Method::ida},
     {"taylor", Method::taylor},
     {"taylor_extended", Method::taylor_extended}}};

constexpr std::array<std::pair<std::string_view, JacobianChoice>, 4> jacobians = {
    {{"auto", JacobianChoice::automatic},
     {"dense", JacobianChoice::dense},
     {"sparse", JacobianChoice::sparse},
     {"differences", JacobianChoice::differences}}};

[[noreturn]] void refuse(const std::string& option, const std::string& found, const std::string& allowed) {
  throw InputError(option + ": found " + found + "; allowed: " + allowed);
}

void require_positive(const std::string& option, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) refuse(option, shortest(value), "a positive number");
}

// More intervals than this and consecutive times are no longer told apart reliably.
void require_resolvable(const std::string& option, double step, double duration) {
  if (duration / step > 1e14) refuse(option, shortest(step), "at least 1e-14 of the duration");
}

void check_tolerance(const std::string& option, double value) {
  if (!(value > 0.0 && value < 1.0)) refuse(option, shortest(value), "a number between 0 and 1, both excluded");
}

// The choice of that name, or a refusal that lists all.
template <class Table>
auto choice_of(const Table& table, const std::string& option, std::string_view name) {
  std::string allowed;
  for (const auto& [known, choice] : table) {
    if (name == known) return choice;
    if (!allowed.empty()) allowed += ", ";
    allowed += known;
  }
  refuse(option, std::string("'").append(name) + "'", allowed);
}

template <class Table, class Choice>
std::string name_in(const Table& table, Choice choice) {
  for (const auto& [name, known] : table)
    if (choice == known) return std::string(name);
  throw InternalError("a choice without a name");
}

// Of the methods that have one.
void check_order(const Options& options) {
  const int order = arkode_order(options);
  if (options.method == Method::arkode_dirk && (order < 2 || order > 5))
    refuse("order", std::to_string(order), "0, 2, 3, 4, 5");
  if (options.method == Method::arkode && order != 4 && order != 5 && order != 6 && order != 8)
    refuse("order", std::to_string(order), "0, 4, 5, 6, 8");
}

}  // namespace

bool needs_series(Method method) { return method == Method::taylor || method == Method::taylor_extended; }

bool has_fixed_step(Method method) {
  return method == Method::rk4 || method == Method::lie4 || method == Method::gauss4 || method == Method::gauss6;
}

bool has_jacobian(Method method) {
  return method == Method::arkode_dirk || method == Method::cvode_bdf || method == Method::ida;
}

std::vector<std::string> needed_functions(const Options& options, bool has_power, int nx) {
  const std::string power = has_power ? "+power" : "";
  std::vector<std::string> list = {"kinematics+accelerations" + power};
  if (options.method == Method::ida) list.push_back("kinematics+residual" + power);
  if (!has_jacobian(options.method) || options.jacobian == JacobianChoice::differences || nx == 0) return list;
  list.push_back(options.method == Method::ida ? Jacobian::request_of_residual(has_power)
                                               : Jacobian::request_of_rates(has_power));
  return list;
}

std::int64_t equal_steps(double stretch, double longest) {
  if (!(stretch > 0.0)) return 0;
  return std::max<std::int64_t>(static_cast<std::int64_t>(std::ceil(stretch / longest - 1e-9)), 1);
}

int arkode_order(const Options& options) {
  if (options.order != 0) return options.order;
  if (options.method == Method::arkode_dirk) return 5;
  return options.has_kinks || options.relative_tolerance > 1e-6 ? 5 : 8;
}

void check(const Options& options) {
  if (!(options.duration >= 0.0) || !std::isfinite(options.duration))
    refuse("duration", shortest(options.duration), "zero or a positive number");
  if (!(options.start >= 0.0) || !std::isfinite(options.start))
    refuse("start", shortest(options.start), "zero or a positive number");
  if (options.duration < options.start)
    refuse("duration", shortest(options.duration), "at least the start, " + shortest(options.start));
  require_positive("output step", options.output_step);
  require_resolvable("output step", options.output_step, options.duration);
  require_positive("step", options.step);
  require_resolvable("step", options.step, options.duration);
  if (options.longest_step != 0.0) {
    require_positive("longest step", options.longest_step);
    require_resolvable("longest step", options.longest_step, options.duration);
  }
  check_tolerance("relative tolerance", options.relative_tolerance);
  check_tolerance("absolute tolerance", options.absolute_tolerance);
  check_order(options);
  if (options.max_steps < 1) refuse("max steps", std::to_string(options.max_steps), "at least 1");
}

Method method_of(std::string_view name) { return choice_of(methods, "integrator", name); }
std::string name_of(Method method) { return name_in(methods, method); }
JacobianChoice jacobian_of(std::string_view name) { return choice_of(jacobians, "jacobian", name); }
std::string name_of(JacobianChoice choice) { return name_in(jacobians, choice); }

std::vector<std::string> method_names() {
  std::vector<std::string> list;
  for (const auto& [name, method] : methods) list.emplace_back(name);
  return list;
}

RowTimes::RowTimes(double duration, double output_step, double start)
    : start_(start), duration_(duration), step_(output_step) {
  constexpr double rounding = 1e-6;  // of a step
  first_ = static_cast<std::int64_t>(std::floor(start / output_step + rounding)) + 1;
  const double intervals = duration / output_step;
  const double whole = std::round(intervals);
  // a last interval shorter than a millionth of the step is rounding, not a row
  const bool even = std::fabs(intervals - whole) < rounding;
  last_ = static_cast<std::int64_t>(even ? whole : std::ceil(intervals));
  last_ = std::max(last_, duration > start ? first_ : first_ - 1);
}

}  // namespace kanec::integrate
