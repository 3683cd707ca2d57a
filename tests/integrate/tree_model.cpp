// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integrate/tree_model.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/integrate/body_series.hpp"
#include "tests/integrate/output_fixture.hpp"

namespace kanec::integrate::test {
namespace {

using Vec = std::array<double, 3>;
Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec operator*(double c, const Vec& a) { return {c * a[0], c * a[1], c * a[2]}; }
double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec vec(const double* p) { return {p[0], p[1], p[2]}; }
void put(const Vec& a, double* p) { std::memcpy(p, a.data(), sizeof a); }

// Rᵀ a: body to inertial, a + 2 e × (ε4 a + e × a); R a the other way
Vec to_inertial(const double* eps, const Vec& a) {
  const Vec e = vec(eps);
  return a + 2.0 * cross(e, eps[3] * a + cross(e, a));
}
Vec to_body(const double* eps, const Vec& a) {
  const Vec e = vec(eps);
  return a - 2.0 * cross(e, eps[3] * a - cross(e, a));
}

struct BodyData {
  int lower;  // body number, 0 = inertial frame
  double m;
  Vec I, q;
};
struct OneBody {
  static constexpr int n = 1;
  static constexpr std::array<BodyData, 1> bodies = {{{0, body_m, body_inertia, {0, 0, 0}}}};
};
struct SixBodies {
  static constexpr int n = 6;
  static constexpr std::array<BodyData, 6> bodies = {{{0, 4.0, {1.0, 1.6, 2.1}, {0, 0, 0}},
                                                      {1, 2.0, {0.7, 0.9, 1.1}, {0.6, 0.1, -0.3}},
                                                      {2, 1.5, {0.3, 0.5, 0.6}, {-0.2, 0.7, 0.1}},
                                                      {2, 1.0, {0.4, 0.35, 0.2}, {0.3, -0.4, 0.5}},
                                                      {1, 2.5, {0.8, 0.6, 1.0}, {-0.5, -0.2, 0.4}},
                                                      {5, 0.8, {0.2, 0.25, 0.3}, {0.1, 0.3, 0.6}}}};
};

// Positions and velocities, inertial axes, of all origins from x and y.
template <class Tree>
struct Motion {
  std::array<Vec, Tree::n> P, V;
  Motion(const double* x, const double* y) {
    for (int k = 0; k < Tree::n; ++k) {
      const BodyData& b = Tree::bodies[static_cast<std::size_t>(k)];
      const Vec c = b.q + vec(s(x, k));
      const auto i = static_cast<std::size_t>(k);
      if (b.lower == 0) {
        P[i] = c;
        V[i] = vec(sdot(y, k));
        continue;
      }
      const auto j = static_cast<std::size_t>(b.lower - 1);
      const double* eps = x + 4 * j;
      P[i] = P[j] + to_inertial(eps, c);
      V[i] = V[j] + to_inertial(eps, cross(vec(y + 3 * j), c) + vec(sdot(y, k)));
    }
  }
  static const double* s(const double* x, int k) { return x + 4 * Tree::n + 3 * k; }
  static const double* sdot(const double* y, int k) { return y + 3 * Tree::n + 3 * k; }
};

Vec principal(const Vec& I, const Vec& omega) { return {I[0] * omega[0], I[1] * omega[1], I[2] * omega[2]}; }

template <class Tree>
void kinematics(const void*, double, const double* x, const double* y, const double*, const double*, double* out) {
  for (int k = 0; k < Tree::n; ++k) {
    const double* eps = x + 4 * k;
    const Vec omega = vec(y + 3 * k);
    put(0.5 * (eps[3] * omega + cross(vec(eps), omega)), out + 4 * k);
    out[4 * k + 3] = -0.5 * dot(vec(eps), omega);
  }
  std::memcpy(out + 4 * Tree::n, y + 3 * Tree::n, sizeof(double) * 3 * Tree::n);
}

// ω̇ = I⁻¹ (M - ω × I ω), a = F / m + g; s̈ from a_K = a_L + R_Lᵀ (ω̇ × c + ω × (ω × c) + 2 ω × ṡ + s̈)
template <class Tree>
void accelerations(const void* prepared, double, const double* x, const double* y, const double*, const double* u,
                   double* out) {
  const Vec g = vec(static_cast<const double*>(prepared));
  std::array<Vec, Tree::n> a;
  for (int k = 0; k < Tree::n; ++k) {
    const BodyData& b = Tree::bodies[static_cast<std::size_t>(k)];
    const Vec omega = vec(y + 3 * k);
    const Vec moment = vec(u + 6 * k + 3) - cross(omega, principal(b.I, omega));
    put({moment[0] / b.I[0], moment[1] / b.I[1], moment[2] / b.I[2]}, out + 3 * k);
    a[static_cast<std::size_t>(k)] = g + (1.0 / b.m) * vec(u + 6 * k);
    Vec s2 = a[static_cast<std::size_t>(k)];
    if (b.lower > 0) {
      const auto j = static_cast<std::size_t>(b.lower - 1);
      const Vec w = vec(y + 3 * j), wdot = vec(out + 3 * j), c = b.q + vec(Motion<Tree>::s(x, k));
      s2 = to_body(x + 4 * j, s2 - a[j]) - cross(wdot, c) - cross(w, cross(w, c)) -
           2.0 * cross(w, vec(Motion<Tree>::sdot(y, k)));
    }
    put(s2, out + 3 * Tree::n + 3 * k);
  }
}

template <class Tree, Fault fault>
void faulty_accelerations(const void* prepared, double t, const double* x, const double* y, const double* ydot,
                          const double* u, double* out) {
  accelerations<Tree>(prepared, t, x, y, ydot, u, out);
  const double* sdot = y + 3 * Tree::n;
  double* s2 = out + 3 * Tree::n;
  if (fault == Fault::not_finite && t >= 0.5) out[Tree::n > 1 ? 7 : 1] = std::numeric_limits<double>::quiet_NaN();
  if (fault == Fault::blow_up) s2[0] = sdot[0] * sdot[0];
  if (fault == Fault::stiff)
    for (int i = 0; i < 3; ++i) s2[i] -= 1e5 * sdot[i];
}

template <class Tree>
void power(const void*, double, const double* x, const double* y, const double*, const double* u, double* out) {
  const Motion<Tree> motion(x, y);
  *out = 0.0;
  for (std::size_t k = 0; k < Tree::n; ++k)
    *out += dot(vec(u + 6 * k), motion.V[k]) + dot(vec(u + 6 * k + 3), vec(y + 3 * k));
}

// ẋ as kinematics, A ẏ − f with A = 1, power
template <class Tree, Fault fault>
void residual(const void* prepared, double t, const double* x, const double* y, const double* ydot, const double* u,
              double* out) {
  kinematics<Tree>(prepared, t, x, y, ydot, u, out);
  double* r = out + 7 * Tree::n;
  faulty_accelerations<Tree, fault>(prepared, t, x, y, ydot, u, r);
  for (int i = 0; i < 6 * Tree::n; ++i) r[i] = ydot[i] - r[i];
  power<Tree>(prepared, t, x, y, ydot, u, out + 13 * Tree::n);
}

template <class Tree>
void energy(const void* prepared, double, const double* x, const double* y, const double*, const double*, double* out) {
  const Motion<Tree> motion(x, y);
  const Vec g = vec(static_cast<const double*>(prepared));
  out[0] = out[1] = 0.0;
  for (std::size_t k = 0; k < Tree::n; ++k) {
    const BodyData& b = Tree::bodies[k];
    const Vec omega = vec(y + 3 * k);
    out[0] += 0.5 * (b.m * dot(motion.V[k], motion.V[k]) + dot(omega, principal(b.I, omega)));
    out[1] -= b.m * dot(g, motion.P[k]);
  }
}

template <class Tree>
void momentum(const void*, double, const double* x, const double* y, const double*, const double*, double* out) {
  const Motion<Tree> motion(x, y);
  Vec linear{}, angular{};
  for (std::size_t k = 0; k < Tree::n; ++k) {
    const BodyData& b = Tree::bodies[k];
    linear = linear + b.m * motion.V[k];
    angular = angular + b.m * cross(motion.P[k], motion.V[k]) + to_inertial(x + 4 * k, principal(b.I, vec(y + 3 * k)));
  }
  put(linear, out);
  put(angular, out + 3);
}

void prepare(const double* parameters, void* prepared) { std::memcpy(prepared, parameters, 3 * sizeof(double)); }

kanec_function function(const char* name, int n_out, kanec_evaluate evaluate) {
  kanec_function result{};
  result.name = name;
  result.n_out = n_out;
  result.evaluate = evaluate;
  return result;
}

const StateNames& names(int n_bodies) {
  static const StateNames one = free_names(1), six = free_names(6);
  return n_bodies == 1 ? one : six;
}

template <std::size_t n>
std::array<const char*, n> pointers(const std::vector<std::string>& names) {
  std::array<const char*, n> result{};
  for (std::size_t i = 0; i < n; ++i) result[i] = names[i].c_str();
  return result;
}

constexpr int all_functions = 6;

// The descriptor with the arrays that it points to.
template <class Tree, Fault fault>
struct Descriptor {
  std::array<const char*, 3> parameter_names = {"g_1", "g_2", "g_3"};
  std::array<double, 3> no_gravity{};
  std::array<const char*, 6 * Tree::n> input_names{};
  std::array<double, 6 * Tree::n> no_loads{};
  std::array<kanec_function, all_functions> functions;
  std::array<const char*, 7 * Tree::n> coordinate_names = pointers<7 * Tree::n>(names(Tree::n).coordinates);
  std::array<const char*, 6 * Tree::n> speed_names = pointers<6 * Tree::n>(names(Tree::n).speeds);
  std::array<kanec_attitude, Tree::n> attitudes{};
  kanec_model model{};

