// In which section of a function each named quantity stands: outward by ascending bodies, inward by descending ones,
// outward again with what was solved, the whole system last; never before what it is written in. Not: values
// (lower.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/symbolic/equations.hpp"

namespace kanec::lower {

struct Section {
  program::Pass pass = program::Pass::outward;
  int body = 1;  // from 1; 0 = the whole system

  // Of what is made of data alone: before all others.
  static Section first() { return {program::Pass::outward, -1}; }
  std::tuple<int, int> key() const {
    if (body == 0) return {3, 0};
    const int order = pass == program::Pass::outward ? 0 : pass == program::Pass::inward ? 1 : 2;
    return {order, order == 1 ? -body : body};
  }
};

// A quantity, or an unknown of a solved system or its pivots, in its section.
struct Placed {
  Section section;
  const symbolic::Quantity* quantity = nullptr;
  GiNaC::ex unknown;
  bool is_pivot = false;
};

class Sections {
 public:
  explicit Sections(const symbolic::Equations& equations);

  // Whether a letter is a quantity or an unknown; else it is data, or the transpose of one that is.
  bool is_defined(const GiNaC::ex& letter) const;
  const symbolic::Quantity* definition(const GiNaC::ex& letter) const;  // nullptr: an unknown, or data
  const symbolic::Solve& solve_of(const GiNaC::ex& unknown) const;
  // The expressions that a defined letter is made of.
  std::vector<GiNaC::ex> parts(const GiNaC::ex& letter) const;

  // The letters that are `used` (by table index), in the order in which they stand.
  std::vector<Placed> in_order(const std::vector<bool>& used) const;

 private:
  bool is_constant(const GiNaC::ex& e) const;
  bool is_of_body(const GiNaC::ex& e, int body) const;
  Section section_of(const GiNaC::ex& e, std::map<int, Section>& known) const;
  Section own_section(const GiNaC::ex& letter) const;

  const symbolic::Equations& equations_;
  std::vector<const symbolic::Quantity*> definitions_;              // by table index
  std::vector<bool> constant_;                                      // likewise
  std::map<int, std::pair<const symbolic::Solve*, int>> unknowns_;  // likewise: system and its body
};

}  // namespace kanec::lower
