// MuJoCo's way from a state to accelerations and along a motion, without what it does for contacts, constraints,
// actuators and sensors. Not: how it is timed.
// SPDX-License-Identifier: BSD-3-Clause
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "tests/bench/peers/principal.hpp"

namespace kanec::peers {
namespace {

std::string numbers(const double* from, int count) {
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i < count; ++i) text << (i == 0 ? "" : " ") << from[i];
  return text.str();
}

std::string joint(const char* kind, const Vector3d& axis) {
  return std::string("<joint type=\"") + kind + "\" axis=\"" + numbers(axis.data(), 3) + "\"/>\n";
}

// Joints of one body act in order, each along its axis in the body's frame as it stands then.
std::string joints(const kanec_peer_body& body) {
  const Matrix3 zero = matrix(body.zero);
  std::string text;
  for (int i = 0; i < body.n_slides; ++i) text += joint("slide", zero.transpose() * vector(body.slides + 3 * i));
  for (int i = 0; i < body.n_turns; ++i) text += joint("hinge", zero.transpose() * vector(body.turns + 3 * i));
  return body.is_ball ? text + "<joint type=\"ball\"/>\n" : text;
}

// A free joint is MuJoCo's own where it stands on the inertial frame and slides along x, y and z.
bool is_free(const kanec_peer_body& body) {
  if (body.lower != 0 || !body.is_ball || body.n_slides != 3) return false;
  return matrix(body.slides).isIdentity(0.0);
}

std::string body_text(const kanec_peer_model& model, int k) {
  const kanec_peer_body& body = model.bodies[k - 1];
  const Eigen::Quaterniond zero{Eigen::Matrix3d(matrix(body.zero))};
  const double quaternion[4] = {zero.w(), zero.x(), zero.y(), zero.z()};
  const Principal about = principal(body);
  std::string text = "<body pos=\"" + numbers(body.q, 3) + "\" quat=\"" + numbers(quaternion, 4) + "\">\n" +
                     "<inertial pos=\"" + numbers(body.r, 3) + "\" mass=\"" + numbers(&body.mass, 1) +
                     "\" diaginertia=\"" + numbers(about.moments.data(), 3) + "\"/>\n" +
                     (is_free(body) ? "<freejoint/>\n" : joints(body));
  for (int child = k + 1; child <= model.n_bodies; ++child)
    if (model.bodies[child - 1].lower == k) text += body_text(model, child);
  return text + "</body>\n";
}

std::string document(const kanec_peer_model& model) {
  std::string text = "<mujoco><compiler angle=\"radian\" inertiafromgeom=\"false\"/>\n<option gravity=\"" +
                     numbers(model.gravity, 3) +
                     "\"><flag contact=\"disable\" constraint=\"disable\" passive=\"disable\" actuation=\"disable\"/>"
                     "</option>\n<worldbody>\n";
  for (int k = 1; k <= model.n_bodies; ++k)
    if (model.bodies[k - 1].lower == 0) text += body_text(model, k);
  return text + "</worldbody></mujoco>\n";
}

// Bodies in MuJoCo's order, which is depth first.
void append_depth_first(const std::vector<Body>& bodies, int lower, std::vector<Body>& order) {
  for (const Body& body : bodies)
    if (body->lower == lower) {
      order.push_back(body);
      append_depth_first(bodies, body.k, order);
    }
}

mjModel* compiled(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(text.size()) + 1);
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), "scene.xml")], text.c_str(), text.size() + 1);
  char error[500] = "";
  mjModel* model = mj_loadXML("scene.xml", files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(error);
  return model;
}

class Engine {
 public:
  static constexpr std::array<kanec_peer_integrator, 2> integrators = {{{"RK4", 1}, {"Euler", 1}}};

  Engine(const kanec_peer_model& model, int n_slots)
      : model_(compiled(document(model)), mj_deleteModel),
        data_(mj_makeData(model_.get()), mj_deleteData),
        states_(static_cast<std::size_t>(n_slots)) {
    append_depth_first(bodies_of(model), 0, bodies_);
    if (model_->nq != model.n_q || model_->nv != model.n_u)
      throw std::runtime_error("other coordinates than the scene's");
    for (std::size_t i = 0; i < bodies_.size(); ++i) set_inertia(i);
  }

