// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/composites.hpp"

#include <utility>

#include "generator/symbolic/factor.hpp"
#include "generator/symbolic/notation.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

Composites::Composites(Derivation& derivation, std::vector<bool> starts_anew)
    : derivation_(derivation),
      starts_anew_(std::move(starts_anew)),
      mass_(static_cast<std::size_t>(derivation.size()) + 1),
      moment_(mass_.size()),
      inertia_(mass_.size()) {
  for (int k = 1; k <= derivation.size(); ++k)
    for (const ex& attitude : {derivation.letters(k).to_body, derivation.letters(k).to_inertial})
      if (GiNaC::is_a<Atom>(attitude)) link_of_attitude_.emplace(GiNaC::ex_to<Atom>(attitude).index(), k);
  for (int k = derivation.size(); k >= 1; --k) add(k);
}

// m* = m + Σ m*_c, h = h_own + Σ (m*_c d_c + h_c), J = J_own + Σ (J_c − m*_c d̃ d̃ − d̃ h̃_c − h̃_c d̃), where h_c and J_c
// of links that turn with this one only, in its axes: a ball's ω is its own. J_c goes in without the name of
// lower_inertia: as part of the sum two operations fewer.
void Composites::add(int k) {
  const auto at = static_cast<std::size_t>(k);
  const Inertia& own = derivation_.inertia(k);
  ex mass = own.mass, moment = own.moment, inertia = own.inertia;
  for (const int c : derivation_.mechanism().children(k)) {
    if (is_cut(c)) continue;
    const auto above = static_cast<std::size_t>(c);
    const ex& d = derivation_.joint_offsets[above];
    mass += mass_[above];
    moment += mass_[above] * d;
    inertia -= mass_[above] * (skew(d) * skew(d));
    if (!passes_moment(c)) continue;
    const ex& h = lower_moment(c);
    moment += h;
    inertia -= skew(d) * skew(h) + skew(h) * skew(d);
    inertia += congruence(derivation_.letters(c).to_lower, inertia_[above]);
  }
  mass_[at] = derivation_.define("m_sub", "m^{*}", k, Pass::inward, mass, "mass of the subtree [kg]");
  moment_[at] = derivation_.define("h", "h", k, Pass::inward, sum(expanded(moment)),
                                   "first moment of mass carried, about the body origin, body axes [kg m]");
  inertia_[at] = derivation_.define("J", "J", k, Pass::inward, factored(inertia),
                                    "inertia carried, about the body origin, body axes [kg m^2]", true);
}

const ex& Composites::lower_moment(int k) {
  const auto [at, is_new] = lower_moment_.try_emplace(k);
  if (is_new)
    at->second = define("hc", "h'", k, derivation_.letters(k).to_lower * moment(k),
                        "first moment carried, about the body origin, lower body's axes [kg m]");
  return at->second;
}

const ex& Composites::lower_inertia(int k) {
  const auto [at, is_new] = lower_inertia_.try_emplace(k);
  if (is_new)
    at->second =
        derivation_.define("Jc", "J'", k, Pass::inward, congruence(derivation_.letters(k).to_lower, inertia(k)),
                           "inertia carried, about the body origin, lower body's axes [kg m^2]", true);
  return at->second;
}

ex Composites::define(const std::string& name, const std::string& latex, int link, const ex& value,
                      const std::string& meaning) {
  return derivation_.define(name, latex, link, Pass::inward, sum(expanded(value)), meaning);
}

// "B_omega1_", of a column of A.
ex Composites::define_column(const std::string& letter, const Coordinate& column, int link, const ex& value,
                             const std::string& meaning) {
  const Symbol& speed = derivation_.equations.table.of(column.speed);
  const std::string latex = letter + "_{#;" + notation(column.speed, derivation_.equations.table, Style::latex) + "}";
  return define(letter + "_" + speed.name + speed.suffix + "_", latex, link, value, meaning);
}

// The wrench that a unit of the coordinate's speed rate takes.
Composites::Wrench Composites::unit(int k, const Coordinate& c) {
  const auto at = static_cast<std::size_t>(k);
  const int below = derivation_.lower(k);
  switch (c.freedom.kind) {
    case Freedom::Kind::attitude:
      return {derivation_.in_axes(-skew(moment_[at]), k, derivation_.home(k)), derivation_.home(k), inertia_[at]};
    case Freedom::Kind::translation: {
      const Frame frame = is_cut(k) ? derivation_.home(k) : below;
      return {mass_[at], frame,
              derivation_.in_axes(ex(1), frame, k).is_equal(1)
                  ? skew(moment_[at])
                  : skew(moment_[at]) * derivation_.in_axes(ex(1), frame, k)};
    }
    case Freedom::Kind::slide:
      return {mass_[at] * c.axis, below, skew(moment_[at]) * derivation_.in_axes(c.axis, below, k)};
    case Freedom::Kind::turn:
      break;
  }
  const ex& pitch = derivation_.letters(k).pitch;
  ex force = skew(c.axis) * moment_[at];
  ex moment = inertia_[at] * c.axis;
  if (!pitch.is_zero()) {
    force += pitch * mass_[at] * c.axis;
    moment += pitch * (skew(moment_[at]) * c.axis);
  }
  return {define_column("B", c, k, force, "force of a unit of the rate of the speed"), k,
          define_column("K", c, k, moment, "its moment about the body origin, body axes")};
}

