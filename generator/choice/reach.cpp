// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/choice/reach.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "generator/choice/requests.hpp"
#include "generator/lower/derivatives.hpp"
#include "generator/program/ledger.hpp"
#include "runtime/base/error.hpp"

namespace kanec {
namespace {

constexpr long much = 200'000, most_operations = 2'000'000;

// "1,234,000 operations"
std::string counted(long operations) {
  std::string digits = std::to_string(operations / 1000) + "000";
  for (auto at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3) digits.insert(static_cast<std::size_t>(at), ",");
  return digits + " operations";
}

std::string some(long operations) { return "some " + counted(operations); }

bool is_free(const scene::Coordinate& c) { return c.motion == scene::Coordinate::Motion::free; }

// Its speeds, several turns counted as more: they have a link each.
double speeds(const scene::Joint& joint) {
  const auto count = [](const std::vector<scene::Coordinate>& list) {
    return static_cast<double>(std::count_if(list.begin(), list.end(), is_free));
  };
  const double turns = joint.ball ? 0 : count(joint.turns);
  return std::pow(turns, 1.64) + count(joint.slides) + (joint.ball && !joint.held ? 3 : 0);
}

bool may_turn(const scene::Joint& joint) {
  return (joint.ball && !joint.held) ||
         std::any_of(joint.turns.begin(), joint.turns.end(),
                     [](const scene::Coordinate& c) { return c.motion != scene::Coordinate::Motion::locked; });
}

bool has_part(const std::string& name, const std::string& part) {
  const std::vector<std::string> of = parts(name);
  return std::find(of.begin(), of.end(), part) != of.end();
}

// A derivative that the matrix is a step to.
bool needs_mass_matrix(const scene::Scene& scene, const std::string& name) {
  const std::vector<std::string> of = parts(name);
  return std::any_of(of.begin(), of.end(), [&](const std::string& part) {
    const std::optional<lower::Derived> derived = lower::derived_function(scene, part);
    return derived && (derived->of == "accelerations" || derived->by.front() == "ydot");
  });
}

// Of bodies and of scalar speeds that turn them: of turns, and of balls whose ω links above have a share of.
long turned_pairs(const scene::Scene& scene) {
  std::vector<bool> passes_on(scene.bodies.size(), false);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k)
    if (scene.lower[k] > 0 && !scene.bodies[k].joint.ball)
      passes_on[static_cast<std::size_t>(scene.lower[k] - 1)] = true;
  std::vector<long> turns;  // below and at each body
  long sum = 0;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const scene::Joint& joint = scene.bodies[k].joint;
    const long below = scene.lower[k] > 0 ? turns[static_cast<std::size_t>(scene.lower[k] - 1)] : 0;
    const bool is_shared = joint.held || !passes_on[k];
    const long own = joint.ball ? (is_shared ? 0 : 3) : std::count_if(joint.turns.begin(), joint.turns.end(), is_free);
    turns.push_back(below + own);
    sum += turns.back();
  }
  return sum;
}

struct Large {
  std::string name;
  long operations;
};

// Usual functions that grow with the square of the tree, where they have grown too large.
std::vector<Large> large_functions(const scene::Scene& scene) {
  std::vector<Large> list = {{"mass_matrix", mass_matrix_operations(scene)},
                             {"partial_velocities", partial_velocity_operations(scene)},
                             {"partial_velocity_rates", partial_velocity_rate_operations(scene)}};
  std::erase_if(list, [](const Large& large) { return large.operations <= much; });
  return list;
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

long partial_velocity_operations(const scene::Scene& scene) { return 57 * turned_pairs(scene); }

long partial_velocity_rate_operations(const scene::Scene& scene) { return 122 * turned_pairs(scene); }

std::vector<std::string> notes_on_size(const program::Program& program, const Reach& reach) {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < reach.names.size(); ++i) {
    const long operations = program::ledger(program, program.functions[i]).operations();
    if (operations > much && !reach.is_told[i])
      notes.push_back(program.functions[i].name + " takes " + some(operations) +
                      "; --functions names those to be made");
  }
  return notes;
}

namespace {

// The first of the large functions that a request has or needs.
std::optional<std::string> note_on(const scene::Scene& scene, const std::string& name,
                                   const std::vector<Large>& large) {
  for (const auto& [part, operations] : large) {
    const bool has = has_part(name, part);
    const bool is_matrix = part == "mass_matrix";
    if (!has && !(is_matrix && needs_mass_matrix(scene, name))) continue;
    if (is_matrix && operations > most_operations)
      throw InputError("function " + name + ": found " + some(operations) + " for the mass matrix of this scene" +
                       (has ? "" : ", which it needs") + "; allowed: at most " + counted(most_operations) +
                       " (residual and accelerations do without the matrix)");
    return name + (has ? " takes " : " needs the mass matrix, which takes ") + some(operations) +
           ": minutes to compile";
  }
  return std::nullopt;
}

}  // namespace

Reach within_reach(const scene::Scene& scene, const std::vector<std::string>& names, bool are_named) {
  Reach reach{names, {}, {}};
  const std::vector<Large> large = large_functions(scene);
  for (const auto& [part, operations] : large)
    if (!are_named && std::erase(reach.names, part) > 0)
      reach.notes.push_back(part + " is left out: it would take " + some(operations) + "; with --functions " + part +
                            " it is made");
  for (const std::string& name : reach.names) {
    const std::optional<std::string> note = note_on(scene, name, large);
    reach.is_told.push_back(note.has_value());
    if (note) reach.notes.push_back(*note);
  }
  return reach;
}

}  // namespace kanec
