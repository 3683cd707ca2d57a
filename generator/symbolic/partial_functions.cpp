// The emitted functions of partial velocities: of the bodies of the scene, block by block.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/symbolic/factor.hpp"
#include "generator/symbolic/partials.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

bool all_wide(const Equations& equations) {
  return std::all_of(equations.speeds.begin(), equations.speeds.end(),
                     [](const Speed& speed) { return shape_of(speed.letter) == Shape::vector; });
}

class Placement {
 public:
  Placement(Derivation& derivation, Function& function) : derivation_(derivation), function_(function) {
    function.repeated = all_wide(derivation.equations);
  }

  // The block of body k and a column, named once.
  void place(int k, int column, const ex& block) {
    const int ny = derivation_.equations.layout.ny;
    const Speed& speed = derivation_.equations.speeds[static_cast<std::size_t>(column)];
    auto at = named_.find(block);
    if (at == named_.end()) at = named_.emplace(block, name(block, speed)).first;
    function_.outputs.push_back(
        {at->second, 3 * ny * (k - 1) + speed.row, ny, false, shape_of(speed.letter) == Shape::vector});
  }

 private:
  ex name(const ex& block, const Speed& speed) {
    if (GiNaC::is_a<GiNaC::numeric>(block)) return block;
    // in the section of the body that turns: below a translation
    const bool is_translation = derivation_.equations.table.of(speed.letter).name == "sdot";
    const int link = is_translation ? std::max(1, derivation_.lower(speed.link)) : speed.link;
    const std::string number = std::to_string(named_.size() + 1);
    return derivation_.define("B" + number + "_", "B_{" + number + "}", link, Pass::outward, block, "");
  }

  Derivation& derivation_;
  Function& function_;
  GiNaC::exmap named_;
};

}  // namespace

void derive_partial_velocity_functions(Derivation& derivation, const std::string& name) {
  derive_partial_velocities(derivation);
  const Tables& t = derivation.equations.tables;
  const bool is_rate = name.find("rates") != std::string::npos;
  const bool is_angular = name.find("angular") != std::string::npos;
  Placement placement(derivation, derivation.function(name));
  for (int k = 1; k <= derivation.n_bodies(); ++k) {
    const BodyFrame& body = derivation.body(k);
    if (body.link == 0) continue;
    const auto at = static_cast<std::size_t>(body.link - 1);
    if (is_angular) {
      for (const auto& [column, block] : (is_rate ? t.omega_y_dot : t.omega_y)[at])
        placement.place(k, column, body.orientation_transposed * block);
      continue;
    }
    const Letters& link = derivation.letters(body.link);
    const bool is_alone = body.mass.is_equal(link.mass) && body.r.is_equal(link.r) && body.offset.is_zero();
    const ex arm = sum(expanded(body.offset + body.orientation * body.r));
    if (is_alone) {
      for (const auto& [column, block] : (is_rate ? t.v_y_dot : t.v_y)[at]) placement.place(k, column, block);
      continue;
    }
    const Blocks blocks = partials_of_point(derivation, body.link, arm);
    for (const auto& [column, block] : blocks) {
      const ex value = is_rate ? derivation.partial_rates.of(block) : block;
      if (!value.is_zero()) placement.place(k, column, value);
    }
  }
}

}  // namespace kanec::symbolic
