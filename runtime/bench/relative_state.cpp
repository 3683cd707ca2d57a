// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/bench/relative_state.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "runtime/verify/paths.hpp"

namespace kanec {
// One body: attitude (its components to inertial ones), angular velocity and its rate, body axes.
struct Turning {
  Eigen::Quaterniond Q = Eigen::Quaterniond::Identity();
  Eigen::Vector3d omega = Eigen::Vector3d::Zero(), omega_rate = Eigen::Vector3d::Zero();
};

namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d vector(const double* from) { return Eigen::Map<const Vector3d>(from); }
double entry(const std::vector<double>& list, int at) { return list[static_cast<std::size_t>(at)]; }
const double* entries_at(const std::vector<double>& list, int at) { return list.data() + at; }

// What stands on `turning`, turned by theta about the axis a of both.
Turning turned(const Turning& turning, const Vector3d& a, double theta, double rate, double second_rate) {
  const Quaterniond step(Eigen::AngleAxisd(theta, a));
  const Vector3d omega = step.inverse() * turning.omega, along = a * rate;
  return {turning.Q * step, omega + along, step.inverse() * turning.omega_rate + omega.cross(along) + a * second_rate};
}

Turning turned(const Turning& turning, const Matrix3d& zero) {
  return {turning.Q * Quaterniond(zero), zero.transpose() * turning.omega, zero.transpose() * turning.omega_rate};
}

// What a ball turns on `lower`: its relative attitude and angular velocity made absolute.
Turning carried(const Turning& lower, const double* eps, const double* omega) {
  const Quaterniond relative(Eigen::Map<const Eigen::Vector4d>{eps});
  return {lower.Q * relative, vector(omega) + relative.inverse() * lower.omega, Vector3d::Zero()};
}

scene::Scene without_loads(scene::Scene scene) {
  scene.loads.clear();
  for (scene::Body& body : scene.bodies) body.force = body.moment = {};
  return scene;
}

}  // namespace

// q, u and the rates of u, filled body by body.
struct RelativeStates::Motion {
  std::vector<double> q, u, u_rate;
  std::vector<Turning> bodies = {{}};

  void slide(double value, double rate, double second_rate) {
    q.push_back(value);
    u.push_back(rate);
    u_rate.push_back(second_rate);
  }

  // A ball's own attitude and angular velocity, both absolute, to what is relative to `lower`.
  void ball(const Turning& own, const Turning& lower) {
    const Quaterniond relative = lower.Q.inverse() * own.Q;  // K's components to L(K)'s
    const Vector3d carried = relative.inverse() * lower.omega, omega = own.omega - carried;
    const Vector3d rate = own.omega_rate - relative.inverse() * lower.omega_rate + omega.cross(carried);
    q.insert(q.end(), {relative.x(), relative.y(), relative.z(), relative.w()});
    u.insert(u.end(), omega.begin(), omega.end());
    u_rate.insert(u_rate.end(), rate.begin(), rate.end());
    bodies.push_back(own);
  }
};

RelativeStates::RelativeStates(const scene::Scene& scene, const RelativeModel& model)
    : scene_(scene), unloaded_(without_loads(scene)), model_(model), layout_(scene) {}

RelativeStates::Motion RelativeStates::motion(const State& state) const {
  Motion motion;
  for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
    const kanec_peer_body& body = model_.bodies[i];
    const scene::BodyLayout& at = layout_.bodies[static_cast<std::size_t>(model_.of[i])];
    const Turning lower = motion.bodies[static_cast<std::size_t>(body.lower)];
    for (std::size_t j = 0; j < at.s.size(); ++j)
      motion.slide(entry(state.x, at.s[j]), entry(state.y, at.sdot[j]), entry(state.ydot, at.sdot[j]));
    if (body.is_ball) {
      motion.ball({Quaterniond(Eigen::Map<const Eigen::Vector4d>(entries_at(state.x, at.eps))),
                   vector(entries_at(state.y, at.omega)), vector(entries_at(state.ydot, at.omega))},
                  lower);
      continue;
    }
    Turning turning = lower;
    for (std::size_t j = 0; j < at.theta.size(); ++j) {
      const double rate = entry(state.y, at.thetadot[j]), second_rate = entry(state.ydot, at.thetadot[j]);
      motion.slide(entry(state.x, at.theta[j]), rate, second_rate);
      turning = turned(turning, vector(body.turns + 3 * j), motion.q.back(), rate, second_rate);
    }
    motion.bodies.push_back(turned(turning, Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(body.zero)));
  }
  return motion;
}

// u = T y, so that a force Q on y is one of T^-T Q on u.
RelativeState RelativeStates::of(const State& state) const {
  const std::vector<double> with = generic_path<double>(scene_, {"forcing"}, state);
  const std::vector<double> without = generic_path<double>(unloaded_, {"forcing"}, state);
  const Eigen::Index n = model_.n_u;
  Eigen::VectorXd Q(n);
  Eigen::MatrixXd T(n, n);
  State unit = state;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    Q[i] = with[at] - without[at];
    unit.y.assign(static_cast<std::size_t>(n), 0.0);
    unit.y[at] = 1.0;
    T.col(i) = Eigen::Map<const Eigen::VectorXd>(motion(unit).u.data(), n);
  }
  const Motion found = motion(state);
  const Eigen::VectorXd force = T.transpose().partialPivLu().solve(Q);
  return {found.q, found.u, {force.begin(), force.end()}};
}

State RelativeStates::scene_state(const RelativeState& relative, const State& like) const {
  State state = like;
  std::vector<Turning> bodies = {{}};
  std::size_t q = 0, u = 0;
  const auto copy = [&](int x, int y) {
    state.x[static_cast<std::size_t>(x)] = relative.q[q++];
    state.y[static_cast<std::size_t>(y)] = relative.u[u++];
  };
  for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
    const kanec_peer_body& body = model_.bodies[i];
    const scene::BodyLayout& at = layout_.bodies[static_cast<std::size_t>(model_.of[i])];
    Turning turning = bodies[static_cast<std::size_t>(body.lower)];
    for (std::size_t j = 0; j < at.s.size(); ++j) copy(at.s[j], at.sdot[j]);
    if (body.is_ball) {
      turning = carried(turning, &relative.q[q], &relative.u[u]);
      Eigen::Map<Eigen::Vector4d>(&state.x[static_cast<std::size_t>(at.eps)]) = turning.Q.coeffs();
      Eigen::Map<Vector3d>(&state.y[static_cast<std::size_t>(at.omega)]) = turning.omega;
      q += 4, u += 3;
    } else {
      for (std::size_t j = 0; j < at.theta.size(); ++j) {
        copy(at.theta[j], at.thetadot[j]);
        turning = turned(turning, vector(body.turns + 3 * j), relative.q[q - 1], relative.u[u - 1], 0.0);
      }
      turning = turned(turning, Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(body.zero));
    }
    bodies.push_back(turning);
  }
  return state;
}

std::vector<double> RelativeStates::rates(const State& state) const { return motion(state).u_rate; }

}  // namespace kanec
