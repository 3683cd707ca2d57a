// Bullet's articulated bodies (btMultiBody) from a state to accelerations. Not: how it is timed.
// SPDX-License-Identifier: BSD-3-Clause
#include <BulletDynamics/Featherstone/btMultiBody.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "tests/bench/peers/principal.hpp"

namespace kanec::peers {
namespace {

using Eigen::Quaterniond;

btVector3 bt(const Vector3d& from) { return {from[0], from[1], from[2]}; }
btQuaternion bt(const Quaterniond& from) { return {from.x(), from.y(), from.z(), from.w()}; }
Vector3d vector(const btVector3& from) { return {from.x(), from.y(), from.z()}; }

// Bullet's bodies have their mass centre as origin and principal axes. A joint of several axes is several links, all
// but the last without mass.
struct Link {
  Body body;
  Principal about;  // its own
  int first = 0;    // of its links; the base where that moves
  int last = -1;    // what it carries hangs on this one; -1: the base
};

bool is_free(const kanec_peer_body& body) {
  return body.lower == 0 && body.is_ball && body.n_slides == 3 && matrix(body.slides).isIdentity(0.0);
}

// Whether the first body can be Bullet's base: free, and nothing else on the inertial frame.
bool base_moves(const kanec_peer_model& model) {
  const auto on_frame = [](const kanec_peer_body& body) { return body.lower == 0; };
  return is_free(model.bodies[0]) && std::count_if(model.bodies, model.bodies + model.n_bodies, on_frame) == 1;
}

int links_of(const Body& body) { return std::max(1, body->n_slides + body->n_turns + body->is_ball); }

std::unique_ptr<btMultiBody> empty_tree(const kanec_peer_model& model, bool moves) {
  int count = 0;
  for (const Body& body : bodies_of(model)) count += moves && body.k == 1 ? 0 : links_of(body);
  const btVector3 inertia = moves ? bt(principal(model.bodies[0]).moments) : btVector3(0, 0, 0);
  auto tree = std::make_unique<btMultiBody>(count, moves ? model.bodies[0].mass : 0.0, inertia, !moves, false);
  tree->setLinearDamping(0.0);
  tree->setAngularDamping(0.0);
  tree->setMaxCoordinateVelocity(1e300);
  return tree;
}

class Engine {
 public:
  Engine(const kanec_peer_model& model, int n_slots)
      : moves_(base_moves(model)), tree_(empty_tree(model, moves_)), states_(static_cast<std::size_t>(n_slots)) {
    const Vector3d g = kanec::peers::vector(model.gravity);
    int next = 0;
    for (const Body& body : bodies_of(model)) {
      Link link{body, principal(body.data), next, next + links_of(body) - 1};
      if (moves_ && body.k == 1)
        link.last = -1;
      else
        next = link.last + 1;
      if (link.last >= 0) hang(link);
      links_.push_back(link);
    }
    tree_->finalizeMultiDof();
    for (const Link& link : links_)
      if (link.last >= 0) tree_->addLinkForce(link.last, bt(link.body->mass * g));
    if (moves_) weight_ = links_[0].body->mass * g;
  }

  void set(int slot, const double* q, const double* u, const double* force) {
    State state;
    for (const Link& link : links_) {
      if (link.last < 0)
        set_base(link, q, u, force, state);
      else
        set_link(link, q + link.body.q, u + link.body.u, force + link.body.u, state);
    }
    states_[static_cast<std::size_t>(slot)] = std::move(state);
  }

  // With a step of 1 s the speeds change by the accelerations.
  void accelerate(int slot) {
    const State& state = states_[static_cast<std::size_t>(slot)];
    if (moves_) place_base(state);
    const double *q = state.q.data(), *u = state.u.data(), *force = state.force.data();
    for (int i = 0; i < tree_->getNumLinks(); ++i) {
      const btMultibodyLink& link = tree_->getLink(i);
      tree_->setJointPosMultiDof(i, q);
      tree_->setJointVelMultiDof(i, u);
      tree_->addJointTorqueMultiDof(i, force);  // sets it
      q += link.m_posVarCount;
      u += link.m_dofCount;
      force += link.m_dofCount;
    }
    tree_->computeAccelerationsArticulatedBodyAlgorithmMultiDof(1.0, reals_, vectors_, matrices_, false, false, false);
    last_ = slot;
  }

  void result(double* u_rate) const {
    const State& state = states_[static_cast<std::size_t>(last_)];
    std::size_t at = 0;
    for (const Link& link : links_) {
      double* to = u_rate + link.body.u;
      if (link.last < 0) {
        base_result(link, state, to);
        continue;
      }
      for (int i = link.first, j = 0; i <= link.last; ++i)
        for (int dof = 0; dof < tree_->getLink(i).m_dofCount; ++dof)
          to[j++] = tree_->getJointVelMultiDof(i)[dof] - state.u[at++];
      if (!link.body->is_ball) continue;
      Eigen::Map<Vector3d> rate(to + link.body->n_slides);
      rate = link.about.axes * Vector3d(rate);
    }
  }

 private:
  struct State {
    std::vector<double> q, u, force;  // link by link
    btVector3 position, velocity, omega, base_force, base_torque;
    btQuaternion attitude;  // inertial components to the base's
  };

  const Link& lower(const Link& link) const { return links_[static_cast<std::size_t>(link.body->lower) - 1]; }

  // The lower body's principal axes to its own axes, and its mass centre.
  Quaterniond axes_below(const Link& link) const {
    return link.body->lower == 0 ? Quaterniond::Identity() : lower(link).about.axes;
  }
  Vector3d centre_below(const Link& link) const {
    return link.body->lower == 0 ? Vector3d(0, 0, 0) : kanec::peers::vector(lower(link).body->r);
  }

