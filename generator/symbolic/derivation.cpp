// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/derivation.hpp"

#include <algorithm>

#include "generator/symbolic/factor.hpp"
#include "runtime/base/error.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

void Rates::set(const ex& atom, const ex& rate) {
  const auto at = static_cast<std::size_t>(GiNaC::ex_to<Atom>(atom).index());
  if (rates_.size() <= at) rates_.resize(at + 1, ex(0));
  rates_[at] = rate;
}

ex Rates::operator()(const Atom& atom) const {
  const auto at = static_cast<std::size_t>(atom.index());
  return at < rates_.size() ? rates_[at] : ex(0);
}

Derivation::Derivation(const scene::Scene& scene, const Way& chosen) : equations(scene), way(chosen) {
  equations.mechanism = symbolic::mechanism(scene, way.reductions);
  define_letters(*this);
  derive_inertias(*this);
  home_ = {0};
  for (int j = 1; j <= size(); ++j) {
    const std::vector<int> above = mechanism().children(j);
    const bool carries = std::any_of(above.begin(), above.end(), [&](int c) { return letters(c).turns_with_lower; });
    const bool has_axes = !letters(j).to_body.is_equal(1);
    const bool is_free_alone =
        is_free(j) && std::all_of(above.begin(), above.end(), [this](int c) { return is_free(c); });
    const bool wants_axes = way.axes == Axes::body && !is_free_alone;
    home_.push_back(has_axes && (letters(j).turns_with_lower || carries || wants_axes) ? j : 0);
  }
}

ex Derivation::define(const std::string& name, const std::string& latex, int link, Pass pass, const ex& value,
                      const std::string& meaning, bool is_symmetric) {
  if (value.is_zero() || GiNaC::is_a<Atom>(value)) return value;
  const std::string suffix = link > 0 ? mechanism().link(link).suffix : "";
  const Shape shape = shape_of(value);
  const ex symbol = equations.table.add(Role::quantity, name, latex, suffix, shape);
  if (shape == Shape::matrix && !is_symmetric)
    equations.table.pair(symbol, equations.table.add(Role::quantity, name, latex, suffix, shape));
  equations.quantities.push_back({symbol, value, link > 0 ? mechanism().link(link).body : 0, pass, meaning});
  return symbol;
}

bool Derivation::is_free(int link) const {
  const Letters& l = letters(link);
  return l.coordinates.size() == 2 && l.coordinates[0].freedom.kind == Freedom::Kind::attitude &&
         l.coordinates[0].row >= 0 && l.coordinates[1].freedom.kind == Freedom::Kind::translation;
}

ex Derivation::in_axes(const ex& e, Frame from, Frame to) const {
  if (from == to || e.is_zero()) return e;
  const ex to_inertial = letters(from).to_inertial;
  return with_relative_rotations(letters(to).to_body * (to_inertial * e), equations.table, equations.joint_rotations);
}

Function& Derivation::function(const std::string& name) {
  for (Function& function : equations.functions)
    if (function.name == name) return function;
  throw InternalError("no function " + name + " in the derivation");
}

}  // namespace kanec::symbolic
