// Other engines, whose adapters stand beside kanec as shared libraries. Not: how an engine is used (tests/bench/peers).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "runtime/bench/relative_state.hpp"

namespace kanec {

class Peer {
 public:
  // Throws LoadError.
  explicit Peer(const std::filesystem::path& library);

  const kanec_peer& functions() const { return *peer_; }
  std::string name() const { return peer_->name; }
  std::string note() const { return peer_->note; }

 private:
  std::shared_ptr<void> handle_;
  const kanec_peer* peer_ = nullptr;
};

// Those in the folder `peers` beside the running program, by file name; those that cannot be loaded are told and left
// out.
std::vector<Peer> peers_beside_program();

// A motion as an engine integrated it.
struct PeerMotion {
  std::vector<RelativeState> states;  // at the times asked for, without forces
  double seconds = 0.0;               // wall time of the integration alone
  std::int64_t steps = 0, evaluations = 0;
  bool is_late = false;  // given up at the limit, with the states up to there
};

// A model in one engine, with some states.
class PeerSimulation {
 public:
  // Throws NotModelled.
  PeerSimulation(const Peer& peer, const RelativeModel& model, const std::vector<RelativeState>& states);

  void accelerate(std::size_t state) { functions_->accelerate(simulation_.get(), static_cast<int32_t>(state)); }
  // The rates of u in a state.
  std::vector<double> result(std::size_t state);
  // From a state at t = 0 with the integrator of that number, under gravity alone; `fineness`: the longest step [s], or
  // the accuracy. Throws IntegrationError.
  PeerMotion integrate(std::size_t state, int integrator, double fineness, std::span<const double> times, double limit);

 private:
  const kanec_peer* functions_;
  std::size_t n_q_, n_u_;
  std::unique_ptr<void, void (*)(void*)> simulation_;
};

}  // namespace kanec
