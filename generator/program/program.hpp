// The straight-line program: scalar operations on earlier results, named quantities, functions. Not: how it is made
// (generator/lower), improved (one file a pass) or printed (generator/emit).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "generator/program/number.hpp"

namespace kanec::program {

using Index = std::int32_t;

// A result with a sign: negation costs no operation, sums and products carry it along.
struct Ref {
  Index node = 0;
  bool negative = false;

  Ref operator-() const { return {node, !negative}; }
  bool operator==(const Ref&) const = default;
  auto operator<=>(const Ref&) const = default;
};

// Where a variable comes from; the arguments of emitted functions.
enum class Group { parameter, x, y, ydot, input };

struct Constant { Number value; };           // a literal
struct Variable { Group group; Index index; };  // an entry of an argument
struct Add { Index a, b; };                  // a + b
struct Subtract { Index a, b; };             // a - b
struct Multiply { Index a, b; };             // a * b
struct Divide { Index a, b; };               // a / b
// Not yet made by any lowering: one-axis joints will.
struct SquareRoot { Index a; };              // sqrt(a)
struct Sine { Index a; };                    // sin(a)
struct Cosine { Index a; };                  // cos(a)

using Node = std::variant<Constant, Variable, Add, Subtract, Multiply, Divide, SquareRoot, Sine, Cosine>;

// Root to leaves, or back: which of a body's two sections a quantity stands in.
enum class Pass { outward, inward };

// A named step of the derivation.
struct Quantity {
  std::string name;                 // "a3"
  std::vector<std::string> labels;  // of its entries: "a3_1"
  std::vector<Ref> entries;
  int body = 0;  // from 1; 0 = the whole system
  Pass pass = Pass::outward;
  std::string equation;  // "a3 = Pddot3 + R3^T U3 r3"
  std::string meaning;   // with frame and unit
};

// Where nine results stand in the output: entry (i, j) of block b at offset + i * stride + j.
struct Placement {
  Index block;
  Index offset;
};

// Which arguments a function takes, what its result is called in code, and the result's layout. Time comes first where the
// function reads it; inputs are also taken where it reads them.
struct Signature {
  bool x = true, y = true, ydot = false, inputs = false;
  std::string out = "out";
  std::string layout;  // "rates of x (nx) [1/s], [m/s]"
};

struct Function {
  std::string name;
  std::string meaning;
  std::vector<Quantity> quantities;    // in order
  std::vector<Ref> outputs;            // n_out of them, or nine a distinct block where `placements` says where they go
  std::vector<Placement> placements;
  Index n_out = 0;
  Index stride = 0;  // of the placements
  Signature signature = {};
};

// Names of the arguments' entries, by group.
struct ArgumentNames {
  std::vector<std::string> parameters, x, y, ydot, inputs;
};

// Operands stand before the nodes that use them. Constants may stand many times until shared.
struct Program {
  ArgumentNames names;
  std::vector<Node> nodes;
  std::vector<Function> functions;
};

// What a node depends on, the most variable part: a constant, parameters only, or the arguments of a call.
enum class Stage : std::uint8_t { constant, parameter, state };

std::vector<Stage> stages(const Program& program);

// The operands of a node.
struct Operands {
  Index at[2];
  int count;
};
Operands operands(const Node& node);

// Nodes that the roots depend on, themselves included.
std::vector<bool> reachable(const Program& program, const std::vector<Ref>& roots);

// All outputs of all functions.
std::vector<Ref> all_outputs(const Program& program);

// Throws InternalError unless operands stand before their users and every reference is in range.
void check(const Program& program);

}  // namespace kanec::program
