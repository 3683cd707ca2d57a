// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/reference.hpp"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <string>

#include "runtime/base/files.hpp"

namespace kanec::test {
namespace {

using nlohmann::json;
using scene::Number;

scene::Vector constants(const json& a) {
  return {Number::constant(a.at(0)), Number::constant(a.at(1)), Number::constant(a.at(2))};
}

scene::Symmetric constant_inertia(const json& a) {
  return {Number::constant(a.at("xx")), Number::constant(a.at("yy")), Number::constant(a.at("zz")),
          Number::constant(a.at("xy")), Number::constant(a.at("xz")), Number::constant(a.at("yz"))};
}

scene::Vector new_inputs(scene::Scene& scene, const std::string& name) {
  scene::Vector numbers;
  for (std::size_t i = 0; i < 3; ++i) {
    numbers[i] = Number::input(static_cast<int>(scene.inputs.size()));
    scene.inputs.push_back({name + "_" + std::to_string(i + 1), 0.0});
  }
  return numbers;
}

// A joint about a coordinate axis of both bodies, or a ball, on the joint point.
scene::Joint read_joint(const std::string& kind) {
  scene::Joint joint;
  if (kind == "free") return joint;
  joint.kind = kind == "ball" ? "ball" : "revolute";
  joint.ball = kind == "ball";
  joint.slides.clear();
  if (!joint.ball)
    joint.turns = {{.axis = {kind == "x" ? 1.0 : 0.0, kind == "y" ? 1.0 : 0.0, kind == "z" ? 1.0 : 0.0}}};
  return joint;
}

// The torque of the joint of the last body: a load with inputs. Of a free joint, force and moment on the body.
void add_torque(scene::Scene& scene) {
  const int k = scene::size(scene);
  const std::string number = std::to_string(k);
  scene::Body& body = scene.bodies.back();
  if (body.joint.kind == "free") {
    body.force = new_inputs(scene, "F_" + number);
    body.moment = new_inputs(scene, "M_" + number);
    return;
  }
  scene::Load load;
  load.name = "torque_" + number;
  load.point.body = k;
  if (body.joint.ball) {
    load.kind = scene::Load::Kind::moment;
    load.axes = scene::Axes::body;
    load.vector = new_inputs(scene, "tau_" + number);
    load.reaction = scene.lower[static_cast<std::size_t>(k - 1)];
  } else {
    load.kind = scene::Load::Kind::joint;
    load.effort = Number::input(static_cast<int>(scene.inputs.size()));
    scene.inputs.push_back({"tau_" + number, 0.0});
  }
  scene.loads.push_back(load);
}

scene::Scene read_scene(const json& model) {
  scene::Scene scene;
  scene.name = "reference";
  scene.lower = model.at("lower").get<std::vector<int>>();
  scene.gravity = constants(model.at("gravity"));
  for (const json& from : model.at("bodies")) {
    scene::Body body;
    body.name = "body_" + std::to_string(scene.bodies.size() + 1);
    body.joint = read_joint(from.value("joint", "free"));
    body.mass = Number::constant(from.at("mass"));
    body.inertia = constant_inertia(from.at("inertia"));
    body.r = constants(from.at("r"));
    body.q = constants(from.at("q"));
    scene.bodies.push_back(body);
    add_torque(scene);
  }
  return scene;
}

ReferenceState read_state(const json& from) {
  return {from.at("q"),        from.at("v"),       from.at("tau"),     from.at("vdot"),     from.at("bias"),
          from.at("momentum"), from.at("origins"), from.at("kinetic"), from.at("potential")};
}

template <class Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;

template <class Real>
Vector3<Real> three(const std::vector<double>& a, int at) {
  return Eigen::Map<const Eigen::Vector3d>(a.data() + at).cast<Real>();
}

// How many entries of q, and of v, a body has, and the first of each body.
struct Place {
  int q, v;
};
Place entries(const scene::Joint& joint) {
  if (joint.kind == "free") return {7, 6};
  return joint.ball ? Place{4, 3} : Place{1, 1};
}
std::vector<Place> places(const scene::Scene& scene) {
  std::vector<Place> out = {{0, 0}};
  for (const scene::Body& body : scene.bodies) {
    const Place n = entries(body.joint);
    out.push_back({out.back().q + n.q, out.back().v + n.v});
  }
  return out;
}

template <class Real>
Vector3<Real> values(const scene::Vector& a) {
  return {Real(a[0].value), Real(a[1].value), Real(a[2].value)};
}

// A body on its way from joint to absolute coordinates.
template <class Real>
struct Placed {
  Eigen::Quaternion<Real> to_lower, to_inertial;  // from this body's components
  Vector3<Real> s, sdot, sddot;                   // lower body's axes
  Vector3<Real> omega, omegadot;                  // absolute, body axes
};

// The relative motion of a body in its joint, in the lower body's and in the body's axes.
template <class Real>
struct Relative {
  Eigen::Quaternion<Real> to_lower;
  Vector3<Real> w, wdot;  // angular, body axes
};

template <class Real>
Relative<Real> relative(const scene::Joint& joint, const ReferenceState& state, Place at) {
  if (!joint.ball) {
    const auto angle = static_cast<std::size_t>(at.q), rate = static_cast<std::size_t>(at.v);
    const auto& a = joint.turns[0].axis;
    const Vector3<Real> axis{Real(a[0]), Real(a[1]), Real(a[2])};
    return {Eigen::Quaternion<Real>(Eigen::AngleAxis<Real>(Real(state.q[angle]), axis)), Real(state.v[rate]) * axis,
            Real(state.vdot[rate]) * axis};
  }
  const int shift = joint.kind == "free" ? 3 : 0;
  const double* eps = state.q.data() + at.q + shift;
  return {Eigen::Quaternion<Real>(Real(eps[3]), Real(eps[0]), Real(eps[1]), Real(eps[2])).normalized(),
          three<Real>(state.v, at.v + shift), three<Real>(state.vdot, at.v + shift)};
}

// For one body on `lower`, whose frame is at rest when it is the inertial one.
template <class Real>
Placed<Real> place(const Placed<Real>& lower, const scene::Joint& joint, const ReferenceState& state, Place first) {
  const auto [to_lower, w, wdot] = relative<Real>(joint, state, first);
  Placed<Real> at;
  at.to_lower = to_lower;
  at.to_inertial = lower.to_inertial * to_lower;
  at.s = at.sdot = at.sddot = Vector3<Real>::Zero();
  if (joint.kind == "free") {
    const Vector3<Real> velocity = three<Real>(state.v, first.v), rate = three<Real>(state.vdot, first.v);
    at.s = three<Real>(state.q, first.q);
    at.sdot = to_lower * velocity;
    at.sddot = to_lower * Vector3<Real>(rate + w.cross(velocity));
  }
  // ω = Rᵀ ω_L + w with d(Rᵀ)/dt = -w̃ Rᵀ, R taking body to lower body's components
  const Vector3<Real> carried = to_lower.conjugate() * lower.omega;
  at.omega = carried + w;
  at.omegadot = to_lower.conjugate() * lower.omegadot + wdot - w.cross(carried);
  return at;
}

template <class Real>
std::vector<Placed<Real>> place_all(const scene::Scene& scene, const ReferenceState& state) {
  const Vector3<Real> zero = Vector3<Real>::Zero();
  const auto one = Eigen::Quaternion<Real>::Identity();
  const std::vector<Place> first = places(scene);
  std::vector<Placed<Real>> at = {{one, one, zero, zero, zero, zero, zero}};  // [0]: the inertial frame
  for (std::size_t k = 0; k < scene.bodies.size(); ++k)
    at.push_back(place<Real>(at[static_cast<std::size_t>(scene.lower[k])], scene.bodies[k].joint, state, first[k]));
  return at;
}

// A free joint's force f at the body's origin and moment n act on the body, and reversed on the lower body at the same
// point, which must be free too; both are moved to the mass centres. Of other joints the torque is a load of the scene.
template <class Real>
Eigen::Matrix<Real, Eigen::Dynamic, 1> loads(const scene::Scene& scene, const ReferenceState& state,
                                             const std::vector<Placed<Real>>& at) {
  const auto n_inputs = static_cast<Eigen::Index>(scene.inputs.size());
  Eigen::Matrix<Real, Eigen::Dynamic, 1> u = Eigen::Matrix<Real, Eigen::Dynamic, 1>::Zero(n_inputs);
  const std::vector<Place> first = places(scene);
  const auto add = [&](std::size_t k, const Vector3<Real>& F, const Vector3<Real>& M) {
    u.template segment<3>(first[k].v) += F;
    u.template segment<3>(first[k].v + 3) += M;
  };
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    if (scene.bodies[k].joint.kind != "free") {
      for (int i = first[k].v; i < first[k + 1].v; ++i) u[i] = Real(state.tau[static_cast<std::size_t>(i)]);
      continue;
    }
    const Vector3<Real> f = three<Real>(state.tau, first[k].v), n = three<Real>(state.tau, first[k].v + 3);
    const Vector3<Real> F = at[k + 1].to_inertial * f;
    add(k, F, n - values<Real>(scene.bodies[k].r).cross(f));
    if (scene.lower[k] == 0) continue;
    const auto lower = static_cast<std::size_t>(scene.lower[k] - 1);
    const Vector3<Real> r = values<Real>(scene.bodies[lower].r);
    const Vector3<Real> arm = values<Real>(scene.bodies[k].q) + at[k + 1].s - r;
    add(lower, -F, -(at[k + 1].to_lower * n + arm.cross(at[k + 1].to_lower * f)));
  }
  return u;
}

// The entries of one body's joint in x, y and ydot.
template <class Real>
void set_coordinates(Converted<Real>& out, const scene::BodyLayout& at, const Placed<Real>& placed,
                     const ReferenceState& state, Place first) {
  if (at.eps >= 0) {
    out.x.template segment<4>(at.eps) = placed.to_inertial.coeffs();
    out.y.template segment<3>(at.omega) = placed.omega;
    out.ydot.template segment<3>(at.omega) = placed.omegadot;
  } else {
    out.x[at.theta[0]] = Real(state.q[static_cast<std::size_t>(first.q)]);
    out.y[at.thetadot[0]] = Real(state.v[static_cast<std::size_t>(first.v)]);
    out.ydot[at.thetadot[0]] = Real(state.vdot[static_cast<std::size_t>(first.v)]);
  }
  if (at.s.empty()) return;
  out.x.template segment<3>(at.s[0]) = placed.s;
  out.y.template segment<3>(at.sdot[0]) = placed.sdot;
  out.ydot.template segment<3>(at.sdot[0]) = placed.sddot;
}

}  // namespace

Reference read_reference(const std::filesystem::path& path) {
  const json file = json::parse(read_file(path));
  Reference reference{read_scene(file.at("model")), {}};
  for (const json& state : file.at("states")) reference.states.push_back(read_state(state));
  return reference;
}

template <class Real>
Converted<Real> convert(const scene::Scene& scene, const ReferenceState& state) {
  const std::vector<Placed<Real>> placed_bodies = place_all<Real>(scene, state);
  Converted<Real> out;
  out.x.resize(scene::n_coordinates(scene));
  out.y.resize(scene::n_speeds(scene));
  out.ydot.resize(scene::n_speeds(scene));
  const scene::Layout layout(scene);
  const std::vector<Place> first = places(scene);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k)
    set_coordinates(out, layout.bodies[k], placed_bodies[k + 1], state, first[k]);
  out.u = loads<Real>(scene, state, placed_bodies);
  return out;
}

template Converted<double> convert(const scene::Scene&, const ReferenceState&);
template Converted<long double> convert(const scene::Scene&, const ReferenceState&);

}  // namespace kanec::test
