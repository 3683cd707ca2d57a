// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/models/motion.hpp"

namespace kanec::test {
namespace {

using Arguments = program::Arguments<double>;

struct Rate {
  std::vector<double> xdot, ydot;
};

Arguments shifted(Arguments at, const Rate& rate, double h) {
  for (std::size_t i = 0; i < at.x.size(); ++i) at.x[i] += h * rate.xdot[i];
  for (std::size_t i = 0; i < at.y.size(); ++i) at.y[i] += h * rate.ydot[i];
  at.time += h;
  return at;
}

}  // namespace

Arguments after(const Model& model, Arguments at, double duration, int steps) {
  const auto rate = [&](const Arguments& s) { return Rate{model("kinematics", s), model("accelerations", s)}; };
  const double h = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const Rate first = rate(at);
    const Rate second = rate(shifted(at, first, h / 2));
    const Rate third = rate(shifted(at, second, h / 2));
    const Rate fourth = rate(shifted(at, third, h));
    Arguments next = shifted(shifted(at, first, h / 6), second, h / 3);
    next = shifted(shifted(next, third, h / 3), fourth, h / 6);
    next.time = at.time + h;
    at = next;
  }
  return at;
}

}  // namespace kanec::test
