// Rows of text in aligned columns. Not: what stands in them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace kanec {

using TextRow = std::vector<std::string>;

// Two blanks between columns. `alignment` has a letter a column, l or r, of which the last holds for the rest too.
std::string text_table(const std::vector<TextRow>& rows, const std::string& alignment = "lr");

// "| a | b |", with a line feed.
std::string markdown_row(const TextRow& row);

}  // namespace kanec
