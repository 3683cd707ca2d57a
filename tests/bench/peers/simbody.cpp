// Simbody's way from a state to accelerations. Not: how it is timed.
// SPDX-License-Identifier: BSD-3-Clause
#include <Simbody.h>

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "tests/bench/peers/adapter.hpp"

namespace kanec::peers {
namespace {

namespace sim = SimTK;

sim::Vec3 vec(const Vector3d& from) { return {from[0], from[1], from[2]}; }

sim::Rotation rotation(const Matrix3& from) {
  return sim::Rotation(sim::Mat33(from(0, 0), from(0, 1), from(0, 2), from(1, 0), from(1, 1), from(1, 2), from(2, 0),
                                  from(2, 1), from(2, 2)),
                       true);
}

// Simbody takes inertias about the body origin.
sim::MassProperties mass_properties(const kanec_peer_body& body) {
  const double* I = body.inertia;
  const sim::Vec3 r = vec(vector(body.r));
  const sim::Inertia central(sim::Vec3(I[0], I[4], I[8]), sim::Vec3(I[1], I[2], I[5]));
  return {body.mass, r, central.shiftFromMassCenter(-r, body.mass)};
}

bool is_free(const kanec_peer_body& body) {
  return body.is_ball && body.n_slides == 3 && matrix(body.slides).isIdentity(0.0);
}

// The mobilizer of one body. A single axis is the joint frames' z of a pin, x of a slider.
sim::MobilizedBody mobilizer(sim::MobilizedBody& lower, const kanec_peer_body& body) {
  const sim::Body::Rigid rigid(mass_properties(body));
  const sim::Vec3 q = vec(vector(body.q));
  if (is_free(body)) return sim::MobilizedBody::Free(lower, sim::Transform(q), rigid, sim::Transform());
  if (body.is_ball && body.n_slides == 0)
    return sim::MobilizedBody::Ball(lower, sim::Transform(q), rigid, sim::Transform());
  if (body.is_ball || body.n_slides + body.n_turns != 1) throw std::runtime_error("a joint of several axes");
  const bool turns = body.n_turns == 1;
  const sim::UnitVec3 axis(vec(vector(turns ? body.turns : body.slides)));
  const sim::CoordinateAxis along = turns ? sim::CoordinateAxis(sim::ZAxis) : sim::CoordinateAxis(sim::XAxis);
  const sim::Rotation frame(axis, along);
  const sim::Transform on_lower(frame, q), on_body(sim::Rotation(~rotation(matrix(body.zero)) * frame), sim::Vec3(0));
  if (turns) return sim::MobilizedBody::Pin(lower, on_lower, rigid, on_body);
  return sim::MobilizedBody::Slider(lower, on_lower, rigid, on_body);
}

class Engine {
 public:
  Engine(const kanec_peer_model& model, int n_slots)
      : bodies_(bodies_of(model)),
        matter_(system_),
        gravity_(vec(vector(model.gravity))),
        states_(static_cast<std::size_t>(n_slots)) {
    for (const Body& body : bodies_) {
      sim::MobilizedBody lower = body->lower == 0 ? sim::MobilizedBody(matter_.Ground()) : mobilized_[lower_of(body)];
      mobilized_.push_back(mobilizer(lower, body.data));
    }
    at_ = system_.realizeTopology();
    system_.realizeModel(at_);
    if (at_.getNQ() != model.n_q || at_.getNU() != model.n_u)
      throw std::runtime_error("other coordinates than the scene's");
    forces_.resize(matter_.getNumBodies());
    forces_.setToZero();
  }

  void set(int slot, const double* q, const double* u, const double* force) {
    State state{sim::Vector(at_.getNQ()), sim::Vector(at_.getNU()), sim::Vector(at_.getNU())};
    for (std::size_t i = 0; i < bodies_.size(); ++i) set_body(i, q, u, force, state);
    states_[static_cast<std::size_t>(slot)] = std::move(state);
  }

