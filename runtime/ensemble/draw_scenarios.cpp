// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <numbers>
#include <random>

#include "runtime/base/error.hpp"
#include "runtime/ensemble/scenarios.hpp"

namespace kanec {
namespace {

// Not the standard library's distributions, which differ from one library to the next.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double of(const scene::Draw& draw) {
    if (draw.kind == scene::Draw::Kind::uniform) return draw.a + (draw.b - draw.a) * share();
    return draw.a + draw.b * normal();
  }

 private:
  double share() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  // in [0, 1)
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - share()));
    return radius * std::cos(2.0 * std::numbers::pi * share());
  }

  std::mt19937_64 engine_;
};

}  // namespace

ScenarioTable draw_scenarios(const scene::Scene& scene, int count, std::uint64_t seed) {
  if (scene.ensemble.draws.empty())
    throw InputError(
        "--ensemble scene: scene " + scene.name +
        " draws nothing; allowed: a scene whose [ensemble] names what is drawn, as theta_1 = {uniform = [0, "
        "1]}, or a CSV file");
  ScenarioTable table{"scene " + scene.name, {}, {}, {}};
  for (const scene::Draw& draw : scene.ensemble.draws) table.names.push_back(draw.name);
  Random random(seed);
  for (int i = 0; i < count; ++i)
    for (const scene::Draw& draw : scene.ensemble.draws) table.values.push_back(random.of(draw));
  return table;
}

}  // namespace kanec
