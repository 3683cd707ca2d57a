// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/ways.hpp"

#include "generator/choice/candidates.hpp"
#include "generator/choice/comparison.hpp"
#include "generator/choice/requests.hpp"
#include "generator/program/passes.hpp"

namespace kanec {
namespace {

using symbolic::Algorithm;
using symbolic::Axes;
using symbolic::Way;

// The work grows with the cube of what is coupled: beyond this it is no way at all.
bool may_be_composite(const symbolic::Mechanism& mechanism) { return mechanism.size() <= 16; }

Way with_other_algorithm(Way way) {
  way.algorithm = way.algorithm == Algorithm::composite ? Algorithm::articulated : Algorithm::composite;
  return way;
}

Way with_other_axes(Way way) {
  way.axes = way.axes == Axes::body ? Axes::inertial : Axes::body;
  return way;
}

Way with_origins(Way way, bool placed) {
  way.reductions.place_origins = placed;
  return way;
}

Way with_axes(Way way, bool turned) {
  way.reductions.turn_axes = turned;
  return way;
}

Way with_masses(Way way, bool regrouped, int group) {
  way.reductions.regroup = regrouped;
  way.reductions.group = group;
  return way;
}

}  // namespace

std::vector<NamedWay> ways_beside(const scene::Scene& scene, const std::string& function, const Way& kept) {
  constexpr int any_number = symbolic::Reductions::any_number;
  const symbolic::Mechanism mechanism = symbolic::mechanism(scene, kept.reductions);
  std::vector<NamedWay> list = {{"kept", kept}};
  const auto add = [&](const std::string& name, const Way& way) {
    if (!(way == kept)) list.push_back({name, way});
  };
  const bool is_solved = function == "accelerations";
  const bool depends = is_solved || function == "residual" || function == "forcing" || function == "mass_matrix";
  if (is_solved && may_be_composite(mechanism))
    add(kept.algorithm == Algorithm::composite ? "joint by joint" : "A and L D L^T", with_other_algorithm(kept));
  if (depends) {
    if (mechanism.has_balls()) add(kept.axes == Axes::body ? "inertial axes" : "own axes", with_other_axes(kept));
    add(kept.reductions.place_origins ? "origins as typed" : "origins moved",
        with_origins(kept, !kept.reductions.place_origins));
    add(kept.reductions.turn_axes ? "axes as typed" : "axes turned", with_axes(kept, !kept.reductions.turn_axes));
    add("masses not regrouped", with_masses(kept, false, any_number));
    if (is_solved) add("masses of " + std::to_string(few_links) + " together", with_masses(kept, true, few_links));
    add("all masses together", with_masses(kept, true, any_number));
  }
  list.push_back({"no passes", kept, false});
  return list;
}

std::string description(const Way& way, const std::string& function) {
  std::string text;
  const auto append = [&text](const std::string& item) { text += (text.empty() ? "" : ", ") + item; };
  if (function == "accelerations") append(way.algorithm == Algorithm::composite ? "A and L D L^T" : "joint by joint");
  if (way.axes == Axes::body) append("own axes");
  if (!way.reductions.place_origins) append("origins as typed");
  if (!way.reductions.turn_axes) append("axes as typed");
  if (!way.reductions.regroup)
    append("masses not regrouped");
  else if (way.reductions.group != symbolic::Reductions::any_number)
    append("masses of " + std::to_string(way.reductions.group) + " together");
  return text;
}

program::Program program_in(const scene::Scene& scene, const std::string& function, const NamedWay& way) {
  program::Program program = program_of(scene, {function}, way.way);
  return way.passes ? program::optimized(std::move(program)) : program::drop_dead(std::move(program));
}

}  // namespace kanec
