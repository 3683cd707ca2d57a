// What is wrong with a LaTeX document as far as its characters tell, without TeX. Not: how it looks.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace kanec::test {

// Braces, dollars and environments that do not match; two subscripts or superscripts on one letter, empty ones, ones on
// nothing or outside of formulas; commands behind \begin{document} that are none of those of kanec's documents; other
// characters than printable ASCII. Each with what stands around it; empty: nothing is wrong.
std::vector<std::string> latex_faults(const std::string& document);

}  // namespace kanec::test
