// The straight-line program: scalar operations on earlier results, named quantities, functions. Not: how it is made
// (generator/lower), improved (one file a pass) or printed (generator/emit).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "generator/program/number.hpp"

namespace kanec::program {

using Index = std::int32_t;

// Of a vector by operations.
inline std::size_t at(Index index) { return static_cast<std::size_t>(index); }

// A result with a sign: negation costs no operation, sums and products carry it along.
struct Ref {
  Index node = 0;
  bool negative = false;

  Ref operator-() const { return {node, !negative}; }
  bool operator==(const Ref&) const = default;
  auto operator<=>(const Ref&) const = default;
};

// Where a variable comes from; the arguments of emitted functions. Time is one entry, of index 0.
enum class Group { parameter, x, y, ydot, input, time };

// Further functions, named as in the standard library.
enum class Unary { tan, asin, acos, exp, log, abs, tanh };
enum class Binary { atan2, min, max, pow };

struct Constant {
  Number value;
};  // a literal
struct Variable {
  Group group;
  Index index;
};  // an entry of an argument
struct Add {
  Index a, b;
};  // a + b
struct Subtract {
  Index a, b;
};  // a - b
struct Multiply {
  Index a, b;
};  // a * b
struct Divide {
  Index a, b;
};  // a / b
struct SquareRoot {
  Index a;
};  // sqrt(a)
struct Sine {
  Index a;
};  // sin(a)
struct Cosine {
  Index a;
};  // cos(a)
struct UnaryCall {
  Unary function;
  Index a;
};
struct BinaryCall {
  Binary function;
  Index a, b;
};
struct Select {
  Index a, b, sign;
};  // sign < 0 ? a : b; derivatives have it

using Node = std::variant<Constant, Variable, Add, Subtract, Multiply, Divide, SquareRoot, Sine, Cosine, UnaryCall,
                          BinaryCall, Select>;

// Root to leaves, back, and out again with what was solved: which of a body's sections a quantity stands in.
enum class Pass { outward, inward, solved };

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

// One of the results of a function.
struct Result {
  std::string function;  // whose it is, also in a combination
  std::string out;
  Index count = 0;
  std::string layout;
  Index columns = 0;
};

// Which arguments a function takes, what its result is called in code, and the result's layout. Time comes first where
// the function reads it; inputs are also taken where it reads them.
struct Signature {
  bool x = true, y = true, ydot = false, inputs = false;
  std::string out = "out";
  std::string layout;  // "rates of x (nx) [1/s], [m/s]"
  Index columns = 0;   // of a matrix whose pattern of entries that are not always 0 is of interest; else 0
  std::vector<Result> results = {};  // of a combined function, one after another; empty: `out` alone
  bool by_inputs = false;            // inputs by number, columns or what events set: the code has all of the scene's
};

struct Function {
  std::string name;
  std::string meaning;
  std::vector<Quantity> quantities;  // in order
  std::vector<Ref> outputs;          // n_out of them, or nine a distinct block where `placements` says where they go
  std::vector<Placement> placements;
  Index n_out = 0;
  Index stride = 0;  // of the placements
  Signature signature = {};
  std::string choice = {};  // of an algorithm, where there was one: "articulated; composite would take 1200 add"
};

// What the function returns: one result, or several one after another.
std::vector<Result> results(const Function& function);

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

// What a node depends on, the most variable part: a constant, parameters only, or the arguments of a call. Operations
// on constants that no pass folds, such as their sines, are of the parameters' stage: computed once.
enum class Stage : std::uint8_t { constant, parameter, state };

std::vector<Stage> stages(const Program& program);

// The function of this name; throws InternalError where there is none.
const Function& find(const Program& program, const std::string& name);

// The operands of a node.
struct Operands {
  Index at[3];
  int count;
};
Operands operands(const Node& node);

// An addition or a subtraction.
bool is_sum(const Node& node);

// Nodes that the roots depend on, themselves included; that the outputs of any function do.
std::vector<bool> reachable(const Program& program, const std::vector<Ref>& roots);
std::vector<bool> reachable(const Program& program);

// "tan", as code writes it.
const char* name(Unary function);
const char* name(Binary function);

// Throws InternalError unless operands stand before their users and every reference is in range.
void check(const Program& program);

}  // namespace kanec::program