  // One link for each axis, in order.
  void hang(const Link& link) {
    const Body& body = link.body;
    const Quaterniond below = axes_below(link);
    Vector3d offset = below.inverse() * (kanec::peers::vector(body->q) - centre_below(link));
    int parent = body->lower == 0 ? -1 : lower(link).last;
    for (int i = link.first; i <= link.last; ++i) {
      const bool is_last = i == link.last, slides = i - link.first < body->n_slides;
      const Quaterniond zero{Eigen::Matrix3d(matrix(body->zero))};
      const Quaterniond turn = is_last ? (below.inverse() * zero * link.about.axes).inverse() : Quaterniond::Identity();
      const double* axes =
          slides ? body->slides + 3 * (i - link.first) : body->turns + 3 * (i - link.first - body->n_slides);
      const btVector3 axis =
          bt(body->is_ball && !slides ? Vector3d(0, 0, 1)
                                      : Vector3d(turn * (below.inverse() * kanec::peers::vector(axes))));
      const btVector3 centre =
          is_last ? bt(link.about.axes.inverse() * kanec::peers::vector(body->r)) : btVector3(0, 0, 0);
      const btVector3 inertia = is_last ? bt(link.about.moments) : btVector3(0, 0, 0);
      const double mass = is_last ? body->mass : 0.0;
      if (slides)
        tree_->setupPrismatic(i, mass, inertia, parent, bt(turn), axis, bt(offset), centre, true);
      else if (body->is_ball)
        tree_->setupSpherical(i, mass, inertia, parent, bt(turn), bt(offset), centre, true);
      else
        tree_->setupRevolute(i, mass, inertia, parent, bt(turn), axis, bt(offset), centre, true);
      parent = i;
      offset.setZero();
    }
  }

  void set_link(const Link& link, const double* q, const double* u, const double* force, State& state) const {
    const int scalars = link.body->n_slides + link.body->n_turns;
    state.q.insert(state.q.end(), q, q + scalars);
    state.u.insert(state.u.end(), u, u + scalars);
    state.force.insert(state.force.end(), force, force + scalars);
    if (!link.body->is_ball) return;
    const Quaterniond to_principal = link.about.axes.inverse();
    const Vector3d e = to_principal * kanec::peers::vector(q + scalars);
    const Vector3d omega = to_principal * kanec::peers::vector(u + scalars);
    const Vector3d moment = to_principal * kanec::peers::vector(force + scalars);
    state.q.insert(state.q.end(), {e[0], e[1], e[2], q[scalars + 3]});
    state.u.insert(state.u.end(), omega.begin(), omega.end());
    state.force.insert(state.force.end(), moment.begin(), moment.end());
  }

  // The base's place and speed are its mass centre's, inertial axes.
  void set_base(const Link& link, const double* q, const double* u, const double* force, State& state) const {
    const Quaterniond R(Eigen::Map<const Eigen::Vector4d>(q + 3));
    const Vector3d r = kanec::peers::vector(link.body->r), f = kanec::peers::vector(force);
    const Vector3d omega = kanec::peers::vector(u + 3);
    state.position = bt(kanec::peers::vector(link.body->q) + kanec::peers::vector(q) + R * r);
    state.velocity = bt(kanec::peers::vector(u) + R * omega.cross(r));
    state.omega = bt(R * omega);
    state.attitude = bt((R * link.about.axes).inverse());
    state.base_force = bt(f + weight_);
    state.base_torque = bt(R * kanec::peers::vector(force + 3) - (R * r).cross(f));
  }

  void place_base(const State& state) {
    tree_->setBasePos(state.position);
    tree_->setWorldToBaseRot(state.attitude);
    tree_->setBaseVel(state.velocity);
    tree_->setBaseOmega(state.omega);
    tree_->addBaseForce(state.base_force - tree_->getBaseForce());
    tree_->addBaseTorque(state.base_torque - tree_->getBaseTorque());
  }

  // From the mass centre's acceleration to the origin's.
  void base_result(const Link& link, const State& state, double* to) const {
    const Quaterniond R =
        Quaterniond(state.attitude.w(), state.attitude.x(), state.attitude.y(), state.attitude.z()).inverse() *
        link.about.axes.inverse();
    const Vector3d omega = vector(state.omega), omega_rate = vector(tree_->getBaseOmega()) - omega;
    const Vector3d r = R * kanec::peers::vector(link.body->r);
    const Vector3d centre = vector(tree_->getBaseVel()) - vector(state.velocity);
    Eigen::Map<Vector3d>{to} = centre - omega_rate.cross(r) - omega.cross(omega.cross(r));
    Eigen::Map<Vector3d>{to + 3} = R.inverse() * omega_rate;
  }

  bool moves_;
  std::unique_ptr<btMultiBody> tree_;
  std::vector<Link> links_;
  Vector3d weight_ = Vector3d::Zero();  // of the base
  std::vector<State> states_;
  int last_ = 0;
  btAlignedObjectArray<btScalar> reals_;
  btAlignedObjectArray<btVector3> vectors_;
  btAlignedObjectArray<btMatrix3x3> matrices_;
};

}  // namespace
}  // namespace kanec::peers

extern "C" __attribute__((visibility("default"))) const kanec_peer* kanec_peer_entry(void) {
  static const kanec_peer peer = kanec::peers::peer<kanec::peers::Engine>("Bullet " KANEC_BULLET_VERSION, "");
  return &peer;
}
