// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/sections.hpp"

#include <algorithm>

namespace kanec::lower {

using GiNaC::ex;
using program::Pass;
using symbolic::Atom;

namespace {

int index(const ex& letter) { return GiNaC::ex_to<Atom>(letter).index(); }

// A letter that needs something of a later section moves there; on the way back in, to the way out after it.
Section later(const Section& own, const Section& needed) {
  if (own.body == 0 && needed.body < 0) return needed;  // a place in the inertial frame
  if (own.key() >= needed.key()) return own;
  if (own.body == 0 || needed.body == 0) return {Pass::inward, 0};
  if (own.pass == Pass::outward && needed.pass != Pass::outward) {
    const Section after{Pass::solved, own.body};
    return after.key() >= needed.key() ? after : needed;
  }
  return needed;
}

}  // namespace

Sections::Sections(const symbolic::Equations& equations)
    : equations_(equations), definitions_(equations.table.all().size(), nullptr) {
  for (const symbolic::Quantity& quantity : equations.quantities) {
    const auto at = static_cast<std::size_t>(index(quantity.symbol));
    definitions_[at] = &quantity;
    constant_.resize(definitions_.size());
    constant_[at] = is_constant(quantity.value);
  }
  for (const symbolic::Solve& solve : equations.solves)
    for (const symbolic::Solve::Unknown& unknown : solve.unknowns)
      unknowns_[index(unknown.letter)] = {&solve, equations.mechanism.link(unknown.link).body};
}

// Made of numbers of the scene alone.
bool Sections::is_constant(const ex& e) const {
  if (GiNaC::is_a<Atom>(e)) {
    const symbolic::Symbol& symbol = equations_.table.of(e);
    if (symbol.role == symbolic::Role::numbers) return true;
    const auto at =
        static_cast<std::size_t>(index(definitions_[static_cast<std::size_t>(index(e))] ? e : symbol.transpose));
    return definitions_[at] != nullptr && constant_[at];
  }
  if (is_ex_the_function(e, symbolic::expression)) return false;
  return std::all_of(e.begin(), e.end(), [this](const ex& operand) { return is_constant(operand); });
}

// Of numbers of the same body alone: then it may stand in that body's section.
bool Sections::is_of_body(const ex& e, int body) const {
  if (!GiNaC::is_a<Atom>(e))
    return std::all_of(e.begin(), e.end(), [&](const ex& operand) { return is_of_body(operand, body); });
  const ex letter = is_defined(e) ? e : equations_.table.of(e).transpose;
  const symbolic::Quantity* quantity = definition(letter);
  return quantity == nullptr || (quantity->body == body && is_of_body(quantity->value, body));
}

bool Sections::is_defined(const ex& letter) const {
  return definition(letter) != nullptr || unknowns_.count(index(letter)) > 0;
}

const symbolic::Quantity* Sections::definition(const ex& letter) const {
  return definitions_[static_cast<std::size_t>(index(letter))];
}

const symbolic::Solve& Sections::solve_of(const ex& unknown) const { return *unknowns_.at(index(unknown)).first; }

std::vector<ex> Sections::parts(const ex& letter) const {
  if (const symbolic::Quantity* quantity = definition(letter)) return {quantity->value};
  std::vector<ex> result;
  for (const symbolic::Solve::Unknown& unknown : solve_of(letter).unknowns) {
    result.push_back(unknown.right);
    result.push_back(unknown.letter);
  }
  for (const symbolic::Solve::Entry& entry : solve_of(letter).matrix) result.push_back(entry.block);
  return result;
}

Section Sections::own_section(const ex& letter) const {
  if (const symbolic::Quantity* quantity = definition(letter)) return {quantity->pass, quantity->body};
  return {Pass::solved, unknowns_.at(index(letter)).second};
}

Section Sections::section_of(const ex& e, std::map<int, Section>& known) const {
  Section result = Section::first();
  if (!GiNaC::is_a<Atom>(e)) {
    for (const ex& operand : e) {
      const Section needed = section_of(operand, known);
      if (needed.key() > result.key()) result = needed;
    }
    return result;
  }
  const ex letter = is_defined(e) ? e : equations_.table.of(e).transpose;
  if (!is_defined(letter) || is_constant(letter)) return result;
  const auto found = known.find(index(letter));
  if (found != known.end()) return found->second;
  result = own_section(letter);
  if (const symbolic::Quantity* quantity = definition(letter))
    result = later(result, section_of(quantity->value, known));
  known.emplace(index(letter), result);
  return result;
}

std::vector<Placed> Sections::in_order(const std::vector<bool>& used) const {
  std::map<int, Section> known;
  std::vector<Placed> result;
  const auto is_used = [&](const ex& letter) { return used[static_cast<std::size_t>(index(letter))]; };
  // solutions come before what is made of them, the roots' first
  for (const symbolic::Solve& solve : equations_.solves)
    for (auto unknown = solve.unknowns.rbegin(); unknown != solve.unknowns.rend(); ++unknown)
      if (is_used(unknown->letter)) result.push_back({own_section(unknown->letter), nullptr, unknown->letter, false});
  for (const symbolic::Quantity& quantity : equations_.quantities)
    if (is_used(quantity.symbol)) {
      const Section section = section_of(quantity.symbol, known);
      const bool has_own = is_constant(quantity.symbol) && is_of_body(quantity.value, quantity.body);
      const Section own{quantity.pass, quantity.body};
      result.push_back({has_own ? own : section.body < 0 ? Section() : section, &quantity, 0, false});
    }
  for (const symbolic::Solve& solve : equations_.solves)
    for (const symbolic::Solve::Unknown& unknown : solve.unknowns)
      if (is_used(unknown.letter))
        result.push_back({{Pass::inward, equations_.mechanism.link(unknown.link).body}, nullptr, unknown.letter, true});
  std::stable_sort(result.begin(), result.end(),
                   [](const Placed& a, const Placed& b) { return a.section.key() < b.section.key(); });
  return result;
}

}  // namespace kanec::lower
