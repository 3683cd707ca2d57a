// Simbody's way from a state to accelerations and along a motion. Not: how accelerations are timed.
// SPDX-License-Identifier: BSD-3-Clause
#include <Simbody.h>

#include <Eigen/Geometry>
#include <array>
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

// The tree of a model; at y = 0 and its joints' zero.
struct Tree {
  explicit Tree(const std::vector<Body>& bodies) : matter(system) {
    for (const Body& body : bodies) {
      sim::MobilizedBody lower =
          body->lower == 0 ? sim::MobilizedBody(matter.Ground()) : mobilized[static_cast<std::size_t>(body->lower) - 1];
      mobilized.push_back(mobilizer(lower, body.data));
    }
  }

  sim::State initial_state() {
    sim::State at = system.realizeTopology();
    system.realizeModel(at);
    return at;
  }

  sim::MultibodySystem system;
  sim::SimbodyMatterSubsystem matter;
  std::vector<sim::MobilizedBody> mobilized;
};

// The same under gravity, to be integrated; what is timed by accelerate() has no force subsystem.
struct HeavyTree : Tree {
  HeavyTree(const std::vector<Body>& bodies, const sim::Vec3& gravity) : Tree(bodies), forces(system) {
    sim::Force::UniformGravity(forces, matter, gravity);
  }

  sim::GeneralForceSubsystem forces;
};

class Engine {
 public:
  // CPodes is none of them: in Debian's build, which is without NDEBUG, an assertion of its own ends the program.
  static constexpr std::array<kanec_peer_integrator, 2> integrators = {
      {{"RungeKuttaMerson", 0}, {"RungeKuttaFeldberg", 0}}};

  Engine(const kanec_peer_model& model, int n_slots)
      : bodies_(bodies_of(model)),
        gravity_(vec(vector(model.gravity))),
        tree_(bodies_),
        at_(tree_.initial_state()),
        states_(static_cast<std::size_t>(n_slots)) {
    if (at_.getNQ() != model.n_q || at_.getNU() != model.n_u)
      throw std::runtime_error("other coordinates than the scene's");
    forces_.resize(tree_.matter.getNumBodies());
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
    tree_.system.realize(at_, sim::Stage::Dynamics);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const double m = bodies_[i]->mass;
      const sim::Vec3 weight = m * gravity_;
      const sim::Vec3 arm = tree_.mobilized[i].getBodyRotation(at_) * tree_.mobilized[i].getBodyMassCenterStation(at_);
      forces_[tree_.mobilized[i].getMobilizedBodyIndex()] = sim::SpatialVec(arm % weight, weight);
    }
    tree_.matter.calcAccelerationIgnoringConstraints(at_, state.force, forces_, u_rate_, accelerations_);
    last_ = slot;
  }

  void result(double* u_rate) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Body& body = bodies_[i];
      const int at = tree_.mobilized[i].getFirstUIndex(at_);
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

  void integrate(const kanec_peer_run& run, kanec_peer_motion& motion) {
    HeavyTree tree(bodies_, gravity_);
    sim::State at = tree.initial_state();
    const State& from = states_[static_cast<std::size_t>(run.slot)];
    at.updQ() = from.q;
    at.updU() = from.u;
    at.setTime(0.0);
    const std::unique_ptr<sim::Integrator> integrator = made(run.integrator, tree.system);
    integrator->setAccuracy(run.fineness);
    integrator->setAllowInterpolation(false);
    integrator->setReturnEveryInternalStep(true);
    integrator->setFinalTime(run.times[run.n_times - 1]);
    const int before = tree.system.getNumRealizationsOfThisStage(sim::Stage::Acceleration);
    const Stopwatch watch(run.limit);
    integrator->initialize(at);
    for (int32_t i = 0; i < run.n_times && motion.is_late == 0; ++i) {
      while (integrator->getTime() < run.times[i] && motion.is_late == 0) {
        integrator->stepTo(run.times[i]);
        motion.is_late = watch.is_late();
      }
      write(integrator->getState(), motion.q + i * at.getNQ(), motion.u + i * at.getNU());
    }
    motion.seconds = watch.seconds();
    motion.steps = integrator->getNumStepsTaken();
    motion.evaluations = tree.system.getNumRealizationsOfThisStage(sim::Stage::Acceleration) - before;
  }

 private:
  static std::unique_ptr<sim::Integrator> made(int32_t integrator, const sim::System& system) {
    if (integrator == 0) return std::make_unique<sim::RungeKuttaMersonIntegrator>(system);
    return std::make_unique<sim::RungeKuttaFeldbergIntegrator>(system);
  }

  // In relative coordinates, whose ball's speeds are in K's axes.
  void write(const sim::State& at, double* q, double* u) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Body& body = bodies_[i];
      const int at_q = tree_.mobilized[i].getFirstQIndex(at_), at_u = tree_.mobilized[i].getFirstUIndex(at_);
      const int slides = body->n_slides, ball_q = body->is_ball ? 4 : 0, ball_u = body->is_ball ? 3 : 0;
      for (int j = 0; j < body.n_u - ball_u; ++j) {
        q[body.q + j] = at.getQ()[at_q + ball_q + j];
        u[body.u + j] = at.getU()[at_u + ball_u + j];
      }
      if (!body->is_ball) continue;
      double* eps = q + body.q + slides;
      for (int j = 0; j < 4; ++j) eps[(j + 3) % 4] = at.getQ()[at_q + j];
      const Eigen::Quaterniond attitude{Eigen::Map<const Eigen::Vector4d>(eps)};
      const Vector3d omega(at.getU()[at_u], at.getU()[at_u + 1], at.getU()[at_u + 2]);
      Eigen::Map<Vector3d>{u + body.u + slides} = attitude.conjugate() * omega;
    }
  }

  struct State {
    sim::Vector q, u, force;
    std::vector<Eigen::Matrix3d> attitudes = {};  // of balls: K's components to L(K)'s
  };

  // A ball's quaternion is scalar first, its speeds the relative angular velocity in L(K)'s axes; both before the
  // slides.
  void set_body(std::size_t i, const double* q, const double* u, const double* force, State& state) const {
    const Body& body = bodies_[i];
    const int at_q = tree_.mobilized[i].getFirstQIndex(at_), at_u = tree_.mobilized[i].getFirstUIndex(at_);
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
  sim::Vec3 gravity_;
  Tree tree_;
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
