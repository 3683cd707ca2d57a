// The equations of motion as a notebook shows them. Not: the document (Scene::derive).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace kanec::python {

// A, f and the letters that they need, out of derive("latex"), as one display that MathJax and KaTeX render; at most so
// many rows.
std::string display_of(const std::string& document, int most_rows);

}  // namespace kanec::python
