// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/reach.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "generator/lower/derivatives.hpp"
#include "generator/program/ledger.hpp"
#include "generator/requests.hpp"
#include "runtime/base/error.hpp"

namespace kanec {
namespace {

constexpr long much = 200'000, most = 2'000'000;

// "1,234,000 operations"
std::string counted(long operations) {
  std::string digits = std::to_string(operations / 1000) + "000";
  for (auto at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3) digits.insert(static_cast<std::size_t>(at), ",");
  return digits + " operations";
}

std::string some(long operations) { return "some " + counted(operations); }

double speeds(const scene::Joint& joint) {
  const auto is_free = [](const scene::Coordinate& c) { return c.motion == scene::Coordinate::Motion::free; };
  const auto free = std::count_if(joint.turns.begin(), joint.turns.end(), is_free) +
                    std::count_if(joint.slides.begin(), joint.slides.end(), is_free);
  return static_cast<double>(free) + (joint.ball && !joint.held ? 3 : 0);
}

bool may_turn(const scene::Joint& joint) {
  return (joint.ball && !joint.held) ||
         std::any_of(joint.turns.begin(), joint.turns.end(),
                     [](const scene::Coordinate& c) { return c.motion != scene::Coordinate::Motion::locked; });
}

bool has_mass_matrix(const std::string& name) {
  const std::vector<std::string> of = parts(name);
  return std::find(of.begin(), of.end(), "mass_matrix") != of.end();
}

// A derivative that the matrix is a step to.
bool needs_mass_matrix(const scene::Scene& scene, const std::string& name) {
  const std::vector<std::string> of = parts(name);
  return std::any_of(of.begin(), of.end(), [&](const std::string& part) {
    const std::optional<lower::Derived> derived = lower::derived_function(scene, part);
    return derived && (derived->of == "accelerations" || derived->by.front() == "ydot");
  });
}

}  // namespace

long mass_matrix_operations(const scene::Scene& scene) {
  std::vector<double> root;  // of the number of a body's speeds
  double sum = 0;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    root.push_back(std::sqrt(speeds(scene.bodies[k].joint)));
    bool turns = false;  // slides alone have a number between them
    for (int j = static_cast<int>(k) + 1; j > 0; j = scene.lower[static_cast<std::size_t>(j - 1)]) {
      const auto lower = static_cast<std::size_t>(j - 1);
      turns = turns || may_turn(scene.bodies[lower].joint);
      if (turns) sum += root[k] * root[lower];
    }
  }
  return std::lround(22.5 * sum);
}

std::vector<std::string> notes_on_size(const program::Program& program) {
  std::vector<std::string> notes;
  for (const program::Function& function : program.functions) {
    const long operations = program::ledger(program, function).operations();
    if (operations > much && function.name != "mass_matrix")
      notes.push_back(function.name + " takes " + some(operations) + "; --functions names those to be made");
  }
  return notes;
}

Reach within_reach(const scene::Scene& scene, const std::vector<std::string>& names, bool are_named) {
  Reach reach{names, {}};
  const long operations = mass_matrix_operations(scene);
  if (operations <= much) return reach;
  std::erase_if(reach.names, [&](const std::string& name) { return !are_named && has_mass_matrix(name); });
  if (reach.names.size() < names.size())
    reach.notes.push_back("mass_matrix is left out: it would take " + some(operations) +
                          "; with --functions mass_matrix it is made");
  for (const std::string& name : reach.names) {
    const bool has = has_mass_matrix(name);
    if (!has && !needs_mass_matrix(scene, name)) continue;
    if (operations > most)
      throw InputError("function " + name + ": found " + some(operations) + " for the mass matrix of this scene" +
                       (has ? "" : ", which it needs") + "; allowed: at most " + counted(most) +
                       " (residual and accelerations do without the matrix)");
    reach.notes.push_back(name + (has ? " takes " : " needs the mass matrix, which takes ") + some(operations) +
                          ": minutes to compile");
  }
  return reach;
}

}  // namespace kanec
