// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/lower.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "generator/lower/block.hpp"
#include "generator/symbolic/notation.hpp"
#include "generator/symbolic/order.hpp"
#include "runtime/base/error.hpp"

namespace kanec::lower {
namespace {

using GiNaC::ex;
using program::Group;
using program::Number;
using symbolic::Atom;
using symbolic::Role;

class Lowering {
 public:
  explicit Lowering(const symbolic::Equations& equations)
      : equations_(equations), values_(equations.table.all().size()), definitions_(values_.size(), nullptr) {
    for (const symbolic::Quantity& quantity : equations.quantities) definitions_[index(quantity.symbol)] = &quantity;
  }

  program::Program result(const std::vector<const symbolic::Function*>& functions) {
    program::Program program;
    for (const symbolic::Function* function : functions) program.functions.push_back(lowered(*function));
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
      Block block = output.stride > 1 ? matrix(of(output.block)) : of(output.block);
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

  // Outward by ascending bodies, inward by descending ones, the whole system last; inside a body as derived.
  std::vector<program::Quantity> quantities_in_order() const {
    std::vector<const symbolic::Quantity*> used;
    for (const symbolic::Quantity& quantity : equations_.quantities)
      if (used_[index(quantity.symbol)]) used.push_back(&quantity);
    const auto key = [](const symbolic::Quantity* q) {
      const bool inward = q->pass == symbolic::Pass::inward;
      return std::pair(inward, q->body == 0 ? 1 : inward ? -q->body : q->body);
    };
    std::stable_sort(used.begin(), used.end(), [&](const auto* a, const auto* b) { return key(a) < key(b); });
    std::vector<program::Quantity> result;
    for (const symbolic::Quantity* quantity : used) result.push_back(named(*quantity));
    return result;
  }

  // R_Kᵀ is named by the entries of R_K, as in the text.
  program::Quantity named(const symbolic::Quantity& quantity) const {
    const symbolic::Symbol& symbol = equations_.table.of(quantity.symbol);
    Block block = *values_[index(quantity.symbol)];
    const bool by_transpose = symbol.name == "Rt";
    if (by_transpose) block = transposed(block);
    const std::string name =
        (by_transpose ? "R" : symbol.name) + (symbol.body > 0 ? std::to_string(symbol.body) : "");
    program::Quantity result;
    result.name = name;
    for (int i = 0; i < block.rows; ++i)
      for (int j = 0; j < block.columns; ++j) {
        const std::string row = std::to_string(i + 1);
        const std::string entry = block.columns > 1 ? row + std::to_string(j + 1) : row;
        result.labels.push_back(block.is_scalar() ? name : name + "_" + entry);
        result.entries.push_back(block.at(i, j));
      }
    result.body = quantity.body;
    result.pass = quantity.pass;
    result.equation = symbolic::notation(quantity.symbol, equations_.table, symbolic::Style::text) + " = " +
                      symbolic::notation(quantity.value, equations_.table, symbolic::Style::text);
    result.meaning = quantity.meaning;
    return result;
  }

  Block of(const ex& e) {
    if (GiNaC::is_a<Atom>(e)) return letter(e);
    if (GiNaC::is_a<GiNaC::numeric>(e)) return scalar(number(GiNaC::ex_to<GiNaC::numeric>(e)));
    if (GiNaC::is_a<GiNaC::add>(e)) return sum(e);
    if (GiNaC::is_a<GiNaC::mul>(e)) return scaled(e);
    if (GiNaC::is_a<GiNaC::ncmul>(e)) return chain({e.begin(), e.end()});
    if (GiNaC::is_a<GiNaC::power>(e) && e.op(1).is_equal(-1))
      return scalar(builder_.divide(builder_.constant(1.0), of(e.op(0)).at(0)));
    return function(e);
  }

  Block function(const ex& e) {
    if (is_ex_the_function(e, symbolic::skew)) return skew(builder_, of(e.op(0)));
    if (is_ex_the_function(e, symbolic::dot)) return scalar(dot(builder_, of(e.op(0)), of(e.op(1))));
    if (is_ex_the_function(e, symbolic::rotation)) return rotation(builder_, of(e.op(0)), of(e.op(1)).at(0));
    if (is_ex_the_function(e, symbolic::inverse)) return inverse(builder_, of(e.op(0)));
    if (is_ex_the_function(e, symbolic::gyroscopic)) return gyroscopic(builder_, of(e.op(0)), of(e.op(1)));
    if (is_ex_the_function(e, symbolic::inertia_moment)) return inertia_moment(builder_, of(e.op(0)), of(e.op(1)));
    throw InternalError("lower: an expression of no known kind");
  }

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
  Block scaled(const ex& e) {
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
    const bool is_transpose = symbol.role == Role::quantity && definitions_[index(atom)] == nullptr;
    if (is_transpose) return transposed(letter(symbol.transpose));
    used_[index(atom)] = true;
    std::optional<Block>& value = values_[index(atom)];
    if (symbol.role != Role::quantity) {
      if (!value) value = data(symbol);
    } else if (!value) {
      value = of(definitions_[index(atom)]->value);
    } else {
      mark_used(definitions_[index(atom)]->value);  // lowered for another function before
    }
    return *value;
  }

  void mark_used(const ex& e) {
    if (!GiNaC::is_a<Atom>(e)) {
      for (const ex& operand : e) mark_used(operand);
      return;
    }
    const bool is_defined = definitions_[index(e)] != nullptr;
    const ex atom = is_defined ? e : equations_.table.of(e).transpose;
    if (definitions_[index(atom)] == nullptr || used_[index(atom)]) return;
    used_[index(atom)] = true;
    mark_used(definitions_[index(atom)]->value);
  }

  Block data(const symbolic::Symbol& symbol) {
    const scene::Scene& scene = equations_.scene;
    const int k = symbol.body - 1;
    const auto three = [&](Group group, int first) {
      return vector(variable(group, first), variable(group, first + 1), variable(group, first + 2));
    };
    const auto body = [&]() -> const scene::Body& { return scene.bodies[static_cast<std::size_t>(k)]; };
    const auto at = [&]() -> const scene::BodyLayout& { return layout_.bodies[static_cast<std::size_t>(k)]; };
    switch (symbol.role) {
      case Role::euler_vector: return three(Group::x, at().eps);
      case Role::euler_scalar: return scalar(variable(Group::x, at().eps + 3));
      case Role::omega: return three(Group::y, at().omega);
      case Role::s: return three(Group::x, at().s[0]);
      case Role::sdot: return three(Group::y, at().sdot[0]);
      case Role::omegadot: return three(Group::ydot, at().omega);
      case Role::sddot: return three(Group::ydot, at().sdot[0]);
      case Role::mass: return scalar(value(body().mass));
      case Role::inertia: return symmetric(body().inertia);
      case Role::r: return three_numbers(body().r);
      case Role::q: return three_numbers(body().q);
      case Role::gravity: return three_numbers(scene.gravity);
      case Role::force: return three_numbers(body().force);
      case Role::moment: return three_numbers(body().moment);
      case Role::quantity: break;
    }
    throw InternalError("lower: a letter without a value");
  }

  Ref variable(Group group, int at) { return builder_.variable(group, at); }

  Ref value(const scene::Number& number) {
    if (number.kind == scene::Number::Kind::parameter) return variable(Group::parameter, number.index);
    if (number.kind == scene::Number::Kind::input) return variable(Group::input, number.index);
    return builder_.constant(number.value);
  }

  Block three_numbers(const scene::Vector& v) { return vector(value(v[0]), value(v[1]), value(v[2])); }

  Block symmetric(const scene::Symmetric& m) {
    const Ref xy = value(m.xy), xz = value(m.xz), yz = value(m.yz);
    return {3, 3, {value(m.xx), xy, xz, xy, value(m.yy), yz, xz, yz, value(m.zz)}};
  }

  const symbolic::Equations& equations_;
  const scene::Layout layout_{equations_.scene};
  Builder builder_;
  std::vector<std::optional<Block>> values_;                     // of letters, by table index
  std::vector<const symbolic::Quantity*> definitions_;           // likewise
  std::vector<bool> used_;                                       // by the function being lowered
};

program::ArgumentNames argument_names(const scene::Scene& scene) {
  program::ArgumentNames names;
  const auto append = [&](std::vector<std::string>& list, const std::string& letter, int components) {
    for (int k = 1; k <= size(scene); ++k)
      for (int i = 1; i <= components; ++i)
        list.push_back(letter + std::to_string(k) + "_" + std::to_string(i));
  };
  append(names.x, "eps", 4);
  append(names.x, "s", 3);
  append(names.y, "omega", 3);
  append(names.y, "sdot", 3);
  append(names.ydot, "omegadot", 3);
  append(names.ydot, "sddot", 3);
  for (const scene::Named& parameter : scene.parameters) names.parameters.push_back(parameter.name);
  for (const scene::Named& input : scene.inputs) names.inputs.push_back(input.name);
  return names;
}

const symbolic::Function& find(const symbolic::Equations& equations, const std::string& name) {
  std::string known;
  for (const symbolic::Function& function : equations.functions) {
    if (function.name == name) return function;
    known += (known.empty() ? "" : ", ") + function.name;
  }
  throw InputError("no function '" + name + "' in this model; it has: " + known);
}

}  // namespace

program::Program lower(const symbolic::Equations& equations, const std::vector<std::string>& functions) {
  std::vector<const symbolic::Function*> wanted;
  for (const symbolic::Function& function : equations.functions)
    if (functions.empty()) wanted.push_back(&function);
  for (const std::string& name : functions) {
    const symbolic::Function* function = &find(equations, name);
    if (std::find(wanted.begin(), wanted.end(), function) == wanted.end()) wanted.push_back(function);
  }
  program::Program program = Lowering(equations).result(wanted);
  program.names = argument_names(equations.scene);
  return program;
}

}  // namespace kanec::lower
