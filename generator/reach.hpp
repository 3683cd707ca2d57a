// Functions that grow with the square of the tree, estimated before anything is derived. Not: exact counts
// (program/ledger).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"

namespace kanec {

// Operations of the mass matrix, within a fifth for chains of more than ten links: 22.5 a pair of bodies of which one
// moves the other, times the root of the product of their numbers of speeds (measured: 19.8 for turns, 67 for balls,
// 142 for free bodies, where the rule gives 22.5, 67.5 and 135).
long mass_matrix_operations(const scene::Scene& scene);

// The functions to emit, and what the user is to know of them.
struct Reach {
  std::vector<std::string> names;
  std::vector<std::string> notes;
};

// Of the usual functions the mass matrix is left out beyond 200,000 operations, which take a compiler minutes. Named,
// it is emitted with a note; beyond 2,000,000 that is refused (InputError).
Reach within_reach(const scene::Scene& scene, const std::vector<std::string>& names, bool are_named);

// What to say of other functions that came out so large.
std::vector<std::string> notes_on_size(const program::Program& program);

}  // namespace kanec
