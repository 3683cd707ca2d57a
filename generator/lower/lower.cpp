// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/lower.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "generator/lower/data.hpp"
#include "generator/lower/elimination.hpp"
#include "generator/lower/sections.hpp"
#include "generator/symbolic/notation.hpp"
#include "generator/symbolic/order.hpp"
#include "runtime/base/error.hpp"

namespace kanec::lower {
namespace {

using GiNaC::ex;
using program::Number;
using symbolic::Atom;
using symbolic::Role;

class Lowering {
 public:
  explicit Lowering(const symbolic::Equations& equations)
      : equations_(equations), values_(equations.table.all().size()), sections_(equations) {}

  program::Program result() {
    program::Program program;
    for (const symbolic::Function& function : equations_.functions) program.functions.push_back(lowered(function));
    program.nodes = std::move(builder_.nodes());
    return program;
  }

 private:
  static std::size_t index(const ex& atom) { return static_cast<std::size_t>(GiNaC::ex_to<Atom>(atom).index()); }

  program::Function lowered(const symbolic::Function& function) {
    program::Function result{function.name, function.meaning, {}, {}, {}, function.n_out, 0, function.signature};
    used_.assign(values_.size(), false);
    const bool has_places = function.repeated && !function.outputs.empty();
    has_places ? place_blocks(function, result) : place_entries(function, result);
    result.quantities = quantities_in_order();
    return result;
  }

  void place_entries(const symbolic::Function& function, program::Function& result) {
    result.outputs.assign(static_cast<std::size_t>(function.n_out), builder_.constant(0.0));
    for (const symbolic::Output& output : function.outputs) {
      Block block = output.wide ? matrix(of(output.block)) : of(output.block);
      if (output.transposed) block = transposed(block);
      for (int i = 0; i < block.rows; ++i)
        for (int j = 0; j < block.columns; ++j)
          result.outputs[static_cast<std::size_t>(output.offset + i * output.stride + j)] = block.at(i, j);
    }
  }

  void place_blocks(const symbolic::Function& function, program::Function& result) {
    GiNaC::exmap places;
    for (const symbolic::Output& output : function.outputs) {
      result.stride = output.stride;
      auto known = places.find(output.block);
      if (known == places.end()) {
        known = places.emplace(output.block, static_cast<int>(places.size())).first;
        const Block block = matrix(of(output.block));
        result.outputs.insert(result.outputs.end(), block.entries.begin(), block.entries.end());
      }
      result.placements.push_back({GiNaC::ex_to<GiNaC::numeric>(known->second).to_int(), output.offset});
    }
  }

  // A scalar as that times the identity.
  Block matrix(const Block& block) {
    Block zero{3, 3, {}};
    zero.entries.fill(builder_.constant(0.0));
    return block.is_scalar() ? add(builder_, zero, block) : block;
  }

  std::vector<program::Quantity> quantities_in_order() const {
    std::vector<program::Quantity> result;
    for (const Placed& placed : sections_.in_order(used_)) {
      result.push_back(placed.quantity ? named(*placed.quantity) : solved(placed));
      result.back().body = placed.section.body;
      result.back().pass = placed.section.pass;
    }
    return result;
  }

  // A transpose is named by the entries of what it is the transpose of, as in the text.
  program::Quantity named(const symbolic::Quantity& quantity) const {
    const symbolic::Symbol& own = equations_.table.of(quantity.symbol);
    const symbolic::Symbol& symbol = own.is_transpose ? equations_.table.of(own.transpose) : own;
    Block block = *values_[index(quantity.symbol)];
    if (own.is_transpose) block = transposed(block);
    program::Quantity result = labelled(symbol.name + symbol.suffix, block);
    result.equation = symbolic::notation(quantity.symbol, equations_.table, symbolic::Style::text) + " = " +
                      symbolic::notation(quantity.value, equations_.table, symbolic::Style::text);
    result.meaning = quantity.meaning;
    return result;
  }

