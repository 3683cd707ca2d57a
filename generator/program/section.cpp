// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/section.hpp"

#include <map>
#include <utility>

namespace kanec::program {
namespace {

class Cut {
 public:
  Cut(const Program& program, const Function& function, const std::vector<Stage>& stages)
      : program_(program), function_(function), stages_(stages), needed_(reachable(program, function.outputs)) {
    result_.home.assign(program.nodes.size(), -1);
    for (std::size_t i = 0; i < function.outputs.size(); ++i) outputs_[function.outputs[i].node].push_back(i);
  }

  Sections result() {
    for (std::size_t i = 0; i < function_.quantities.size(); ++i) add(i);
    result_.list.push_back({Pass::solved, -1, {}, {}, {}});
    for (const Ref output : function_.outputs) {
      claim(output.node);
      store(output.node);
    }
    return std::move(result_);
  }

 private:
  bool is_free(Index node) const {
    return needed_[at(node)] && result_.home[at(node)] < 0 && stages_[at(node)] == Stage::state &&
           operands(program_.nodes[at(node)]).count > 0;
  }

  // The node and what below it has no home yet.
  void claim(Index node) {
    std::vector<Index> open = {node};
    while (!open.empty()) {
      const Index now = open.back();
      open.pop_back();
      if (!is_free(now)) continue;
      result_.home[at(now)] = static_cast<Index>(result_.list.size()) - 1;
      const Operands from = operands(program_.nodes[at(now)]);
      for (int i = 0; i < from.count; ++i) open.push_back(from.at[i]);
    }
  }

  void store(Index node) {
    const auto places = outputs_.extract(node);
    if (places.empty()) return;
    for (const std::size_t i : places.mapped()) result_.list.back().stores.push_back({i, function_.outputs[i]});
  }

  void add(std::size_t i) {
    const Quantity& quantity = function_.quantities[i];
    const bool goes_on =
        !result_.list.empty() && result_.list.back().pass == quantity.pass && result_.list.back().body == quantity.body;
    if (!goes_on) result_.list.push_back({quantity.pass, quantity.body, {}, {}, {}});
    Section& section = result_.list.back();
    section.quantities.push_back(i);
    for (const Ref entry : quantity.entries) {
      if (is_free(entry.node)) section.entries.push_back(entry);
      claim(entry.node);
    }
    for (const Ref entry : quantity.entries)
      if (result_.home[at(entry.node)] >= 0) store(entry.node);
  }

  const Program& program_;
  const Function& function_;
  const std::vector<Stage>& stages_;
  std::vector<bool> needed_;
  std::map<Index, std::vector<std::size_t>> outputs_;  // not stored yet, by node
  Sections result_;
};

}  // namespace

Sections sections(const Program& program, const Function& function, const std::vector<Stage>& stages) {
  return Cut(program, function, stages).result();
}

}  // namespace kanec::program
