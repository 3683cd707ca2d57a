// kanec simulate --ensemble: many scenarios of a scene, in lanes and threads. Not: the scenarios' table
// (scenarios.hpp), nor a single run (simulate.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "generator/scene/scene.hpp"
#include "runtime/integrate/options.hpp"
#include "runtime/model/model.hpp"

namespace kanec {

struct EnsembleArguments {
  std::string from;  // a CSV file, "-", or "scene"; empty: no ensemble
  std::optional<int> count, seed;
  int threads = 0;
  std::int64_t keep_every = 0;
  std::string drawn;

  bool is_wanted() const { return !from.empty(); }
  // Throws InputError for options that mean something with --ensemble alone.
  void refuse_without_ensemble() const;
};

struct EnsembleJob {
  const scene::Scene& scene;  // with the settings of the command line
  integrate::Options run;
  const EnsembleArguments& ensemble;
  const BuildOptions& build;
  std::string csv;  // empty: none
  bool json = false;
};

// Runs it, tells what became of it; the exit status. Throws as simulate does; IntegrationError where every scenario
// stopped.
int simulate_ensemble(const EnsembleJob& job);

}  // namespace kanec
