// The emitted C++ header. SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "swing.hpp"
#include "swing_taylor.hpp"

int main() {
  namespace model = kanec::swing;
  const auto prepared = model::prepare(model::Parameters<double>{});
  const double x[model::nx] = {0.5}, y[model::ny] = {0};
  double ydot[model::ny];
  model::accelerations(prepared, x, y, ydot);
  std::printf("%.6f\n", ydot[model::at::thetadot_bob]);
}
