// The ways to a function's result that are timed beside each other: emitted code in its variants, the generic path,
// other engines. Not: what is shown of them (contest_text.hpp, contest_chart.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/program/ledger.hpp"
#include "runtime/bench/peers.hpp"
#include "runtime/bench/timing.hpp"
#include "runtime/model/model.hpp"

namespace kanec {

// One way of emitting and compiling. Another one is an entry more in the list that the contest is given.
struct Variant {
  std::string name;  // "emitted"
  BuildOptions build = {};
  std::optional<LaneArguments> lanes = {};  // none: one state a call
};

// One way to one function.
struct Entry {
  std::string function, name;
  std::optional<program::Ledger> cost = {};    // of emitted code
  std::optional<std::size_t> code_bytes = {};  // of emitted code, where its symbols tell
  std::optional<double> compile_seconds = {};  // of its library, which holds all functions; none from the cache
  std::optional<double> difference = {};       // from the generic path, largest of a component beside the largest
  std::string note = {};                       // why there is no time, or what has to be known beside it
  std::optional<Time> time = {};
};

// All entries of one scene; the first of each function is the variant that the others are compared with.
struct Contest {
  std::string model, hash;
  std::vector<Entry> entries;

  // What the others of this function are compared with.
  const Entry& first(const std::string& function) const;
};

struct ContestOptions {
  std::vector<std::string> functions;  // empty: those of the scene, or the usual ones
  std::vector<Variant> variants;       // at least one, the first without lanes
  std::vector<Peer> peers;
  double min_time = 0.5;  // of each entry [s]
};

// Generates, compiles, compares all with the generic path, then times everything in one run. Throws InputError where
// emitted code disagrees; a peer that disagrees is not timed.
std::vector<Contest> contests(const std::vector<scene::Scene>& scenes, const ContestOptions& options);

}  // namespace kanec
