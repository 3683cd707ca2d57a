// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/derivation.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

Letters letters_of(SymbolTable& table, const scene::Body& body, int k) {
  const auto add = [&](Role role, const char* name, const char* latex, Shape shape) {
    return table.add(role, name, latex, k, shape);
  };
  const auto add_unless = [&](bool absent, Role role, const char* name, const char* latex) {
    return absent ? ex(0) : add(role, name, latex, Shape::vector);
  };
  Letters l;
  l.q = add_unless(is_zero(body.q), Role::q, "q", "q");
  l.s = add(Role::s, "s", "s", Shape::vector);
  l.sdot = add(Role::sdot, "sdot", "\\dot s", Shape::vector);
  l.sddot = add(Role::sddot, "sddot", "\\ddot s", Shape::vector);
  l.to_inertial = add(Role::quantity, "Rt", "R", Shape::matrix);
  l.to_body = add(Role::quantity, "R", "R", Shape::matrix);
  table.pair(l.to_inertial, l.to_body);
  l.e = add(Role::euler_vector, "e", "e", Shape::vector);
  l.eps4 = add(Role::euler_scalar, "eps4_", "\\varepsilon_{4}", Shape::scalar);
  l.omega = add(Role::omega, "omega", "\\omega", Shape::vector);
  l.omegadot = add(Role::omegadot, "omegadot", "\\dot\\omega", Shape::vector);
  l.r = add_unless(is_zero(body.r), Role::r, "r", "r");
  l.mass = add(Role::mass, "m", "m", Shape::scalar);
  l.inertia = add(Role::inertia, "I", "I", Shape::matrix);
  l.force = add_unless(is_zero(body.force), Role::force, "F", "F");
  l.moment = add_unless(is_zero(body.moment), Role::moment, "M", "M");
  return l;
}

}  // namespace

void Rates::set(const ex& atom, const ex& rate) {
  const auto at = static_cast<std::size_t>(GiNaC::ex_to<Atom>(atom).index());
  if (rates_.size() <= at) rates_.resize(at + 1, ex(0));
  rates_[at] = rate;
}

ex Rates::operator()(const Atom& atom) const {
  const auto at = static_cast<std::size_t>(atom.index());
  return at < rates_.size() ? rates_[at] : ex(0);
}

Derivation::Derivation(const scene::Scene& scene) {
  equations.scene = scene;
  equations.gravity = is_zero(scene.gravity) ? ex(0) : equations.table.add(Role::gravity, "g", "g", 0, Shape::vector);
  Letters inertial;
  inertial.to_inertial = inertial.to_body = 1;
  equations.letters.push_back(inertial);
  for (int k = 1; k <= size(); ++k) {
    const scene::Body& body = scene.bodies[static_cast<std::size_t>(k - 1)];
    equations.letters.push_back(letters_of(equations.table, body, k));
    const Letters& l = equations.letters.back();
    rates.set(l.to_inertial, l.to_inertial * skew(l.omega));
    rates.set(l.to_body, -skew(l.omega) * l.to_body);
    rates.set(l.s, l.sdot);
    rates.set(l.omega, l.omegadot);
    rates.set(l.sdot, l.sddot);
    equations.quantities.push_back({l.to_inertial, rotation(l.e, l.eps4), k, Pass::outward,
                                    "R takes inertial components to body components; e = (eps_1, eps_2, eps_3)"});
  }
}

ex Derivation::define(const std::string& name, const std::string& latex, int body, Pass pass, const ex& value,
                      const std::string& meaning) {
  if (value.is_zero() || GiNaC::is_a<Atom>(value)) return value;
  const ex symbol = equations.table.add(Role::quantity, name, latex, body, shape_of(value));
  equations.quantities.push_back({symbol, value, body, pass, meaning});
  return symbol;
}

}  // namespace kanec::symbolic
