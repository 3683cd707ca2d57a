// Numbers as shortest exact text, names as C++ allows them, and the nearest known name. Not here: formatting of tables.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kanec {

// Shortest decimal that reads back as the same double, independent of the locale: "0.1", "1e-300", "2".
std::string shortest(double value);

// The number that the whole text is; none where it is no number, or no finite one.
std::optional<double> finite_number(const std::string& text);

// A C++ identifier in ASCII that is no keyword, has no leading or double underscore, and at most 63 characters.
bool is_identifier(std::string_view name);

// The known name with the smallest edit distance, or "" when nothing is near (distance over a third of the length).
std::string nearest(std::string_view name, const std::vector<std::string>& known);

}  // namespace kanec
