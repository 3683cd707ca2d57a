// Letters of the scene as program values: entries of the state, numbers, expressions. Not: named quantities
// (lower.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/lower/block.hpp"
#include "generator/program/derivative.hpp"
#include "generator/symbolic/equations.hpp"

namespace kanec::lower {

class Data {
 public:
  Data(const symbolic::Equations& equations, Builder& builder) : scene_(equations.scene), builder_(builder) {}

  Block of(const symbolic::Symbol& symbol);
  // An expression of the scene, or its time derivative of first or second order.
  Ref expression(int index, int order);

 private:
  Block state(program::Group group, const symbolic::Symbol& symbol);
  Ref value(const scene::Number& number);
  Ref value(const scene::Expression& expression);
  Ref value(const scene::ExpressionNode& node, Ref a, Ref b);
  Ref call(scene::Call call, Ref a, Ref b);
  Ref rate(Ref of);

  const scene::Scene& scene_;
  Builder& builder_;
  std::vector<std::vector<Ref>> expressions_;  // by index: value and the rates made so far
};

}  // namespace kanec::lower
