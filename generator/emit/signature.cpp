// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/signature.hpp"

#include <utility>

namespace kanec::emit {

using program::Group;

Reads reads(const program::Program& program, const program::Function& function) {
  const std::vector<bool> alive = reachable(program, function.outputs);
  Reads result;
  for (std::size_t i = 0; i < alive.size(); ++i) {
    const auto* variable = std::get_if<program::Variable>(&program.nodes[i]);
    if (!alive[i] || variable == nullptr) continue;
    result.prepared |= variable->group == Group::parameter;
    result.time |= variable->group == Group::time;
    result.x |= variable->group == Group::x;
    result.y |= variable->group == Group::y;
    result.ydot |= variable->group == Group::ydot;
    result.inputs |= variable->group == Group::input;
  }
  return result;
}

ArgumentList::ArgumentList(const program::Program& program, const program::Function& function, bool has_inputs,
                           Syntax syntax)
    : results_(results(function)), reads_(reads(program, function)), syntax_(std::move(syntax)) {
  const program::Signature& signature = function.signature;
  takes_ = {true,
            reads_.time,
            signature.x || reads_.x,
            signature.y || reads_.y,
            signature.ydot || reads_.ydot,
            reads_.inputs || (signature.inputs && has_inputs)};
}

ArgumentList::List ArgumentList::list(const Reads& read, bool any_unused) const {
  List list;
  const auto append = [&](bool wanted, bool is_read, const std::string& name, const std::string& parameter) {
    if (!wanted) return;
    list.text += (list.text.empty() ? "" : ", ") + (is_read ? parameter : syntax_.maybe_unused(parameter));
    if (!is_read) list.unused.push_back(name);
  };
  const std::string entry = syntax_.scalar(), entries = "const " + entry + "* ";
  append(takes_.prepared, read.prepared, "c", syntax_.given(syntax_.type("Prepared"), "c"));
  append(takes_.time, read.time, "t", entry + " t");
  append(takes_.x, read.x, "x", entries + "x");
  append(takes_.y, read.y, "y", entries + "y");
  append(takes_.ydot, read.ydot, "ydot", entries + "ydot");
  append(takes_.inputs, read.inputs, "u", syntax_.given(syntax_.type("Inputs"), "u"));
  for (const program::Result& result : results_)
    append(true, !any_unused && result.count > 0, result.out, entry + "* " + result.out);
  return list;
}

std::string ArgumentList::front(const std::string& prepared, const std::string& inputs) const {
  std::string text = prepared;
  if (takes_.time) text += ", t";
  if (takes_.x) text += ", x";
  if (takes_.y) text += ", y";
  if (takes_.ydot) text += ", ydot";
  if (takes_.inputs) text += ", " + inputs;
  return text;
}

std::string ArgumentList::values(const std::string& prepared, const std::string& inputs) const {
  std::string text = front(prepared, inputs);
  for (const program::Result& result : results_) text += ", " + result.out;
  return text;
}

std::string ArgumentList::values(const std::string& prepared, const std::string& inputs, const std::string& out) const {
  std::string text = front(prepared, inputs);
  program::Index first = 0;
  for (const program::Result& result : results_) {
    text += ", " + out + (first == 0 ? "" : " + " + std::to_string(first));
    first += result.count;
  }
  return text;
}

}  // namespace kanec::emit
