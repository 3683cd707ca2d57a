// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <iterator>
#include <utility>

#include "generator/symbolic/partials.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

SubsetSums::SubsetSums(std::vector<ex> terms, std::string name, std::string latex, std::string meaning)
    : terms_(std::move(terms)),
      name_(std::move(name)),
      latex_(std::move(latex)),
      meaning_(std::move(meaning)),
      largest_(terms_.size(), nullptr) {}

ex SubsetSums::over(Derivation& derivation, const std::vector<int>& bodies) {
  if (bodies.size() == 1) return terms_[static_cast<std::size_t>(bodies[0])];
  const auto known = sums_.find(bodies);
  if (known != sums_.end()) return known->second;
  ex value = 0;
  std::vector<int> rest = bodies;
  while (!rest.empty()) {
    const auto first = static_cast<std::size_t>(rest[0]);
    const std::vector<int>* part = largest_[first];
    if (part != nullptr && std::includes(rest.begin(), rest.end(), part->begin(), part->end())) {
      value += sums_.at(*part);
      std::vector<int> other;
      std::set_difference(rest.begin(), rest.end(), part->begin(), part->end(), std::back_inserter(other));
      rest = std::move(other);
    } else {
      value += terms_[first];
      rest.erase(rest.begin());
    }
  }
  const ex symbol = derivation.define(name_, latex_, bodies[0], Pass::inward, value, meaning_);
  const auto entry = sums_.emplace(bodies, symbol).first;
  for (const int k : bodies) largest_[static_cast<std::size_t>(k)] = &entry->first;
  return symbol;
}

}  // namespace kanec::symbolic