  static program::Quantity labelled(const std::string& name, const Block& block) {
    program::Quantity result;
    result.name = name;
    for (int i = 0; i < block.rows; ++i)
      for (int j = 0; j < block.columns; ++j) {
        const std::string row = std::to_string(i + 1);
        const std::string entry = block.columns > 1 ? row + std::to_string(j + 1) : row;
        const bool ends_open = !name.empty() && name.back() == '_';
        result.labels.push_back(block.is_scalar() ? (ends_open ? name.substr(0, name.size() - 1) : name)
                                                  : name + (ends_open ? "" : "_") + entry);
        result.entries.push_back(block.at(i, j));
      }
    return result;
  }

  // An unknown of a solved system, or its pivots.
  program::Quantity solved(const Placed& placed) const {
    const symbolic::Symbol& symbol = equations_.table.of(placed.unknown);
    const std::string name = symbol.name + symbol.suffix;
    if (!placed.is_pivot) {
      program::Quantity result = labelled(name, *values_[index(placed.unknown)]);
      result.equation = name + ": from A ydot = f by elimination";
      return result;
    }
    program::Quantity result = labelled("D_" + name, pivots_.at(static_cast<int>(index(placed.unknown))));
    result.equation = "D_" + name + ": pivots of L D L^T";
    return result;
  }

  Block of(const ex& e) {
    if (GiNaC::is_a<Atom>(e)) return letter(e);
    if (GiNaC::is_a<GiNaC::numeric>(e)) return scalar(number(GiNaC::ex_to<GiNaC::numeric>(e)));
    if (GiNaC::is_a<GiNaC::add>(e)) return sum(e);
    if (GiNaC::is_a<GiNaC::mul>(e)) return multiple(e);
    if (GiNaC::is_a<GiNaC::ncmul>(e)) return chain({e.begin(), e.end()});
    if (GiNaC::is_a<GiNaC::power>(e)) return scalar(power(of(e.op(0)).at(0), GiNaC::ex_to<GiNaC::numeric>(e.op(1))));
    return function(e);
  }

  // Whole and half exponents.
  Ref power(Ref base, const GiNaC::numeric& exponent) {
    if (exponent.is_negative()) return builder_.divide(builder_.constant(1.0), power(base, -exponent));
    if (!exponent.is_integer()) return power(builder_.square_root(base), exponent * 2);
    Ref result = base;
    for (int i = 1; i < exponent.to_int(); ++i) result = builder_.multiply(result, base);
    return result;
  }

  Block function(const ex& e) {
    if (is_ex_the_function(e, symbolic::skew)) return skew(builder_, of(e.op(0)));
    if (is_ex_the_function(e, symbolic::dot)) return scalar(dot(builder_, of(e.op(0)), of(e.op(1))));
    if (is_ex_the_function(e, symbolic::rotation)) return rotation(builder_, of(e.op(0)), of(e.op(1)).at(0));
    if (is_ex_the_function(e, symbolic::turn)) return turn(builder_, of(e.op(0)), of(e.op(1)).at(0));
    if (is_ex_the_function(e, symbolic::congruence)) return congruence(builder_, of(e.op(0)), of(e.op(1)));
    if (is_ex_the_function(e, symbolic::similarity)) return similarity(builder_, of(e.op(0)), of(e.op(1)));
    if (is_ex_the_function(e, symbolic::outer)) return outer(builder_, of(e.op(0)), of(e.op(1)));
    if (is_ex_the_function(e, symbolic::ldl)) return ldl(builder_, of(e.op(0)));
    if (is_ex_the_function(e, symbolic::forward)) return forward(builder_, of(e.op(0)), of(e.op(1)));
    if (is_ex_the_function(e, symbolic::scaled)) return scaled(builder_, of(e.op(0)), of(e.op(1)));
    if (is_ex_the_function(e, symbolic::backward)) return backward(builder_, of(e.op(0)), of(e.op(1)));
    if (is_ex_the_function(e, symbolic::second_moment)) return second_moment(builder_, of(e.op(0)));
    if (is_ex_the_function(e, symbolic::expression)) return scalar(data_.expression(whole(e.op(0)), whole(e.op(1))));
    if (is_ex_the_function(e, symbolic::inverse)) return inverse(builder_, of(e.op(0)));
    if (is_ex_the_function(e, symbolic::gyroscopic)) return gyroscopic(builder_, of(e.op(0)), of(e.op(1)));
    if (is_ex_the_function(e, symbolic::inertia_moment)) return inertia_moment(builder_, of(e.op(0)), of(e.op(1)));
    throw InternalError("lower: an expression of no known kind");
  }

