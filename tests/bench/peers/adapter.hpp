// From an engine's class to the C functions of peer_abi.h. Not: any engine.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "runtime/bench/peer_abi.h"

namespace kanec::peers {

using Matrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using Eigen::Vector3d;

inline Vector3d vector(const double* from) { return Eigen::Map<const Vector3d>(from); }
inline Matrix3 matrix(const double* from) { return Eigen::Map<const Matrix3>(from); }

// One body of the model and where its entries begin in q and in u.
struct Body {
  kanec_peer_body data;
  int k = 0;  // from 1
  int q = 0, u = 0;
  int n_u = 0;

  const kanec_peer_body* operator->() const { return &data; }
};

inline std::vector<Body> bodies_of(const kanec_peer_model& model) {
  std::vector<Body> list;
  int q = 0, u = 0;
  for (int k = 1; k <= model.n_bodies; ++k) {
    const kanec_peer_body& data = model.bodies[k - 1];
    const int n_u = data.n_slides + (data.is_ball ? 3 : data.n_turns);
    list.push_back({data, k, q, u, n_u});
    q += n_u + (data.is_ball ? 1 : 0);
    u += n_u;
  }
  return list;
}

// The wall time of one run.
class Stopwatch {
 public:
  explicit Stopwatch(double limit) : limit_(limit) {}
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
  bool is_late() const { return seconds() > limit_; }

 private:
  double limit_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// In how many equal steps no longer than `longest` a stretch of time is divided.
inline int64_t equal_steps(double stretch, double longest) {
  return std::max<int64_t>(static_cast<int64_t>(std::ceil(stretch / longest - 1e-9)), 1);
}

// Engines that integrate have `static constexpr std::array<kanec_peer_integrator, …> integrators` and
// integrate(run, motion), which fills the motion.
template <class Engine, class = void>
inline constexpr bool integrates = false;
template <class Engine>
inline constexpr bool integrates<Engine, std::void_t<decltype(Engine::integrators)>> = true;

template <class Engine>
int32_t integrate(void* engine, const kanec_peer_run* run, kanec_peer_motion* motion, char* message,
                  size_t message_size) {
  try {
    static_cast<Engine*>(engine)->integrate(*run, *motion);
    return 0;
  } catch (const std::exception& error) {
    std::snprintf(message, message_size, "%s", error.what());
    return 1;
  }
}

// Engine: a constructor from the model and the number of slots that throws what cannot be modelled, and set(),
// accelerate(), result() as in kanec_peer.
template <class Engine>
void* create(const kanec_peer_model* model, int32_t n_slots, char* message, size_t message_size) {
  try {
    return new Engine(*model, n_slots);
  } catch (const std::exception& error) {
    std::snprintf(message, message_size, "%s", error.what());
    return nullptr;
  }
}

template <class Engine>
kanec_peer peer(const char* name, const char* note) {
  kanec_peer peer = {KANEC_PEER_ABI_VERSION,
                     sizeof(kanec_peer),
                     name,
                     note,
                     &create<Engine>,
                     [](void* engine) { delete static_cast<Engine*>(engine); },
                     [](void* engine, int32_t slot, const double* q, const double* u, const double* force) {
                       static_cast<Engine*>(engine)->set(slot, q, u, force);
                     },
                     [](void* engine, int32_t slot) { static_cast<Engine*>(engine)->accelerate(slot); },
                     [](void* engine, double* u_rate) { static_cast<Engine*>(engine)->result(u_rate); },
                     0,
                     nullptr,
                     nullptr};
  if constexpr (integrates<Engine>) {
    peer.n_integrators = static_cast<int32_t>(Engine::integrators.size());
    peer.integrators = Engine::integrators.data();
    peer.integrate = &integrate<Engine>;
  }
  return peer;
}

}  // namespace kanec::peers
