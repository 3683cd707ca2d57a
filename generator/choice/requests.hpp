// The functions that are asked for, and the program that holds them and nothing else. Not: emission.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"
#include "generator/symbolic/way.hpp"

namespace kanec {

// A function that a scene's solver can have.
struct Available {
  std::string name;
  std::string meaning;
  int n_out = 0;
  program::Signature signature;
  bool usual = true;  // emitted unless functions are named
};

// All of them, in order; combinations "a+b" are not listed.
std::vector<Available> available_functions(const scene::Scene& scene);

// "kinematics+accelerations" in its parts.
std::vector<std::string> parts(const std::string& name);

// Unless it stands there already.
void insert(std::vector<std::string>& list, const std::string& name);

// What is wrong with a request.
struct Fault {
  std::string found, allowed;
};

// None where all parts of the request are available and different.
std::optional<Fault> fault_of(const std::string& request, const std::vector<Available>& available);

// The names to emit: those given, else those that the scene names, else the usual ones. Throws InputError, or
// SceneError with the place in the scene, for one that the scene does not have; each part of a combination counts.
std::vector<std::string> requested_functions(const scene::Scene& scene, const std::vector<std::string>& names);

// Derived and lowered, unsimplified; in one way (candidates.hpp finds the cheapest).
program::Program program_of(const scene::Scene& scene, const std::vector<std::string>& names,
                            const symbolic::Way& way = {});

}  // namespace kanec
