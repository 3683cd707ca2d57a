// The tables of a derivation as the source prints them, block by block, in plain text or LaTeX. Not: code.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "generator/symbolic/equations.hpp"
#include "generator/symbolic/notation.hpp"

namespace kanec::emit {

// A row: left side and right side, "v_3" and "sdot1 + ...".
using Row = std::pair<std::string, std::string>;

struct Table {
  std::string title;
  std::vector<Row> rows;
};

// Connection array, u(K), state vectors with their sizes, kinematical equations, rotations, links, positions,
// velocities, partial (angular) velocities and their time derivatives (block by block without those that are 0, then
// one matrix a link with them), A and f. A table without rows is left out.
std::vector<Table> tables(const symbolic::Equations& equations, symbolic::Style style);

std::string text_document(const symbolic::Equations& equations);
// Compiles with pdflatex as it is.
std::string latex_document(const symbolic::Equations& equations);

}  // namespace kanec::emit
