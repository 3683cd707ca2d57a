// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/emit/every_node.hpp"

#include "generator/emit/header.hpp"
#include "generator/emit/taylor.hpp"
#include "generator/program/combined.hpp"
#include "generator/program/derivative.hpp"
#include "generator/program/passes.hpp"
#include "generator/read/read.hpp"

namespace kanec::test {
namespace {

using program::Binary;
using program::Builder;
using program::Group;
using program::Index;
using program::Ref;
using program::Unary;

constexpr Unary unary[] = {Unary::tan, Unary::asin, Unary::acos, Unary::exp, Unary::log, Unary::abs, Unary::tanh};
constexpr Binary binary[] = {Binary::atan2, Binary::min, Binary::max, Binary::pow};

// Each kind of node once or twice, of u and v between 0.1 and 0.9.
std::vector<Ref> every_kind(Builder& b, Ref u, Ref v) {
  std::vector<Ref> list = {b.add(u, v),      b.subtract(u, v), b.multiply(u, v), b.divide(u, v),
                           b.square_root(u), b.sine(-u),       b.cosine(-u),     b.select(b.subtract(u, v), u, v)};
  for (const Unary function : unary) {
    list.push_back(b.call(function, u));
    if (function != Unary::log) list.push_back(b.call(function, -b.multiply(u, v)));
  }
  for (const Binary function : binary) {
    list.push_back(b.call(function, u, v));
    list.push_back(b.call(function, b.add(u, v), -b.multiply(u, u)));
  }
  return list;
}

Ref between(Builder& b, Ref a) { return b.add(b.constant(0.5), b.multiply(b.constant(0.4), b.sine(a))); }

program::Program source(int repetitions) {
  Builder b;
  const auto of = [&b](Group group, Index index) { return b.variable(group, index); };
  const Ref a = of(Group::parameter, 0), c = of(Group::parameter, 2), drive = of(Group::input, 1);
  const Ref t = of(Group::time, 0);
  const Ref u = between(b, b.add(of(Group::x, 1), b.multiply(drive, t)));
  const Ref v = between(b, b.multiply(of(Group::x, 4), of(Group::y, 2)));
  program::Function every{"every", "every kind of node", {}, every_kind(b, u, v), {}, 0, 0, {}};
  for (const Ref ref : every_kind(b, between(b, a), between(b, c))) every.outputs.push_back(ref);
  for (int i = 1; i < repetitions; ++i) {
    const Ref w = between(b, b.add(every.outputs.back(), b.multiply(t, b.constant(i))));
    for (const Ref ref : every_kind(b, w, u)) every.outputs.push_back(ref);
  }
  const program::Quantity named{"u", {"u_1", "v_1"}, {u, v}, 1, program::Pass::outward, "u, v", "arguments"};
  every.quantities = {named};
  every.n_out = static_cast<Index>(every.outputs.size());
  every.signature = {true, false, false, false, "out", "values"};
  program::Function still{"still", "what time and inputs do not move", {}, {v, b.multiply(v, v)}, {}, 2, 0, {}};
  still.signature = {true, true, false, true, "out", "v and its square"};
  std::vector<program::Column> columns;
  for (Index i = 0; i < 7; ++i) columns.push_back({{{Group::x, i}, b.constant(1.0)}});
  program::Program program{{}, std::move(b.nodes()), {every, still}};
  if (repetitions == 1) {
    program.functions.push_back(jacobian(program, every, columns));
    program.functions.back().name = "every_x";
  }
  program.functions.push_back(combined(program, {"every", "still"}));
  if (repetitions > 1) program.functions.erase(program.functions.begin(), program.functions.end() - 1);
  return program;
}

}  // namespace

Sample every_node_sample() {
  Random random(21);
  scene::Scene scene = scene::from_connection({0});
  scene.name = "every_node";
  scene.parameters = {{"a", 0.4}, {"unread", 3}, {"b", 1.2}};
  scene.inputs = {{"idle", 2}, {"drive", -0.7}};
  return sample_of(scene, random);
}

namespace {

Generated emitted(program::Program program, const scene::Scene& scene, emit::Language language = emit::Language::cpp) {
  program = program::optimized(program);
  program.names = {
      {"a", "unread", "b"}, coordinate_names(scene), speed_names(scene), speed_rate_names(scene), {"idle", "drive"}};
  emit::Model model{&scene, "0", "0123456789abcdef", "all functions", "models/every_node.toml"};
  model.language = language;
  if (language == emit::Language::c)
    return {program, scene.name, model.hash, emit::emit_header(model, program), "", "", ""};
  return {program,
          scene.name,
          model.hash,
          emit::emit_header(model, program),
          emit::emit_abi(model, program),
          emit::emit_batch(model, program),
          emit::emit_taylor(model, program)};
}

}  // namespace

Generated every_node_model(const scene::Scene& scene, int repetitions, emit::Language language) {
  return emitted(source(repetitions), scene, language);
}

Generated every_node_motion(const scene::Scene& scene) {
  program::Program program = source(1);
  program::Function rates = program.functions[0];  // every
  const auto size = static_cast<std::size_t>(n_coordinates(scene) + n_speeds(scene));
  Builder builder;
  builder.nodes() = std::move(program.nodes);
  std::vector<Ref> sums(rates.outputs.begin(), rates.outputs.begin() + static_cast<std::ptrdiff_t>(size));
  for (std::size_t i = size; i < rates.outputs.size(); ++i)
    sums[i % size] = builder.add(sums[i % size], rates.outputs[i]);
  program.nodes = std::move(builder.nodes());
  rates.name = "kinematics_and_accelerations";
  rates.outputs = sums;
  rates.n_out = static_cast<Index>(size);
  program.functions = {rates};
  return emitted(std::move(program), scene);
}

}  // namespace kanec::test