  void set(int slot, const double* q, const double* u, const double* force) {
    const auto n = static_cast<std::size_t>(model_->nv);
    State state{std::vector<double>(static_cast<std::size_t>(model_->nq)), std::vector<double>(n),
                std::vector<double>(n)};
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      set_position(i, q + bodies_[i].q, state.q.data() + first_q(i));
      std::copy_n(u + bodies_[i].u, bodies_[i].n_u, state.u.data() + first_u(i));
      std::copy_n(force + bodies_[i].u, bodies_[i].n_u, state.force.data() + first_u(i));
    }
    states_[static_cast<std::size_t>(slot)] = std::move(state);
  }

  void accelerate(int slot) {
    const State& state = states_[static_cast<std::size_t>(slot)];
    const mjModel* m = model_.get();
    mjData* d = data_.get();
    std::copy(state.q.begin(), state.q.end(), d->qpos);
    std::copy(state.u.begin(), state.u.end(), d->qvel);
    mj_kinematics(m, d);
    mj_comPos(m, d);
    mj_crb(m, d);
    mj_factorM(m, d);
    mj_comVel(m, d);
    mj_rne(m, d, 0, d->qfrc_bias);
    for (int i = 0; i < m->nv; ++i) d->qfrc_smooth[i] = state.force[static_cast<std::size_t>(i)] - d->qfrc_bias[i];
    mj_solveM(m, d, d->qacc, d->qfrc_smooth, 1);
  }

  void result(double* u_rate) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      std::copy_n(data_->qacc + first_u(i), bodies_[i].n_u, u_rate + bodies_[i].u);
  }

  void integrate(const kanec_peer_run& run, kanec_peer_motion& motion) {
    mju_user_warning = [](const char*) {};  // which would be written to a file; told by the exception below
    const bool is_rk4 = run.integrator == 0;
    model_->opt.integrator = is_rk4 ? mjINT_RK4 : mjINT_EULER;
    begin(states_[static_cast<std::size_t>(run.slot)]);
    const Stopwatch watch(run.limit);
    double t = 0.0;
    for (int32_t i = 0; i < run.n_times && motion.is_late == 0; ++i) {
      const int64_t steps = equal_steps(run.times[i] - t, run.fineness);
      model_->opt.timestep = (run.times[i] - t) / static_cast<double>(steps);
      for (int64_t step = 0; step < steps && motion.is_late == 0; ++step) {
        mj_step(model_.get(), data_.get());
        if (++motion.steps % 64 == 0 && watch.is_late()) motion.is_late = 1;
      }
      t = run.times[i];
      write(motion.q + i * model_->nq, motion.u + i * model_->nv);
    }
    motion.seconds = watch.seconds();
    motion.evaluations = (is_rk4 ? 4 : 1) * motion.steps;
    if (data_->warning[mjWARN_BADQPOS].number + data_->warning[mjWARN_BADQVEL].number +
            data_->warning[mjWARN_BADQACC].number >
        0)
      throw std::runtime_error("it began anew, as its numbers grew beyond its bounds");
  }

 private:
  struct State {
    std::vector<double> q, u, force;
  };

  // Of bodies_[i], which is MuJoCo's body i + 1.
  int first_q(std::size_t i) const { return model_->jnt_qposadr[model_->body_jntadr[i + 1]]; }
  int first_u(std::size_t i) const { return model_->body_dofadr[i + 1]; }

  // MuJoCo finds principal axes to 1e-8.
  void set_inertia(std::size_t i) {
    const Principal about = principal(bodies_[i].data);
    const double quaternion[4] = {about.axes.w(), about.axes.x(), about.axes.y(), about.axes.z()};
    std::copy_n(about.moments.data(), 3, model_->body_inertia + 3 * (i + 1));
    std::copy_n(quaternion, 4, model_->body_iquat + 4 * (i + 1));
  }

  void begin(const State& state) {
    mj_resetData(model_.get(), data_.get());
    std::copy(state.q.begin(), state.q.end(), data_->qpos);
    std::copy(state.u.begin(), state.u.end(), data_->qvel);
  }

  // The state as it stands, in relative coordinates.
  void write(double* q, double* u) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      get_position(i, data_->qpos + first_q(i), q + bodies_[i].q);
      std::copy_n(data_->qvel + first_u(i), bodies_[i].n_u, u + bodies_[i].u);
    }
  }

  void get_position(std::size_t i, const double* from, double* to) const {
    const Body& body = bodies_[i];
    std::copy_n(from, body.n_u, to);
    if (is_free(body.data))
      for (int j = 0; j < 3; ++j) to[j] -= body->q[j];
    if (!body->is_ball) return;
    const double* quaternion = from + body->n_slides;
    double* eps = to + body->n_slides;
    std::copy_n(quaternion + 1, 3, eps);
    eps[3] = quaternion[0];
  }

  void set_position(std::size_t i, const double* from, double* to) const {
    const Body& body = bodies_[i];
    std::copy_n(from, body.n_u, to);
    if (is_free(body.data))
      for (int j = 0; j < 3; ++j) to[j] += body->q[j];
    if (!body->is_ball) return;
    const double* eps = from + body->n_slides;
    double* quaternion = to + body->n_slides;
    quaternion[0] = eps[3];
    std::copy_n(eps, 3, quaternion + 1);
  }

  std::unique_ptr<mjModel, void (*)(mjModel*)> model_;
  std::unique_ptr<mjData, void (*)(mjData*)> data_;
  std::vector<Body> bodies_;
  std::vector<State> states_;
};

}  // namespace
}  // namespace kanec::peers

extern "C" __attribute__((visibility("default"))) const kanec_peer* kanec_peer_entry(void) {
  static const std::string name = std::string("MuJoCo ") + mj_versionString();
  static const kanec_peer peer = kanec::peers::peer<kanec::peers::Engine>(name.c_str(), "");
  return &peer;
}
