// Lines of comma-separated values in their cells. Not: what the columns are.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace kanec {

// Without blanks, tabs and carriage returns at its ends.
std::string_view trimmed(std::string_view text);

// Each trimmed.
std::vector<std::string_view> csv_cells(std::string_view line);

// "theta_1" of "theta_1[rad]".
std::string_view without_unit(std::string_view cell);

// The finite number that the whole cell is.
std::optional<double> csv_number(std::string_view cell);

// Whether a line holds cells: not where it is empty or begins with #.
bool is_csv_row(std::string_view trimmed_line);

}  // namespace kanec
