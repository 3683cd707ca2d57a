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

scene::Scene read_scene(const json& model) {
  scene::Scene scene;
  scene.name = "reference";
  scene.lower = model.at("lower").get<std::vector<int>>();
  scene.gravity = constants(model.at("gravity"));
  for (const json& from : model.at("bodies")) {
    const std::string number = std::to_string(scene.bodies.size() + 1);
    scene::Body body;
    body.name = "body_" + number;
    body.mass = Number::constant(from.at("mass"));
    body.inertia = constant_inertia(from.at("inertia"));
    body.r = constants(from.at("r"));
    body.q = constants(from.at("q"));
    body.force = new_inputs(scene, "F_" + number);
    body.moment = new_inputs(scene, "M_" + number);
    scene.bodies.push_back(body);
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

// For one body on `lower`, whose frame is at rest when it is the inertial one.
template <class Real>
Placed<Real> place(const Placed<Real>& lower, const ReferenceState& state, int body) {
  const double* eps = state.q.data() + 7 * body + 3;
  const Vector3<Real> velocity = three<Real>(state.v, 6 * body), w = three<Real>(state.v, 6 * body + 3);
  const Vector3<Real> rate = three<Real>(state.vdot, 6 * body), wdot = three<Real>(state.vdot, 6 * body + 3);
  Placed<Real> at;
  at.to_lower = Eigen::Quaternion<Real>(Real(eps[3]), Real(eps[0]), Real(eps[1]), Real(eps[2])).normalized();
  at.to_inertial = lower.to_inertial * at.to_lower;
  at.s = three<Real>(state.q, 7 * body);
  at.sdot = at.to_lower * velocity;
  at.sddot = at.to_lower * Vector3<Real>(rate + w.cross(velocity));
  // ω = Rᵀ ω_L + w with d(Rᵀ)/dt = -w̃ Rᵀ, R taking body to lower body's components
  const Vector3<Real> carried = at.to_lower.conjugate() * lower.omega;
  at.omega = carried + w;
  at.omegadot = at.to_lower.conjugate() * lower.omegadot + wdot - w.cross(carried);
  return at;
}

template <class Real>
std::vector<Placed<Real>> place_all(const scene::Scene& scene, const ReferenceState& state) {
  const Vector3<Real> zero = Vector3<Real>::Zero();
  const auto one = Eigen::Quaternion<Real>::Identity();
  std::vector<Placed<Real>> at = {{one, one, zero, zero, zero, zero, zero}};  // [0]: the inertial frame
  for (int body = 0; body < scene::size(scene); ++body) {
    const auto lower = static_cast<std::size_t>(scene.lower[static_cast<std::size_t>(body)]);
    at.push_back(place<Real>(at[lower], state, body));
  }
  return at;
}

// A joint's force f at the body's origin and moment n act on the body, and reversed on the lower body at the same
// point; both are moved to the mass centres.
template <class Real>
Eigen::Matrix<Real, Eigen::Dynamic, 1> loads(const scene::Scene& scene, const ReferenceState& state,
                                             const std::vector<Placed<Real>>& at) {
  Eigen::Matrix<Real, Eigen::Dynamic, 1> u = Eigen::Matrix<Real, Eigen::Dynamic, 1>::Zero(scene::n_speeds(scene));
  const auto add = [&](int body, const Vector3<Real>& F, const Vector3<Real>& M) {
    u.template segment<3>(6 * body) += F;
    u.template segment<3>(6 * body + 3) += M;
  };
  for (int body = 0; body < scene::size(scene); ++body) {
    const auto k = static_cast<std::size_t>(body);
    const Vector3<Real> f = three<Real>(state.tau, 6 * body), n = three<Real>(state.tau, 6 * body + 3);
    const Vector3<Real> F = at[k + 1].to_inertial * f;
    add(body, F, n - values<Real>(scene.bodies[k].r).cross(f));
    if (scene.lower[k] == 0) continue;
    const int lower = scene.lower[k] - 1;
    const Vector3<Real> r = values<Real>(scene.bodies[static_cast<std::size_t>(lower)].r);
    const Vector3<Real> arm = values<Real>(scene.bodies[k].q) + at[k + 1].s - r;
    add(lower, -F, -(at[k + 1].to_lower * n + arm.cross(at[k + 1].to_lower * f)));
  }
  return u;
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
  for (int body = 0; body < scene::size(scene); ++body) {
    const scene::BodyLayout& at = layout.bodies[static_cast<std::size_t>(body)];
    const Placed<Real>& placed = placed_bodies[static_cast<std::size_t>(body) + 1];
    out.x.template segment<4>(at.eps) = placed.to_inertial.coeffs();
    out.x.template segment<3>(at.s[0]) = placed.s;
    out.y.template segment<3>(at.omega) = placed.omega;
    out.y.template segment<3>(at.sdot[0]) = placed.sdot;
    out.ydot.template segment<3>(at.omega) = placed.omegadot;
    out.ydot.template segment<3>(at.sdot[0]) = placed.sddot;
  }
  out.u = loads<Real>(scene, state, placed_bodies);
  return out;
}

template Converted<double> convert(const scene::Scene&, const ReferenceState&);
template Converted<long double> convert(const scene::Scene&, const ReferenceState&);

}  // namespace kanec::test
