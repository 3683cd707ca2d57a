// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/order.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

using Key = std::vector<long>;

bool commutes(const ex& e) { return GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e); }

// One mark a kind of expression, functions by their name; long names go round in 64 bits.
long kind(const ex& e) {
  if (!GiNaC::is_a<GiNaC::function>(e)) return -1;
  std::uint64_t mark = static_cast<std::uint64_t>(-1000);
  for (const char c : GiNaC::ex_to<GiNaC::function>(e).get_name()) mark = mark * 31 - static_cast<unsigned char>(c);
  return static_cast<long>(mark);
}

// In sixteenths, as far as a long goes.
long whole(double value) { return static_cast<long>(std::clamp(value * 16, -9e18, 9e18)); }

// Letters by index; functions and numbers by marks, numbers also by value.
void append_key(const ex& e, Key& key) {
  if (GiNaC::is_a<Atom>(e)) {
    key.push_back(GiNaC::ex_to<Atom>(e).index());
  } else if (GiNaC::is_a<GiNaC::numeric>(e)) {
    key.push_back(-3);
    key.push_back(whole(GiNaC::ex_to<GiNaC::numeric>(e).to_double()));
  } else {
    const std::vector<ex> operands = commutes(e) ? ordered(e) : std::vector<ex>(e.begin(), e.end());
    for (const ex& operand : operands)
      if (!GiNaC::is_a<GiNaC::numeric>(operand)) append_key(operand, key);
    key.push_back(kind(e));
    for (const ex& operand : operands)
      if (GiNaC::is_a<GiNaC::numeric>(operand)) append_key(operand, key);
  }
}

}  // namespace

std::vector<ex> ordered(const ex& e) {
  std::vector<std::pair<Key, ex>> keyed;
  const bool is_product = GiNaC::is_a<GiNaC::mul>(e);
  for (const ex& operand : e) {
    const bool is_block = is_product && operand.return_type() != GiNaC::return_types::commutative;
    keyed.emplace_back(Key{is_block ? 1 : 0}, operand);
    append_key(operand, keyed.back().first);
  }
  std::stable_sort(keyed.begin(), keyed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<ex> operands;
  for (auto& [key, operand] : keyed) operands.push_back(operand);
  return operands;
}

bool precedes(const ex& a, const ex& b) {
  Key key_a;
  Key key_b;
  append_key(a, key_a);
  append_key(b, key_b);
  return key_a < key_b;
}

}  // namespace kanec::symbolic
