// The stages in order: scene -> equations -> program -> passes -> emitted files. Not: any of the stages.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "generator/choice/reductions.hpp"
#include "generator/choice/requests.hpp"
#include "generator/emit/model.hpp"
#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"

namespace kanec {

struct GenerateOptions {
  std::vector<std::string> functions;  // empty: those that the scene names, else the usual ones; "a+b" combines
  std::optional<symbolic::Algorithm> algorithm = {};  // of accelerations; none: the cheapest by count
  emit::Optimize optimize = emit::Optimize::speed;
  int longest_line = emit::Model{}.longest_line;
  bool with_taylor = false;                                // Generated::taylor
  std::function<void(const std::string& note)> tell = {};  // gets notes for the user, as soon as they are known
  emit::Lengths lengths = {};
  emit::Language language = emit::Language::cpp;  // in C the header alone
};

struct Generated {
  program::Program program;
  std::string name;    // of the model
  std::string hash;    // of the emitted text: scene, generator and options
  std::string header;  // <name>.hpp; in C <name>.h, and the files below are empty
  std::string abi;     // <name>_abi.cpp
  std::string batch;   // <name>_batch.cpp
  std::string taylor;  // <name>_taylor.hpp, where asked for and the functions have all rates in one
};

// Throws InputError for a function that the scene does not have, for a scene whose A is singular where it begins, and
// for a Taylor series in C.
Generated generate(const scene::Scene& scene, const GenerateOptions& options = {});

// Held by whoever derives: GiNaC counts references without a lock, so that derivations of several threads take turns.
std::recursive_mutex& derivation_turn();

std::string version();

}  // namespace kanec
