// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integrate/stiff_chain.hpp"

#include <complex>
#include <numbers>
#include <string>

namespace kanec::integrate::test {
namespace {

constexpr int n = chain_masses;

// Forces of a chain whose masses are displaced by d.
double pull(const double* d, int i) {
  const double before = i > 0 ? d[i - 1] : 0.0, after = i + 1 < n ? d[i + 1] : 0.0;
  return chain_stiffness * (before - 2.0 * d[i] + after);
}

void kinematics(const void*, double, const double*, const double* y, const double*, const double*, double* out) {
  for (int i = 0; i < n; ++i) out[i] = y[i];
}

void rates(const void* p, double t, const double* x, const double* y, const double* ydot, const double* u,
           double* out) {
  kinematics(p, t, x, y, ydot, u, out);
  for (int i = 0; i < n; ++i) out[n + i] = pull(x, i) + chain_retardation * pull(y, i);
}

void residual(const void* p, double t, const double* x, const double* y, const double* ydot, const double* u,
              double* out) {
  rates(p, t, x, y, ydot, u, out);
  for (int i = 0; i < n; ++i) out[n + i] = ydot[i] - out[n + i];
}

// Matrices one after another, each n × n.
void identity(double sign, double* out) {
  for (int i = 0; i < n * n; ++i) out[i] = i % (n + 1) == 0 ? sign : 0.0;
}

void stiffness(double factor, double* out) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      out[i * n + j] = factor * chain_stiffness * (i == j ? -2.0 : i - j == 1 || j - i == 1 ? 1.0 : 0.0);
}

void rate_derivatives(const void*, double, const double*, const double*, const double*, const double*, double* out) {
  identity(0.0, out);
  identity(1.0, out + n * n);
  stiffness(1.0, out + 2 * n * n);
  stiffness(chain_retardation, out + 3 * n * n);
}

void residual_derivatives(const void*, double, const double*, const double*, const double*, const double*,
                          double* out) {
  identity(0.0, out);
  identity(1.0, out + n * n);
  stiffness(-1.0, out + 2 * n * n);
  stiffness(-chain_retardation, out + 3 * n * n);
  identity(1.0, out + 4 * n * n);
}

kanec_function function(const char* name, int n_out, kanec_evaluate evaluate) {
  kanec_function result{};
  result.name = name;
  result.n_out = n_out;
  result.evaluate = evaluate;
  return result;
}

// Entries on the diagonals up to `width` from the main one.
struct Band {
  std::vector<int> rows, columns;
  explicit Band(int width) {
    for (int i = 0; i < n; ++i)
      for (int j = i - width; j <= i + width; ++j) {
        if (j < 0 || j >= n) continue;
        rows.push_back(i);
        columns.push_back(j);
      }
  }
  kanec_pattern pattern(const char* name) const {
    return {name, n, n, static_cast<int>(rows.size()), rows.data(), columns.data()};
  }
};

// The descriptor with the arrays that it points to.
struct Descriptor {
  Band none{-1}, diagonal{0}, three{1};
  std::vector<kanec_pattern> patterns = {none.pattern("kinematics_x"),     diagonal.pattern("kinematics_y"),
                                         three.pattern("accelerations_x"), three.pattern("accelerations_y"),
                                         three.pattern("residual_x"),      three.pattern("residual_y"),
                                         diagonal.pattern("residual_ydot")};
  std::vector<kanec_function> functions = {
      function("kinematics_and_accelerations", 2 * n, rates), function("kinematics_and_residual", 2 * n, residual),
      function("kinematics_x_and_kinematics_y_and_accelerations_x_and_accelerations_y", 4 * n * n, rate_derivatives),
      function("kinematics_x_and_kinematics_y_and_residual_x_and_residual_y_and_residual_ydot", 5 * n * n,
               residual_derivatives)};
  std::vector<std::string> names;
  std::vector<const char*> coordinate_names, speed_names;
  kanec_model model{};

  explicit Descriptor(int n_functions) {
    for (const char* letter : {"s_", "sdot_"})
      for (int i = 1; i <= n; ++i) names.push_back(letter + std::to_string(i));
    for (int i = 0; i < n; ++i) coordinate_names.push_back(names[static_cast<std::size_t>(i)].c_str());
    for (int i = n; i < 2 * n; ++i) speed_names.push_back(names[static_cast<std::size_t>(i)].c_str());
    model.abi_version = KANEC_ABI_VERSION;
    model.struct_size = sizeof(kanec_model);
    model.name = "stiff_chain";
    model.hash = "0000000000000000";
    model.n_bodies = model.nx = model.ny = n;
    model.n_functions = n_functions;
    model.prepared_size = 1;
    model.prepare = [](const double*, void*) {};
    model.functions = functions.data();
    model.coordinate_names = coordinate_names.data();
    model.speed_names = speed_names.data();
    model.n_patterns = static_cast<int>(patterns.size());
    model.patterns = patterns.data();
  }
};

struct Mode {
  double q, qdot;
};

// q = c e^{at} + c̄ … with a, b the roots of a² + ω² τ a + ω² = 0, q(0) = 1, q̇(0) = 0.
Mode mode(int j, double t) {
  const double square = chain_stiffness * (2.0 - 2.0 * std::cos(std::numbers::pi * j / (n + 1)));
  const double half = 0.5 * square * chain_retardation;
  const std::complex<double> root = std::sqrt(std::complex<double>(half * half - square));
  // the small root without cancellation
  const std::complex<double> a = -half - root, b = square / a;
  const std::complex<double> p = -b / (a - b) * std::exp(a * t), q = a / (a - b) * std::exp(b * t);
  return {(p + q).real(), (a * p + b * q).real()};
}

}  // namespace

const kanec_model& stiff_chain(Derivatives derivatives) {
  static const Descriptor all(4), none(2);
  return derivatives == Derivatives::all ? all.model : none.model;
}

State chain_motion(double t) {
  State state{std::vector<double>(n), std::vector<double>(n)};
  for (const int j : {1, n}) {
    const auto [q, qdot] = mode(j, t);
    for (int i = 0; i < n; ++i) {
      const double shape = std::sin(std::numbers::pi * (i + 1) * j / (n + 1));
      state.x[static_cast<std::size_t>(i)] += q * shape;
      state.y[static_cast<std::size_t>(i)] += qdot * shape;
    }
  }
  return state;
}

}  // namespace kanec::integrate::test