// The same at the lower link: the joint's lever, and the moment where it passes one on.
Composites::Wrench Composites::lowered(const Wrench& wrench, int k, const Coordinate& column) {
  const int below = derivation_.lower(k);
  const ex force = derivation_.in_axes(wrench.force, wrench.frame, below);
  ex moment = skew(derivation_.joint_offsets[static_cast<std::size_t>(k)]) * force;
  if (passes_moment(k)) moment += derivation_.letters(k).to_lower * wrench.moment;
  const bool is_vector = shape_of(wrench.moment) == Shape::vector || shape_of(wrench.force) == Shape::vector;
  const Frame frame = derivation_.home(below) == below ? below : wrench.frame;
  if (!is_vector) return {frame == below ? force : wrench.force, frame, moment};
  return {frame == below ? define_column("B", column, below, force, "") : wrench.force, frame,
          define_column("K", column, below, moment, "")};
}

// A row of one number and a column of three make a block of one row: it is returned as a vector.
ex Composites::row(const Wrench& wrench, int k, const Coordinate& c, bool column_is_wide, bool& transposed) {
  const bool cut = is_cut(k) && c.freedom.kind == Freedom::Kind::translation;
  const Frame frame = cut ? derivation_.home(k) : derivation_.lower(k);
  const auto along = [&](const ex& axis, const ex& value) -> ex {
    if (value.is_zero()) return 0;
    if (!column_is_wide) return dot(axis, value);
    if (shape_of(value) == Shape::scalar) return value * axis;  // that times the identity
    return derivation_.transposed(sum(expanded(value))) * axis;
  };
  transposed = column_is_wide && !is_wide(c);
  switch (c.freedom.kind) {
    case Freedom::Kind::attitude:
      return wrench.moment;
    case Freedom::Kind::translation:
      return derivation_.in_axes(wrench.force, wrench.frame, frame);
    case Freedom::Kind::slide:
      return along(c.axis, derivation_.in_axes(wrench.force, wrench.frame, frame));
    case Freedom::Kind::turn:
      break;
  }
  const ex& pitch = derivation_.letters(k).pitch;
  ex value = along(c.axis, wrench.moment);
  if (!pitch.is_zero()) {
    value += pitch * along(c.axis, derivation_.in_axes(wrench.force, wrench.frame, k));
  }
  return value;
}

std::vector<MatrixBlock> Composites::columns(int link) {
  std::vector<MatrixBlock> blocks;
  const std::vector<Coordinate>& own = derivation_.letters(link).coordinates;
  for (std::size_t j = 0; j < own.size(); ++j) {
    if (own[j].row < 0) continue;
    Wrench wrench = unit(link, own[j]);
    for (int k = link; k > 0; k = derivation_.lower(k)) {
      const std::vector<Coordinate>& rows = derivation_.letters(k).coordinates;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].row < 0 || (k == link && i > j)) continue;
        MatrixBlock block{k, link, i, j, 0, false, is_wide(rows[i]) && is_wide(own[j])};
        block.block = with_names(row(wrench, k, rows[i], is_wide(own[j]), block.transposed));
        if (!block.block.is_zero()) blocks.push_back(block);
      }
      if (is_cut(k) || derivation_.lower(k) == 0) break;
      wrench = lowered(wrench, k, own[j]);
    }
  }
  return blocks;
}

// --- names of what many blocks have in common

// Relative rotations R_J R_Kᵀ by name; what is left is factored.
ex Composites::with_names(const ex& value) {
  if (shape_of(value) != Shape::matrix) return value;
  std::vector<Term> terms =
      expanded(with_relative_rotations(value, derivation_.equations.table, derivation_.equations.joint_rotations));
  for (Term& term : terms)
    for (std::size_t i = 0; i + 1 < term.factors.size(); ++i)
      if (is_attitude(term.factors[i]) && is_attitude(term.factors[i + 1])) {
        term.factors[i] = relative(term.factors[i], term.factors[i + 1]);
        term.factors.erase(term.factors.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      }
  return factored(sum(terms));
}

bool Composites::is_attitude(const ex& factor) const {
  return GiNaC::is_a<Atom>(factor) && link_of_attitude_.count(GiNaC::ex_to<Atom>(factor).index()) > 0;
}

// C_{J,K} = R_J R_Kᵀ with J < K; the other one is its transpose.
ex Composites::relative(const ex& R_J, const ex& Rt_K) {
  const SymbolTable& table = derivation_.equations.table;
  const int j = link_of_attitude_.at(GiNaC::ex_to<Atom>(R_J).index());
  const int k = link_of_attitude_.at(GiNaC::ex_to<Atom>(Rt_K).index());
  if (j > k) return derivation_.transposed(relative(table.of(Rt_K).transpose, table.of(R_J).transpose));
  const ex value = R_J * Rt_K;
  const auto known = rotations_.find(value);
  if (known != rotations_.end()) return known->second;
  const std::string lower = derivation_.mechanism().link(j).suffix;
  const ex symbol = derivation_.define("C" + lower + "_", "C_{" + latex_index(lower) + ",#}", k, Pass::outward, value,
                                       "takes components in the body to those in body " + lower);
  rotations_.emplace(value, symbol);
  return symbol;
}

}  // namespace kanec::symbolic
