// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/variation.hpp"

#include "generator/symbolic/factor.hpp"
#include "generator/symbolic/kane.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

Variation::Variation(Derivation& of, By by_what)
    : derivation(of),
      by(by_what),
      chain(derive_acceleration_chain(of, of.rates)),
      balance_(inertia_alone(of, chain)),
      sums_(of, balance_, "r"),
      composites_(of, std::vector<bool>(static_cast<std::size_t>(of.size()) + 1, false)),
      carried_(of, chain, sums_, composites_),
      function_(of.function(by == By::xi ? "inertia_xi" : "inertia_y")) {}

const Coordinate* Variation::rotation(int k) const {
  const std::vector<Coordinate>& own = derivation.letters(k).coordinates;
  return own.empty() || own.front().row < 0 || !is_rotation(own.front()) ? nullptr : &own.front();
}

ex Variation::define(const std::string& name, int k, const Coordinate& of, const ex& value) {
  const Symbol& speed = derivation.equations.table.of(of.speed);
  const std::string letter = name + "_" + speed.name + speed.suffix + "_";
  return derivation.define(letter, name, k, Pass::inward, factored(value), "");
}

void Variation::place(const Coordinate& row, const Coordinate& column, const ex& block, bool is_transposed) {
  if (block.is_zero()) return;
  const int ny = derivation.equations.layout.ny;
  function_.outputs.push_back({factored(block), row.row * ny + column.row, ny, is_transposed});
}

JointMotion Variation::motion(int k, const Coordinate& c) {
  const int below = lower(k);
  const ex spin = skew(derivation.letters(below).omega);
  const auto rates = [&](const ex& of, ex& rate, ex& acceleration) {
    rate = spin * of;
    acceleration = chain.spin(below) * of;
  };
  JointMotion m;
  if (c.freedom.kind == Freedom::Kind::turn) {
    m.turn = lower_axis(k, c);
    m.slide = derivation.letters(k).pitch * m.turn;
  } else {
    m.slide = c.freedom.kind == Freedom::Kind::slide ? c.axis : ex(1);
  }
  rates(m.turn, m.turn_rate, m.turn_acceleration);
  rates(m.slide, m.slide_rate, m.slide_acceleration);
  return m;
}

// Of a turn, in the lower link's axes.
ex Variation::lower_axis(int k, const Coordinate& c) {
  const Link& link = derivation.mechanism().link(k);
  if (is_identity(link.zero)) return c.axis;
  ex& known = lower_axes_[k];
  const scene::Axis& a = link.freedoms.front().axis;
  if (known.is_zero())
    known = derivation.equations.table.add_numbers(
        "a", "a", link.suffix,
        {scene::Number::constant(a[0]), scene::Number::constant(a[1]), scene::Number::constant(a[2])});
  return known;
}

}  // namespace kanec::symbolic
