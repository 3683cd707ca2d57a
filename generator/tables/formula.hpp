// The numbers and expressions of a scene as LaTeX formulas, in the letters of its equations. Not: blocks
// (symbolic/notation.hpp), nor expressions in plain text, which stand as written.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/scene/scene.hpp"

namespace kanec::emit {

// "k \cdot \max(0, -s_{2})^{3/2}"; parameters and inputs upright, by their names.
std::string latex_formula(const scene::Scene& scene, const scene::Expression& expression);

// "0.5", "10^{-3}".
std::string latex_number(double value);

// A name that the scene gives, upright: "\text{m\_payload}".
std::string latex_name(const std::string& name);

// The same outside of a formula: a line may end behind its underscores.
std::string latex_word(const std::string& name);

// A formula with places where its line may end: \brk before signs and behind commas, \brkin within parentheses and
// before signs within an entry of a matrix, \brkfac between factors. The document defines what they cost.
std::string latex_breaks(const std::string& formula);

}  // namespace kanec::emit
