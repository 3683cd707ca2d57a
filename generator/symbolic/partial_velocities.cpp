// Partial velocities by differentiating the velocities with respect to the speeds, and their rates in time.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/symbolic/factor.hpp"
#include "generator/symbolic/notation.hpp"
#include "generator/symbolic/partials.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

void add(Blocks& blocks, int column, const ex& block) {
  if (block.is_zero()) return;
  const auto known = blocks.find(column);
  if (known == blocks.end())
    blocks.emplace(column, block);
  else
    known->second = sum(expanded(known->second + block));
}

// ∂value/∂y through a velocity that is written with ω of a link, whose own partials are known.
void add_through_omega(Blocks& blocks, const ex& value, const ex& omega, const Blocks& omega_y) {
  if (!GiNaC::is_a<Atom>(omega)) return;
  const ex factor = partial(value, omega);
  if (factor.is_zero()) return;
  for (const auto& [column, block] : omega_y) add(blocks, column, sum(expanded(factor * block)));
}

class Partials {
 public:
  explicit Partials(Derivation& derivation)
      : derivation_(derivation), rates_(derivation.partial_rates = derivation.rates) {}

  void all() {
    Tables& t = derivation_.equations.tables;
    for (int k = 1; k <= derivation_.size(); ++k) {
      const auto at = static_cast<std::size_t>(k - 1);
      const int below = derivation_.lower(k);
      const Letters& link = derivation_.letters(k);
      Blocks omega =
          below > 0 && link.turns_with_lower ? turned(t.omega_y[static_cast<std::size_t>(below - 1)], link) : Blocks{};
      Blocks origin = below > 0 ? t.origin_y[static_cast<std::size_t>(below - 1)] : Blocks{};
      if (below > 0)
        add_through_omega(origin, t.origin_rate[at], derivation_.letters(below).omega,
                          t.omega_y[static_cast<std::size_t>(below - 1)]);
      for (const Coordinate& c : link.coordinates) {
        if (c.column < 0) continue;
        add(origin, c.column, partial(t.origin_rate[at], c.speed));
        if (c.freedom.kind == Freedom::Kind::attitude) add(omega, c.column, 1);
        if (c.freedom.kind == Freedom::Kind::turn) add(omega, c.column, partial(link.omega_value, c.speed));
      }
      t.omega_y.push_back(named(omega, k, "omega_", "\\omega", "partial angular velocity, body axes"));
      t.origin_y.push_back(named(origin, k, "P_", "P", "partial velocity of the body origin, inertial axes"));
      Blocks centre = t.origin_y.back();
      add_through_omega(centre, t.velocity[at], link.omega, t.omega_y.back());
      t.v_y.push_back(centre);
      t.omega_y_dot.push_back(rates_of(t.omega_y.back()));
      t.v_y_dot.push_back(rates_of(centre));
    }
  }

 private:
  static Blocks turned(const Blocks& blocks, const Letters& link) {
    Blocks result;
    for (const auto& [column, block] : blocks) result[column] = link.from_lower * block;
    return result;
  }

  // Blocks of three columns keep their closed form, which bodies share; those of one column are written with the lower
  // link's by name, and so are blocks of a ball whose rotation is passed on.
  Blocks named(const Blocks& blocks, int k, const std::string& name, const std::string& latex,
               const std::string& meaning) {
    Blocks result;
    for (const auto& [column, block] : blocks) {
      const Speed& speed = derivation_.equations.speeds[static_cast<std::size_t>(column)];
      const bool is_own = speed.link == k;
      const bool is_closed = shape_of(speed.letter) == Shape::vector && !passes_on(speed.link);
      if (is_own || is_closed || GiNaC::is_a<GiNaC::numeric>(block)) {
        result[column] = block;
        continue;
      }
      const Symbol letter = derivation_.equations.table.of(speed.letter);  // a copy: define() moves the table
      const std::string index = "_{#," + notation(speed.letter, derivation_.equations.table, Style::latex) + "}";
      const ex value = factored(block);
      const ex symbol =
          derivation_.define(name + letter.name + letter.suffix + "_", latex + index, k, Pass::outward, value, meaning);
      if (!symbol.is_equal(value))
        rates_.set(symbol,
                   derivation_.define(name + "dot_" + letter.name + letter.suffix + "_", "\\dot " + latex + index, k,
                                      Pass::outward, factored(rates_.of(value)), "its rate"));
      result[column] = symbol;
    }
    return result;
  }

  // Does a link above turn with it?
  bool passes_on(int link) const {
    const std::vector<int> above = derivation_.mechanism().children(link);
    return std::any_of(above.begin(), above.end(), [&](int c) { return derivation_.letters(c).turns_with_lower; });
  }

  // Bodies of one subtree share blocks, so each distinct one is differentiated once.
  Blocks rates_of(const Blocks& blocks) {
    Blocks result;
    for (const auto& [column, block] : blocks) {
      auto at = known_.find(block);
      if (at == known_.end()) at = known_.emplace(block, rates_.of(block)).first;
      if (!at->second.is_zero()) result[column] = at->second;
    }
    return result;
  }

  Derivation& derivation_;
  Rates& rates_;
  GiNaC::exmap known_;
};

}  // namespace

void derive_partial_velocities(Derivation& derivation) {
  if (derivation.equations.tables.v_y.empty()) Partials(derivation).all();
}

Blocks partials_of_point(const Derivation& derivation, int link, const ex& place) {
  if (link == 0) return {};
  const Tables& t = derivation.equations.tables;
  const Letters& l = derivation.letters(link);
  Blocks result = t.origin_y[static_cast<std::size_t>(link - 1)];
  if (GiNaC::is_a<Atom>(l.omega))
    add_through_omega(result, l.to_inertial * (skew(l.omega) * place), l.omega,
                      t.omega_y[static_cast<std::size_t>(link - 1)]);
  return result;
}

}  // namespace kanec::symbolic