  explicit Descriptor(int n_functions = all_functions)
      : functions{function("kinematics", 7 * Tree::n, kinematics<Tree>),
                  function("accelerations", 6 * Tree::n, faulty_accelerations<Tree, fault>),
                  function("power", 1, power<Tree>),
                  function("energy", 2, energy<Tree>),
                  function("momentum", 6, momentum<Tree>),
                  function("kinematics_and_residual_and_power", 13 * Tree::n + 1, residual<Tree, fault>)} {
    input_names.fill("load");
    for (int k = 0; k < Tree::n; ++k) attitudes[static_cast<std::size_t>(k)] = {4 * k, 3 * k};
    model.abi_version = KANEC_ABI_VERSION;
    model.struct_size = sizeof(kanec_model);
    model.name = "tree";
    model.hash = "0000000000000000";
    model.n_bodies = Tree::n;
    model.nx = 7 * Tree::n;
    model.ny = 6 * Tree::n;
    model.n_parameters = 3;
    model.n_inputs = 6 * Tree::n;
    model.n_functions = n_functions;
    model.parameter_names = parameter_names.data();
    model.parameter_defaults = no_gravity.data();
    model.input_names = input_names.data();
    model.input_defaults = no_loads.data();
    model.prepared_size = 3 * sizeof(double);
    model.prepare = prepare;
    model.functions = functions.data();
    model.coordinate_names = coordinate_names.data();
    model.speed_names = speed_names.data();
    model.n_attitudes = Tree::n;
    model.attitudes = attitudes.data();
    if (Tree::n > 1 || n_functions < all_functions) return;
    model.n_taylor = 1;
    model.taylor = &single_body_series(fault);
  }
};

template <class Tree>
const kanec_model& tree(Fault fault) {
  static const Descriptor<Tree, Fault::none> none;
  static const Descriptor<Tree, Fault::not_finite> not_finite;
  static const Descriptor<Tree, Fault::blow_up> blow_up;
  static const Descriptor<Tree, Fault::stiff> stiff;
  switch (fault) {
    case Fault::not_finite:
      return not_finite.model;
    case Fault::blow_up:
      return blow_up.model;
    case Fault::stiff:
      return stiff.model;
    default:
      return none.model;
  }
}

}  // namespace

const kanec_model& single_body(Fault fault) { return tree<OneBody>(fault); }
const kanec_model& six_bodies(Fault fault) { return tree<SixBodies>(fault); }

const kanec_model& bare_body() {
  static const Descriptor<OneBody, Fault::none> bare(2);
  return bare.model;
}

const kanec_model& body_without_accelerations() {
  static const Descriptor<OneBody, Fault::none> lacking(1);
  return lacking.model;
}

std::vector<double> six_body_coordinates() {
  std::vector<double> x(42);
  for (std::size_t k = 0; k < 6; ++k) {
    const auto i = static_cast<double>(k);
    const std::array<double, 4> eps = {std::sin(1.0 + i), std::cos(2.0 * i), 0.5 - 0.2 * i, 1.0 + 0.1 * i};
    const double length = std::sqrt(eps[0] * eps[0] + eps[1] * eps[1] + eps[2] * eps[2] + eps[3] * eps[3]);
    for (std::size_t c = 0; c < 4; ++c) x[4 * k + c] = eps[c] / length;
    for (std::size_t c = 0; c < 3; ++c) x[24 + 3 * k + c] = 0.4 * std::sin(3.0 * i + static_cast<double>(c));
  }
  return x;
}

std::vector<double> six_body_speeds() {
  std::vector<double> y(36);
  for (std::size_t i = 0; i < 18; ++i) y[i] = 1.5 * std::cos(1.7 * static_cast<double>(i));
  for (std::size_t i = 18; i < 36; ++i) y[i] = 0.3 * std::sin(2.3 * static_cast<double>(i));
  return y;
}

}  // namespace kanec::integrate::test
