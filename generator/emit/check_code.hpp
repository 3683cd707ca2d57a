// Emitted code read again before anybody gets it: every name is declared once in its scope, and before its use. Not:
// C++ as such; the compiler reads that.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kanec::emit {

// code: whole declarations. around: names that they may use besides their own, such as the structs of the model.
// Between the pieces of a long function what one of them reads of `shared` another one before it must have set, once.
// Throws InternalError that tells the name: a fault of the generator.
void check_code(std::string_view code, const std::vector<std::string>& around);

}  // namespace kanec::emit