  void accelerate(int slot) {
    const State& state = states_[static_cast<std::size_t>(slot)];
    at_.updQ() = state.q;
    at_.updU() = state.u;
    system_.realize(at_, sim::Stage::Dynamics);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const double m = bodies_[i]->mass;
      const sim::Vec3 weight = m * gravity_;
      const sim::Vec3 arm = mobilized_[i].getBodyRotation(at_) * mobilized_[i].getBodyMassCenterStation(at_);
      forces_[mobilized_[i].getMobilizedBodyIndex()] = sim::SpatialVec(arm % weight, weight);
    }
    matter_.calcAccelerationIgnoringConstraints(at_, state.force, forces_, u_rate_, accelerations_);
    last_ = slot;
  }

  void result(double* u_rate) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Body& body = bodies_[i];
      const int at = mobilized_[i].getFirstUIndex(at_);
      double* to = u_rate + body.u;
      if (!body->is_ball) {
        for (int j = 0; j < body.n_u; ++j) to[j] = u_rate_[at + j];
        continue;
      }
      for (int j = 0; j < body->n_slides; ++j) to[j] = u_rate_[at + 3 + j];
      const Vector3d rate(u_rate_[at], u_rate_[at + 1], u_rate_[at + 2]);
      Eigen::Map<Vector3d>{to + body->n_slides} =
          states_[static_cast<std::size_t>(last_)].attitudes[i].transpose() * rate;
    }
  }

 private:
  struct State {
    sim::Vector q, u, force;
    std::vector<Eigen::Matrix3d> attitudes = {};  // of balls: K's components to L(K)'s
  };

  static std::size_t lower_of(const Body& body) { return static_cast<std::size_t>(body->lower) - 1; }

  // A ball's quaternion is scalar first, its speeds the relative angular velocity in L(K)'s axes; both before the
  // slides.
  void set_body(std::size_t i, const double* q, const double* u, const double* force, State& state) const {
    const Body& body = bodies_[i];
    const int at_q = mobilized_[i].getFirstQIndex(at_), at_u = mobilized_[i].getFirstUIndex(at_);
    state.attitudes.push_back(Eigen::Matrix3d::Identity());
    const int slides = body->n_slides, ball_q = body->is_ball ? 4 : 0, ball_u = body->is_ball ? 3 : 0;
    for (int j = 0; j < body.n_u - ball_u; ++j) {
      state.q[at_q + ball_q + j] = q[body.q + j];
      state.u[at_u + ball_u + j] = u[body.u + j];
      state.force[at_u + ball_u + j] = force[body.u + j];
    }
    if (!body->is_ball) return;
    const Eigen::Quaterniond attitude(Eigen::Map<const Eigen::Vector4d>(q + body.q + slides));
    state.attitudes.back() = attitude.toRotationMatrix();
    const Vector3d omega = attitude * vector(u + body.u + slides), moment = attitude * vector(force + body.u + slides);
    for (int j = 0; j < 4; ++j) state.q[at_q + j] = q[body.q + slides + (j + 3) % 4];
    for (int j = 0; j < 3; ++j) {
      state.u[at_u + j] = omega[j];
      state.force[at_u + j] = moment[j];
    }
  }

  std::vector<Body> bodies_;
  sim::MultibodySystem system_;
  sim::SimbodyMatterSubsystem matter_;
  sim::Vec3 gravity_;
  std::vector<sim::MobilizedBody> mobilized_;
  sim::State at_;
  sim::Vector_<sim::SpatialVec> forces_, accelerations_;
  sim::Vector u_rate_;
  int last_ = 0;
  std::vector<State> states_;
};

}  // namespace
}  // namespace kanec::peers

extern "C" __attribute__((visibility("default"))) const kanec_peer* kanec_peer_entry(void) {
  static const kanec_peer peer = kanec::peers::peer<kanec::peers::Engine>(
      "Simbody " KANEC_SIMBODY_VERSION, "Debian builds it without NDEBUG: a release build is 2 to 3 times faster");
  return &peer;
}
