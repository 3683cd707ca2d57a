// From an engine's class to the C functions of peer_abi.h. Not: any engine.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <vector>

#include "runtime/cli/bench/peer_abi.h"

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
  return {KANEC_PEER_ABI_VERSION,
          sizeof(kanec_peer),
          name,
          note,
          &create<Engine>,
          [](void* engine) { delete static_cast<Engine*>(engine); },
          [](void* engine, int32_t slot, const double* q, const double* u, const double* force) {
            static_cast<Engine*>(engine)->set(slot, q, u, force);
          },
          [](void* engine, int32_t slot) { static_cast<Engine*>(engine)->accelerate(slot); },
          [](void* engine, double* u_rate) { static_cast<Engine*>(engine)->result(u_rate); }};
}

}  // namespace kanec::peers
