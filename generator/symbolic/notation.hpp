// Block expressions as people write them, in plain text or LaTeX. Not: tables or documents (generator/emit).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/symbolic/symbols.hpp"

namespace kanec::symbolic {

enum class Style { text, latex };

// "R1^T (q2 + s2)~", "-R1^T r1~"; in LaTeX "-R_{1}^{T}\tilde{r}_{1}".
std::string notation(const GiNaC::ex& e, const SymbolTable& table, Style style);

// A letter for something that the scene names: "\tau_{\text{motor}}"; `more` behind the name: ",#".
std::string latex_named(const std::string& letter, const std::string& name, const std::string& more = "");

// The index that LaTeX prints for a suffix: "4,1" for "4_1", "3,2" for "3_2_".
std::string latex_index(const std::string& suffix);

}  // namespace kanec::symbolic
