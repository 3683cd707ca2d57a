// One scene's entries with what they need to run. Not: their order in time (contest.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <deque>

#include "runtime/abi/solver.hpp"
#include "runtime/bench/batch_run.hpp"
#include "runtime/bench/contest.hpp"
#include "runtime/generic/system.hpp"

namespace kanec {

class Entrants {
 public:
  // Builds every variant and compares it. Throws InputError where it disagrees with the generic path.
  Entrants(const scene::Scene& scene, const ContestOptions& options);
  Entrants(const Entrants&) = delete;
  Entrants& operator=(const Entrants&) = delete;

  Contest contest;
  std::vector<Loop> loops;           // of the entries that are timed; valid as long as this object
  std::vector<std::size_t> loop_of;  // the entry of each

 private:
  struct Built {
    std::string name;
    CompiledModel model;
    std::unique_ptr<Solver> solver = {};   // unless in lanes
    std::unique_ptr<BatchRun> batch = {};  // in lanes
    std::vector<double> difference = {};   // one a function
  };

  void build(const Variant& variant);
  void add_function(const program::Function& function, const ContestOptions& options);
  void add_emitted(const Built& built, const std::string& function);
  Loop single(const Solver& solver, const std::string& function) const;
  double lanes_difference(BatchRun& batch, const std::string& function) const;
  void add_generic(const std::string& function);
  void add_peer(const Peer& peer);
  void prepare_peers();  // throws NotModelled
  double largest_difference(PeerSimulation& simulation) const;
  void add(Entry entry, Loop loop);

  scene::Scene scene_;
  std::vector<std::string> functions_;
  std::vector<State> pool_;
  generic::System<double> generic_;
  std::deque<Built> built_;                // stays where it is, as loops refer to it
  std::optional<RelativeModel> relative_;  // for peers, where they can have it
  std::vector<RelativeState> relative_pool_;
  std::deque<PeerSimulation> simulations_;
  std::vector<std::vector<double>> expected_;  // rates of u in the first states, by the generic path
};

}  // namespace kanec
