// Reads the scene of its argument, checks, simulates, and evaluates it. SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <kanec/kanec.hpp>

int main(int, char** argv) try {
  const kanec::Scene scene = kanec::Scene::read(argv[1]);
  for (const kanec::Agreed& function : scene.check({.functions = {"accelerations"}}))
    if (!function.passed) return 1;
  kanec::Run run = scene.run();
  run.duration = 0.5;
  const kanec::Motion motion = scene.simulate(run);
  const kanec::Evaluator at(scene.compile());
  const std::vector<double> ydot = at.evaluate("accelerations", {.x = motion.x_at(0), .y = motion.y_at(0)});
  std::printf("%s: %zu rows, %zu accelerations\n", scene.name().c_str(), motion.rows(), ydot.size());
} catch (const kanec::Error& error) {
  std::printf("%s\n", error.what());
  return 2;
}
