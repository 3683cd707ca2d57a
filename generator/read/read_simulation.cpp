// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/read_simulation.hpp"

#include "generator/read/check.hpp"

namespace kanec::scene {
namespace {

void refuse_other_keys(const Table& table, const std::vector<std::string>& more_keys) {
  std::vector<std::string> keys = {"duration",           "output_step",  "integrator", "step", "relative_tolerance",
                                   "absolute_tolerance", "longest_step", "jacobian",   "order"};
  keys.insert(keys.end(), more_keys.begin(), more_keys.end());
  table.only(keys);
}

}  // namespace

Simulation read_simulation(const Table& table, const Simulation& usual, const std::string& origin,
                           const std::vector<std::string>& more_keys) {
  refuse_other_keys(table, more_keys);
  Simulation out = usual;
  const auto real = [&table](const char* key, double& value) {
    if (const auto found = table.find(key)) value = found->real("a positive number");
  };
  real("duration", out.duration);
  real("output_step", out.output_step);
  real("step", out.step);
  real("relative_tolerance", out.relative_tolerance);
  real("absolute_tolerance", out.absolute_tolerance);
  real("longest_step", out.longest_step);
  const auto name = [&table](const char* key, const std::vector<std::string>& known, std::string& value) {
    if (const auto found = table.find(key)) value = found->text(one_of(known, ""));
  };
  name("integrator", simulation_integrators(), out.integrator);
  name("jacobian", simulation_jacobians(), out.jacobian);
  if (const auto found = table.find("order")) out.order = found->integer("an order, or 0");
  check_simulation(out, [&](const std::string& key) {
    const auto found = table.find(key);
    Place place = found ? found->place() : table.place();
    if (!found) place.field += "." + key + " (" + origin + ")";
    return place;
  });
  return out;
}

}  // namespace kanec::scene