  static int whole(const ex& e) { return GiNaC::ex_to<GiNaC::numeric>(e).to_int(); }

  Ref number(const GiNaC::numeric& value) {
    const Number quotient = Number(value.numer().to_double()) / Number(value.denom().to_double());
    return builder_.constant(quotient);
  }

  Block sum(const ex& e) {
    std::optional<Block> result;
    for (const ex& operand : symbolic::ordered(e)) result = result ? add(builder_, *result, of(operand)) : of(operand);
    return *result;
  }

  // Scalars first, numbers before letters; a number other than ±1 scales a speed inside a skew matrix where there is
  // one, so that 2 ω̃ is formed once for all that use it.
  Block multiple(const ex& e) {
    std::optional<Block> factor;
    std::optional<ex> block;
    for (const ex& operand : symbolic::ordered(e)) {
      if (operand.return_type() == GiNaC::return_types::noncommutative)
        block = operand;
      else
        factor = factor ? multiply(builder_, *factor, of(operand)) : of(operand);
    }
    if (!block) return *factor;
    const bool is_number = e.nops() == 2 && GiNaC::is_a<GiNaC::numeric>(e.op(1));
    if (is_number && e.op(1).is_equal(-1)) return -of(*block);
    if (is_number && GiNaC::is_a<GiNaC::ncmul>(*block)) return chain({block->begin(), block->end()}, *factor);
    return multiply(builder_, *factor, of(*block));
  }

  // Right to left when it ends in a vector or a dense matrix, else left to right.
  Block chain(const std::vector<ex>& factors, std::optional<Block> scale = {}) {
    std::vector<Block> blocks;
    for (const ex& factor : factors) {
      const bool is_cross = is_ex_the_function(factor, symbolic::skew);
      if (scale && is_cross) {
        blocks.push_back(skew(builder_, multiply(builder_, *scale, of(factor.op(0)))));
        scale.reset();
      } else {
        blocks.push_back(of(factor));
      }
    }
    const auto is_skew = [](const ex& factor) { return is_ex_the_function(factor, symbolic::skew); };
    const std::size_t n = factors.size();
    const bool leftward = !(is_skew(factors[n - 1]) && is_skew(factors[n - 2]));
    Block result = leftward ? blocks.back() : blocks.front();
    for (std::size_t i = 1; i < n; ++i)
      result = leftward ? multiply(builder_, blocks[n - 1 - i], result) : multiply(builder_, result, blocks[i]);
    return scale ? multiply(builder_, *scale, result) : result;
  }

  Block letter(const ex& atom) {
    const symbolic::Symbol& symbol = equations_.table.of(atom);
    if (symbol.role == Role::quantity && !sections_.is_defined(atom)) return transposed(letter(symbol.transpose));
    std::optional<Block>& value = values_[index(atom)];
    if (symbol.role != Role::quantity) {
      if (!value) value = data_.of(symbol);
      return *value;
    }
    if (value) {
      mark_used(atom);  // lowered for another function before
    } else {
      used_[index(atom)] = true;
      if (const symbolic::Quantity* definition = sections_.definition(atom))
        values_[index(atom)] = mirrored(of(definition->value), symbol);
      else
        solve(sections_.solve_of(atom));
    }
    return *values_[index(atom)];
  }

  // Of a symmetric matrix the upper triangle is computed, the other is the same.
  static Block mirrored(Block block, const symbolic::Symbol& symbol) {
    if (block.size() != 9 || !symbol.transpose.is_equal(symbol.atom)) return block;
    for (int i = 1; i < 3; ++i)
      for (int j = 0; j < i; ++j) block.at(i, j) = block.at(j, i);
    return block;
  }

