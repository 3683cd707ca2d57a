// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/signature.hpp"

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

ArgumentList::ArgumentList(const program::Program& program, const program::Function& function, bool has_inputs)
    : results_(results(function)), reads_(reads(program, function)) {
  const program::Signature& signature = function.signature;
  takes_ = {true,
            reads_.time,
            signature.x || reads_.x,
            signature.y || reads_.y,
            signature.ydot || reads_.ydot,
            reads_.inputs || (signature.inputs && has_inputs)};
}

std::string ArgumentList::list(const Reads& read, bool any_unused) const {
  std::string text;
  const auto append = [&text](bool wanted, bool is_read, const std::string& parameter) {
    if (wanted) text += (text.empty() ? "" : ", ") + std::string(is_read ? "" : "[[maybe_unused]] ") + parameter;
  };
  append(takes_.prepared, read.prepared, "const Prepared<T>& c");
  append(takes_.time, read.time, "T t");
  append(takes_.x, read.x, "const T* x");
  append(takes_.y, read.y, "const T* y");
  append(takes_.ydot, read.ydot, "const T* ydot");
  append(takes_.inputs, read.inputs, "const Inputs<T>& u");
  for (const program::Result& result : results_) append(true, !any_unused && result.count > 0, "T* " + result.out);
  return text;
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
