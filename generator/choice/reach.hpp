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
// moves the other, times the root of the product of their numbers of speeds, where two turns of a joint count as 3.1
// and three as 6.1 (measured: 19.8 for turns, 67 for balls, 142 for free bodies, 70 for universal joints, 137 for
// gimbals, where the rule gives 22.5, 67.5, 135, 70 and 136; half as much again to twice as much about general axes).
long mass_matrix_operations(const scene::Scene& scene);

// Operations of the partial velocities, and of their rates: so many a body and a turn, or a component of a ball whose
// body another turns with, that moves it (measured: 57 and 122 of hinges, 68 and 152 of gimbals). Of balls and free
// bodies they are blocks that bodies share.
long partial_velocity_operations(const scene::Scene& scene);
long partial_velocity_rate_operations(const scene::Scene& scene);

// The functions to emit, and what the user is to know of them before the work begins.
struct Reach {
  std::vector<std::string> names;
  std::vector<std::string> notes;
  std::vector<bool> is_told;  // of each name: a note has its size
};

// Of the usual functions those are left out that take more than 200,000 operations, which take a compiler minutes:
// mass matrix, partial velocities, their rates. Named, they are emitted with a note; a mass matrix beyond 2,000,000 is
// refused (InputError).
Reach within_reach(const scene::Scene& scene, const std::vector<std::string>& names, bool are_named);

// What to say of other functions that came out so large.
std::vector<std::string> notes_on_size(const program::Program& program, const Reach& reach);

}  // namespace kanec