  void mark_used(const ex& e) {
    if (!GiNaC::is_a<Atom>(e)) {
      for (const ex& operand : e) mark_used(operand);
      return;
    }
    const ex atom = sections_.is_defined(e) ? e : equations_.table.of(e).transpose;
    if (!sections_.is_defined(atom) || used_[index(atom)]) return;
    used_[index(atom)] = true;
    for (const ex& part : sections_.parts(atom)) mark_used(part);
  }

  // All unknowns of a system at once.
  void solve(const symbolic::Solve& solve) {
    std::vector<int> first;  // row of each unknown
    std::vector<Ref> right;
    for (const symbolic::Solve::Unknown& unknown : solve.unknowns) {
      used_[index(unknown.letter)] = true;
      first.push_back(static_cast<int>(right.size()));
      append_entries(of(unknown.right), symbolic::shape_of(unknown.letter), right);
    }
    Entries matrix;
    for (const symbolic::Solve::Entry& entry : solve.matrix) place(entry, first, matrix);
    const Factors factors = factorised(builder_, std::move(matrix), static_cast<int>(right.size()));
    const std::vector<Ref> solution = lower::solved(builder_, factors, std::move(right));
    for (std::size_t i = 0; i < solve.unknowns.size(); ++i) {
      const ex& letter = solve.unknowns[i].letter;
      values_[index(letter)] = part(solution, first[i], symbolic::shape_of(letter));
      pivots_[static_cast<int>(index(letter))] = part(factors.pivots, first[i], symbolic::shape_of(letter));
    }
  }

  // A zero stands for a vector of zeros.
  void append_entries(const Block& block, symbolic::Shape shape, std::vector<Ref>& out) {
    const int n = shape == symbolic::Shape::vector ? 3 : 1;
    for (int i = 0; i < n; ++i) out.push_back(block.size() == n ? block.at(i) : block.at(0));
  }

  // Into the lower triangle: a row eliminated after its column.
  void place(const symbolic::Solve::Entry& entry, const std::vector<int>& first, Entries& matrix) {
    Block block = entry.wide ? this->matrix(of(entry.block)) : of(entry.block);
    if (entry.transposed) block = transposed(block);
    const int row = first[static_cast<std::size_t>(entry.row)], column = first[static_cast<std::size_t>(entry.column)];
    for (int i = 0; i < block.rows; ++i)
      for (int j = 0; j < block.columns; ++j)
        matrix[{std::max(row + i, column + j), std::min(row + i, column + j)}] = block.at(i, j);
  }

  static Block part(const std::vector<Ref>& values, int first, symbolic::Shape shape) {
    const auto at = static_cast<std::size_t>(first);
    if (shape == symbolic::Shape::scalar) return scalar(values[at]);
    return vector(values[at], values[at + 1], values[at + 2]);
  }

  const symbolic::Equations& equations_;
  Builder builder_;
  Data data_{equations_, builder_};
  std::vector<std::optional<Block>> values_;  // of letters, by table index
  std::map<int, Block> pivots_;               // of unknowns, likewise
  Sections sections_;
  std::vector<bool> used_;  // by the function being lowered
};

// "theta_3" is theta3 in code.
std::vector<std::string> joined(std::vector<std::string> names) {
  for (std::string& name : names) name.erase(name.find('_'), 1);
  return names;
}

program::ArgumentNames argument_names(const scene::Scene& scene) {
  program::ArgumentNames names;
  names.x = joined(coordinate_names(scene));
  names.y = joined(speed_names(scene));
  names.ydot = joined(speed_rate_names(scene));
  for (const scene::Named& parameter : scene.parameters) names.parameters.push_back(parameter.name);
  for (const scene::Named& input : scene.inputs) names.inputs.push_back(input.name);
  return names;
}

}  // namespace

program::Program lower(const symbolic::Equations& equations) {
  program::Program program = Lowering(equations).result();
  program.names = argument_names(equations.scene);
  return program;
}

}  // namespace kanec::lower
