// What a scene says of its bodies and loads, as tables of several columns beside its equations. Not: the equations
// themselves (tables.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/symbolic/equations.hpp"
#include "generator/symbolic/notation.hpp"

namespace kanec::emit {

// A column's head, and its share of the line in LaTeX.
struct Column {
  std::string head;
  double share = 0;
};

struct Grid {
  std::string title, note;
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> lines;  // a cell a column
};

// Its lines, with the cells left empty that say again whose line and where the line above has said it.
std::vector<std::vector<std::string>> without_repetition(const Grid& grid);

// Number, name, joint and coordinates of each body, by the names that the scene's expressions take.
Grid body_grid(const symbolic::Equations& equations, symbolic::Style style);

// One line a number of each load: name, where it acts and in whose axes, letter, what the scene says it is, its value
// at the start with the defaults of parameters and inputs, unit. No line: the scene has no loads.
Grid load_grid(const symbolic::Equations& equations, symbolic::Style style);

}  // namespace kanec::emit
