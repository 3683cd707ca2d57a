// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/bench/relative_model.hpp"

#include <Eigen/Core>
#include <algorithm>

#include "runtime/generic/system.hpp"

namespace kanec {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Body = generic::Body<double>;
using Motion = scene::Coordinate::Motion;

// Where a body of the scene stands on the one that carries it: itself, or what it is welded to.
struct Place {
  int carrier = 0;                    // of the relative model, from 1; 0: the inertial frame
  Vector3d p = Vector3d::Zero();      // its origin, carrier's axes
  Matrix3d A = Matrix3d::Identity();  // its components to the carrier's
};

void store(const Vector3d& from, double* to) { Eigen::Map<Vector3d>{to} = from; }
void store_matrix(const Matrix3d& from, double* to) {
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{to} = from;
}

Matrix3d symmetric(const kanec_peer_body& body) { return Eigen::Map<const Matrix3d>{body.inertia}; }

void require_modelled(const Body& body) {
  if (body.held) throw NotModelled("an attitude that is held");
  if (body.pitch != 0.0) throw NotModelled("a screw");
  for (const auto* list : {&body.turns, &body.slides})
    for (const auto& coordinate : *list) {
      if (coordinate.motion == Motion::locked) throw NotModelled("a locked coordinate");
      if (coordinate.motion == Motion::prescribed) throw NotModelled("a prescribed motion");
    }
}

bool is_weld(const Body& body) { return !body.ball && body.turns.empty() && body.slides.empty(); }

kanec_peer_body moving(const Body& body, const Place& lower) {
  kanec_peer_body to{};
  to.lower = lower.carrier;
  to.is_ball = body.ball ? 1 : 0;
  to.mass = body.m;
  store_matrix(body.I, to.inertia);
  store(body.r, to.r);
  store(lower.p + lower.A * body.q, to.q);
  for (const auto& slide : body.slides) store(lower.A * slide.axis, to.slides + 3 * to.n_slides++);
  if (!body.ball)
    for (const auto& turn : body.turns) store(lower.A * turn.axis, to.turns + 3 * to.n_turns++);
  store_matrix(body.ball ? Matrix3d::Identity() : Matrix3d(lower.A * body.zero), to.zero);
  return to;
}

// About the point from which d leads to the mass centre, less the inertia about that.
Matrix3d about(double m, const Vector3d& d) { return m * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose()); }

// Mass, mass centre and inertia of both as one.
void weld(const Body& body, const Place& at, kanec_peer_body& carrier) {
  const Vector3d r = at.p + at.A * body.r, before = Eigen::Map<Vector3d>{carrier.r};
  const double m = carrier.mass + body.m;
  const Vector3d centre = m == 0.0 ? before : Vector3d((carrier.mass * before + body.m * r) / m);
  store_matrix(symmetric(carrier) + about(carrier.mass, before - centre) + at.A * body.I * at.A.transpose() +
                   about(body.m, r - centre),
               carrier.inertia);
  store(centre, carrier.r);
  carrier.mass = m;
}

}  // namespace

kanec_peer_model RelativeModel::view() const {
  return {static_cast<int32_t>(bodies.size()), n_q, n_u, bodies.data(), {gravity[0], gravity[1], gravity[2]}};
}

RelativeModel relative_model(const scene::Scene& scene) {
  const generic::System<double> system(scene, default_parameters(scene));
  RelativeModel model;
  std::vector<Place> places = {{}};
  for (int k = 1; k <= system.n_bodies(); ++k) {
    const Body& body = system.body(k);
    const Place lower = places[static_cast<std::size_t>(body.lower)];
    require_modelled(body);
    if (is_weld(body)) {
      const Place at{lower.carrier, lower.p + lower.A * body.q, lower.A * body.zero};
      places.push_back(at);
      if (at.carrier > 0) weld(body, at, model.bodies[static_cast<std::size_t>(at.carrier) - 1]);
      continue;
    }
    model.bodies.push_back(moving(body, lower));
    model.of.push_back(k - 1);
    places.push_back({static_cast<int>(model.bodies.size()), Vector3d::Zero(), Matrix3d::Identity()});
    const kanec_peer_body& made = model.bodies.back();
    model.n_q += made.n_slides + (body.ball ? 4 : made.n_turns);
    model.n_u += made.n_slides + (body.ball ? 3 : made.n_turns);
  }
  Eigen::Map<Vector3d>{model.gravity.data()} = system.gravity();
  return model;
}

}  // namespace kanec
