// Loads the compiled model of its argument and lets it move. SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <kanec/runtime.hpp>

int main(int, char** argv) try {
  const kanec::Evaluator at(kanec::Model::load(argv[1]));
  const kanec::Model& model = at.model();
  std::vector<double> x(static_cast<std::size_t>(model.nx()), 0.1), y(static_cast<std::size_t>(model.ny()));
  kanec::Run run;
  run.duration = 0.5;
  const kanec::Motion motion = kanec::simulate(at, x, y, run);
  std::printf("%s: %zu rows\n", model.name().c_str(), motion.rows());
} catch (const kanec::Error& error) {
  std::printf("%s\n", error.what());
  return 2;
}
