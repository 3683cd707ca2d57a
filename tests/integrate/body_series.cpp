// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integrate/body_series.hpp"

#include <cstring>
#include <limits>

namespace kanec::integrate::test {
namespace {

// where the parts of z begin
constexpr int eps = 0, s = 4, omega = 7, sdot = 10, work = 13, size = 14;

class Coefficients {
 public:
  explicit Coefficients(double* z) : z_(z) {}
  double& operator()(int k, int i) const { return z_[k * size + i]; }
  // coefficient k of the product of entries i and j
  double product(int k, int i, int j) const {
    double sum = 0.0;
    for (int l = 0; l <= k; ++l) sum += (*this)(l, i) * (*this)(k - l, j);
    return sum;
  }

 private:
  double* z_;
};

// Coefficient k of ε̇ = ½ (ε4 ω + e × ω), ε̇4 = −½ e·ω and of I ω̇ = M − ω × I ω.
void turn(const Coefficients& c, int k, const double* moment) {
  c(k + 1, eps + 3) = 0.0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, l = (i + 2) % 3;
    const double across = c.product(k, eps + j, omega + l) - c.product(k, eps + l, omega + j);
    c(k + 1, eps + i) = 0.5 * (c.product(k, eps + 3, omega + i) + across) / (k + 1);
    c(k + 1, eps + 3) -= 0.5 * c.product(k, eps + i, omega + i) / (k + 1);
    const auto I = [](int axis) { return body_inertia[static_cast<std::size_t>(axis)]; };
    const double gyroscopic = (I(l) - I(j)) * c.product(k, omega + j, omega + l);
    c(k + 1, omega + i) = ((k == 0 ? moment[i] : 0.0) - gyroscopic) / I(i) / (k + 1);
  }
}

template <Fault fault>
void coefficients(const void* prepared, double t, const double* u, int order, void* z, void*) {
  const auto* gravity = static_cast<const double*>(prepared);
  const Coefficients c(static_cast<double*>(z));
  for (int k = 0; k < order; ++k) {
    turn(c, k, u + 3);
    c(k + 1, work) = 0.0;
    for (int i = 0; i < 3; ++i) {
      c(k + 1, s + i) = c(k, sdot + i) / (k + 1);
      c(k + 1, sdot + i) = k == 0 ? u[i] / body_m + gravity[i] : 0.0;
      if (fault == Fault::stiff) c(k + 1, sdot + i) -= 1e5 * c(k, sdot + i) / (k + 1);
      c(k + 1, work) += (u[i] * c(k, sdot + i) + u[3 + i] * c(k, omega + i)) / (k + 1);
    }
    if (fault == Fault::blow_up) c(k + 1, sdot) = c.product(k, sdot, sdot) / (k + 1);
  }
  if (fault == Fault::not_finite && t >= 0.5) c(1, omega + 1) = std::numeric_limits<double>::quiet_NaN();
}

template <Fault fault>
kanec_taylor series() {
  kanec_taylor result{};
  result.scalar_size = sizeof(double);
  result.size = size;
  result.highest_order = 24;
  result.prepared_size = 3 * sizeof(double);
  result.alignment = alignof(double);
  result.prepare = [](const double* parameters, void* prepared) {
    std::memcpy(prepared, parameters, 3 * sizeof(double));
  };
  result.coefficients = coefficients<fault>;
  return result;
}

}  // namespace

const kanec_taylor& single_body_series(Fault fault) {
  static const kanec_taylor none = series<Fault::none>(), not_finite = series<Fault::not_finite>(),
                            blow_up = series<Fault::blow_up>(), stiff = series<Fault::stiff>();
  switch (fault) {
    case Fault::not_finite:
      return not_finite;
    case Fault::blow_up:
      return blow_up;
    case Fault::stiff:
      return stiff;
    default:
      return none;
  }
}

}  // namespace kanec::integrate::test
