// Programs of a few nodes, written down in tests. Not: random ones (random_program.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "generator/program/builder.hpp"
#include "generator/program/program.hpp"

namespace kanec::program {

class SmallProgram : public Builder {
 public:
  Ref x(Index i) { return variable(Group::x, i); }
  Ref p(Index i) { return variable(Group::parameter, i); }
  Ref c(double value) { return constant(value); }

  // A program of one function with these outputs and quantities of one entry each.
  Program with(const std::vector<Ref>& outputs, const std::vector<Ref>& named = {}) const {
    Function function{"f", "", {}, outputs, {}, static_cast<Index>(outputs.size()), 0};
    for (std::size_t i = 0; i < named.size(); ++i) {
      const std::string name = "n" + std::to_string(i + 1);
      function.quantities.push_back({name, {name}, {named[i]}, 0, Pass::outward, "", ""});
    }
    return {{}, nodes(), {function}};
  }
};

// Nodes of a kind that outputs depend on.
template <class Kind>
int count(const Program& program) {
  const std::vector<bool> alive = reachable(program);
  int n = 0;
  for (std::size_t i = 0; i < alive.size(); ++i) n += alive[i] && std::holds_alternative<Kind>(program.nodes[i]);
  return n;
}

inline const Node& node(const Program& program, Ref ref) { return program.nodes[static_cast<std::size_t>(ref.node)]; }

inline Ref output(const Program& program, std::size_t i = 0) { return program.functions[0].outputs[i]; }

}  // namespace kanec::program
