// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/combined.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "generator/program/builder.hpp"
#include "generator/program/substitute.hpp"

namespace kanec::program {
namespace {

// All outputs in place, zeros between blocks.
std::vector<Ref> dense(const Function& function, Ref zero) {
  if (function.placements.empty()) return function.outputs;
  std::vector<Ref> result(static_cast<std::size_t>(function.n_out), zero);
  for (const Placement& place : function.placements)
    for (Index i = 0; i < 9; ++i)
      result[static_cast<std::size_t>(place.offset + i / 3 * function.stride + i % 3)] =
          function.outputs[static_cast<std::size_t>(9 * place.block + i)];
  return result;
}

// Quantities of several functions in one order that keeps each one's.
class Merged {
 public:
  explicit Merged(std::vector<Quantity>& list) : list_(list) {
    for (const Quantity& quantity : list) labels_.insert(quantity.labels.begin(), quantity.labels.end());
  }

  // Behind the first `after` of the list.
  void add(const std::vector<Quantity>& more, const std::string& suffix, std::size_t after = 0) {
    std::map<Key, std::size_t> known;  // up to it, so many stand in the list; of what is new 0
    for (std::size_t i = 0; i < list_.size(); ++i) known.emplace(key_of(list_[i]), i + 1);
    std::vector<Quantity> before = std::exchange(list_, {});
    std::size_t taken = 0;
    const auto take = [&](std::size_t end) {
      for (; taken < end; ++taken) list_.push_back(std::move(before[taken]));
    };
    take(after);
    for (const Quantity& quantity : more) {
      const auto found = known.find(key_of(quantity));
      if (found != known.end()) {
        take(found->second);
        continue;
      }
      list_.push_back(unique(quantity, suffix));
      known[key_of(list_.back())] = 0;
    }
    take(before.size());
  }

 private:
  using Key = std::pair<std::vector<Ref>, std::vector<std::string>>;
  static Key key_of(const Quantity& quantity) { return {quantity.entries, quantity.labels}; }

  Quantity unique(Quantity quantity, const std::string& suffix) {
    for (std::string& label : quantity.labels)
      while (!labels_.insert(label).second) label += "_" + suffix;
    return quantity;
  }

  std::vector<Quantity>& list_;
  std::set<std::string> labels_;
};

void append_results(const Function& function, std::vector<Result>& list) {
  for (Result result : results(function)) {
    const auto has_name = [&](const Result& other) { return other.out == result.out; };
    if (std::any_of(list.begin(), list.end(), has_name)) result.out += "_" + function.name;
    list.push_back(std::move(result));
  }
}

}  // namespace

void merge_quantities(std::vector<Quantity>& list, const std::vector<Quantity>& more, const std::string& suffix,
                      From from) {
  Merged(list).add(more, suffix, from == From::beginning ? 0 : list.size());
}

namespace {

// The part that returns ẏ, which others may take; empty where there is none.
std::string giver(const Program& program, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (find(program, name).signature.out == "ydot") return name;
  return "";
}

}  // namespace

Function combined(Program& program, const std::vector<std::string>& names) {
  const Ref zero = appended(program, [](Builder& builder) { return builder.constant(0.0); });
  Function result;
  result.signature = {false, false, false, false, "", "", 0, {}};
  Merged quantities(result.quantities);
  const std::string gives = giver(program, names);
  const auto takes = [&](const std::string& name) { return !gives.empty() && find(program, name).signature.ydot; };
  if (std::any_of(names.begin(), names.end(), takes)) quantities.add(find(program, gives).quantities, gives);
  for (const std::string& name : names) {
    Function part = find(program, name);
    if (takes(name)) {
      part = substituted(program, part, Group::ydot, find(program, gives).outputs);
      part.signature.ydot = false;
    }
    result.name += (result.name.empty() ? "" : "_and_") + name;
    result.meaning += (result.meaning.empty() ? "" : "; ") + part.meaning;
    const std::vector<Ref> outputs = dense(part, zero);
    result.outputs.insert(result.outputs.end(), outputs.begin(), outputs.end());
    quantities.add(part.quantities, part.name);
    append_results(part, result.signature.results);
    result.signature.x |= part.signature.x;
    result.signature.y |= part.signature.y;
    result.signature.ydot |= part.signature.ydot;
    result.signature.inputs |= part.signature.inputs;
    result.signature.by_inputs |= part.signature.by_inputs;
  }
  result.n_out = static_cast<Index>(result.outputs.size());
  return result;
}

}  // namespace kanec::program
