// Partial velocities by differentiating the velocities with respect to the speeds, and their rates in time.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/symbolic/derivation.hpp"
#include "generator/symbolic/partials.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

// Adds ∂value/∂y to the block of `column`.
void add_partial(Blocks& blocks, int column, const ex& value, const ex& y) {
  const ex block = partial(value, y);
  if (!block.is_zero()) blocks[column] = blocks.count(column) ? blocks[column] + block : block;
}

// Rates of blocks; bodies of one subtree share them, so each distinct one is differentiated once.
Blocks rates_of(const Derivation& derivation, const Blocks& blocks, GiNaC::exmap& known) {
  Blocks result;
  for (const auto& [column, block] : blocks) {
    auto at = known.find(block);
    if (at == known.end()) at = known.emplace(block, derivation.rates.of(block)).first;
    if (!at->second.is_zero()) result[column] = at->second;
  }
  return result;
}

}  // namespace

void derive_partial_velocities(Derivation& derivation) {
  Tables& tables = derivation.equations.tables;
  GiNaC::exmap known;
  for (int k = 1; k <= derivation.size(); ++k) {
    const auto at = static_cast<std::size_t>(k - 1);
    const int below = derivation.lower(k);
    const Letters& body = derivation.letters(k);
    // ∂Ṗ_K/∂y through the name Ṗ_L, then what the link to K adds
    Blocks origin = below > 0 ? tables.origin_y[static_cast<std::size_t>(below - 1)] : Blocks{};
    if (below > 0)
      add_partial(origin, derivation.omega_column(below), tables.origin_rate[at], derivation.letters(below).omega);
    add_partial(origin, derivation.sdot_column(k), tables.origin_rate[at], body.sdot);
    // v_K through the name Ṗ_K; where the origin's velocity is a letter itself (ṡ of a body on the frame) so is its partial
    Blocks centre = origin;
    add_partial(centre, derivation.omega_column(k), tables.velocity[at], body.omega);
    tables.origin_y.push_back(origin);
    tables.v_y.push_back(centre);
    tables.omega_y.push_back({{derivation.omega_column(k), ex(1)}});
    tables.v_y_dot.push_back(rates_of(derivation, centre, known));
    tables.omega_y_dot.push_back({});
  }
}

namespace {

void add_function(Derivation& derivation, const std::string& name, const std::string& meaning,
                  const std::vector<Blocks>& rows, bool reads_speeds) {
  const int ny = 6 * derivation.size();
  Function function{name, meaning, {}, 3 * ny * derivation.size(), true,
                    {true, reads_speeds, false, false, reads_speeds ? "v_y_dot" : "v_y",
                     (reads_speeds ? "v_y_dot" : "v_y") + std::string(" of body 1, of body 2, ... (n_bodies x 3 x ny)")}};
  GiNaC::exmap named;
  for (int k = 1; k <= derivation.size(); ++k)
    for (const auto& [column, block] : rows[static_cast<std::size_t>(k - 1)]) {
      auto at = named.find(block);
      if (at == named.end()) {
        const bool of_omega = column < derivation.size();
        const int body = of_omega ? column + 1 : std::max(1, derivation.lower(column + 1 - derivation.size()));
        const std::string number = std::to_string(named.size() + 1);
        const ex symbol = block.is_equal(1) ? block
                                            : derivation.define("B" + number + "_", "B_{" + number + "}", body,
                                                                Pass::outward, block, "");
        at = named.emplace(block, symbol).first;
      }
      function.outputs.push_back({at->second, 3 * ny * (k - 1) + 3 * column, ny, false});
    }
  derivation.equations.functions.push_back(function);
}

}  // namespace

void derive_partial_velocity_functions(Derivation& derivation) {
  add_function(derivation, "partial_velocities", "partial velocities v_y of the mass centres: v = v_y y",
               derivation.equations.tables.v_y, false);
  add_function(derivation, "partial_velocity_rates", "time derivatives of the partial velocities",
               derivation.equations.tables.v_y_dot, true);
}

std::vector<Group> groups(const std::vector<Blocks>& rows, int column) {
  std::vector<Group> result;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto block = rows[k].find(column);
    if (block == rows[k].end()) continue;
    auto group = result.begin();
    while (group != result.end() && !group->block.is_equal(block->second)) ++group;
    if (group == result.end()) group = result.insert(group, {block->second, {}});
    group->bodies.push_back(static_cast<int>(k) + 1);
  }
  return result;
}

}  // namespace kanec::symbolic
