// Names and equations of one body made those of any: omega7 = E7 omega6 becomes omegaK = EK omegaL. Not: which bodies a
// section reads (section_text.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace kanec::emit {

// By body number.
using Letters = std::map<int, std::string>;

// Of a name with the number of a body and perhaps of an entry, the former: "eps7_2" becomes "epsK_2".
std::string lettered_name(const std::string& name, const Letters& letters);

// Of an equation, every number right behind a letter or underscore.
std::string lettered_equation(const std::string& equation, const Letters& letters);

}  // namespace kanec::emit
