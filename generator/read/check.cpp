// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "generator/read/eigenvalues.hpp"
#include "runtime/base/text.hpp"

namespace kanec::scene {
namespace {

// Below this part of the largest, a moment cannot be told from zero: eigenvalues are known to a few 1e-16 of it.
constexpr double zero_moment = 1e-14;
// Moments of a flat body meet the inequality exactly; written in decimal they may miss it by some roundings.
constexpr double triangle_margin = 1e-12;
// Smaller ones have no reciprocal worth the name.
constexpr double least_mass = 1e-100;
constexpr double most_rows = 1e8;
constexpr double most_steps = 1e12;

std::string listed(const std::array<double, 3>& moments) {
  return shortest(moments[0]) + ", " + shortest(moments[1]) + ", " + shortest(moments[2]);
}

std::string entries_text(const Symmetric& inertia, const Symbols& symbols) {
  const auto entry = [&symbols](const char* name, const Number& number) {
    return std::string(name) + " " + symbols.shown(number);
  };
  return entry("xx", inertia.xx) + ", " + entry("yy", inertia.yy) + ", " + entry("zz", inertia.zz) + ", " +
         entry("xy", inertia.xy) + ", " + entry("xz", inertia.xz) + ", " + entry("yz", inertia.yz);
}

std::array<double, 3> principal_moments(const Symmetric& inertia, const Symbols& symbols) {
  const auto value = [&symbols](const Number& number) { return symbols.value(number); };
  return eigenvalues({{{value(inertia.xx), value(inertia.xy), value(inertia.xz)},
                       {value(inertia.xy), value(inertia.yy), value(inertia.yz)},
                       {value(inertia.xz), value(inertia.yz), value(inertia.zz)}}});
}

void check_positive(double value, const Place& place) {
  if (!(std::isfinite(value) && value > 0)) fail(place, shortest(value), "a positive finite number");
}

// `what` so many times in the duration, each `interval` long
void check_count(double duration, double interval, double most, const std::string& what, const Place& place) {
  if (duration / interval > most)
    fail(place, shortest(interval) + ", which makes " + shortest(std::ceil(duration / interval)) + " " + what,
         "at most " + shortest(most) + " " + what + " in the duration, " + shortest(duration));
}

void check_choice(const std::string& value, const std::vector<std::string>& known, const Place& place) {
  if (std::find(known.begin(), known.end(), value) == known.end()) fail(place, in_quotes(value), one_of(known, value));
}

// Of the methods that have one.
void check_order(const Simulation& simulation, const Place& place) {
  const std::vector<int> of_explicit = {0, 4, 5, 6, 8}, of_implicit = {0, 2, 3, 4, 5};
  const bool is_implicit = simulation.integrator == "arkode_dirk";
  if (!is_implicit && simulation.integrator != "arkode") return;
  const std::vector<int>& known = is_implicit ? of_implicit : of_explicit;
  if (std::find(known.begin(), known.end(), simulation.order) != known.end()) return;
  fail(place, std::to_string(simulation.order), std::string(is_implicit ? "2, 3, 4, 5" : "4, 5, 6, 8") + ", or 0");
}

}  // namespace

const std::vector<std::string>& simulation_integrators() {
  static const std::vector<std::string> names = {"rk4",       "lie4",   "gauss4",      "gauss6",
                                                 "dop853",    "arkode", "arkode_dirk", "cvode",
                                                 "cvode_bdf", "ida",    "taylor",      "taylor_extended"};
  return names;
}

const std::vector<std::string>& simulation_jacobians() {
  static const std::vector<std::string> names = {"auto", "dense", "sparse", "differences"};
  return names;
}

void check_mass(const Number& mass, const Symbols& symbols, const Place& place) {
  const double value = symbols.value(mass);
  if (value != 0 && value < least_mass) fail(place, symbols.shown(mass), "a positive number, or zero");
}

void check_inertia(const Symmetric& inertia, const Symbols& symbols, const Place& place) {
  const std::array<double, 3> moments = principal_moments(inertia, symbols);
  const bool negative = moments[0] < -zero_moment * moments[2] || moments[2] < 0;
  if (negative || (moments[2] != 0 && moments[2] < least_mass))
    fail(place, "principal moments " + listed(moments) + " (entries " + entries_text(inertia, symbols) + ")",
         negative ? "a positive definite matrix; one of these is negative" : "larger ones, or zeros");
}

std::optional<std::string> inertia_warning(const Symmetric& inertia, bool one_direction, const Symbols& symbols,
                                           const Place& place) {
  const std::array<double, 3> moments = principal_moments(inertia, symbols);
  if (moments[0] + moments[1] >= moments[2] * (1 - triangle_margin)) return std::nullopt;
  if (one_direction && moments[1] <= zero_moment * moments[2]) return std::nullopt;
  return remark(place, "principal moments " + listed(moments) + " (entries " + entries_text(inertia, symbols) +
                           ") violate the triangle inequality: the largest exceeds the sum of the others, as in no "
                           "rigid body; modelled as written");
}

void check_simulation(const Simulation& simulation, const PlaceOf& place_of) {
  check_positive(simulation.duration, place_of("duration"));
  check_positive(simulation.output_step, place_of("output_step"));
  check_positive(simulation.step, place_of("step"));
  check_positive(simulation.relative_tolerance, place_of("relative_tolerance"));
  check_positive(simulation.absolute_tolerance, place_of("absolute_tolerance"));
  check_count(simulation.duration, simulation.output_step, most_rows, "rows", place_of("output_step"));
  check_count(simulation.duration, simulation.step, most_steps, "steps", place_of("step"));
  if (simulation.longest_step != 0) {
    check_positive(simulation.longest_step, place_of("longest_step"));
    check_count(simulation.duration, simulation.longest_step, most_steps, "steps", place_of("longest_step"));
  }
  if (simulation.absolute_tolerance >= 1)
    fail(place_of("absolute_tolerance"), shortest(simulation.absolute_tolerance), "a positive number below 1");
  const double tightest = simulation.integrator.starts_with("taylor") ? 1e-20 : 1e-15;
  if (simulation.relative_tolerance < tightest || simulation.relative_tolerance >= 1)
    fail(place_of("relative_tolerance"), shortest(simulation.relative_tolerance),
         "from " + shortest(tightest) + " to below 1");
  check_choice(simulation.integrator, simulation_integrators(), place_of("integrator"));
  check_choice(simulation.jacobian, simulation_jacobians(), place_of("jacobian"));
  check_order(simulation, place_of("order"));
}

}  // namespace kanec::scene
