// Block expressions as people write them, in plain text or LaTeX. Not: tables or documents (generator/emit).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/symbolic/symbols.hpp"

namespace kanec::symbolic {

enum class Style { text, latex };

// "R1^T (q2 + s2)~", "-R1^T r1~"; in LaTeX "-R_{1}^{T}\tilde{r}_{1}".
std::string notation(const GiNaC::ex& e, const SymbolTable& table, Style style);

}  // namespace kanec::symbolic
