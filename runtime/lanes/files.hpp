// The headers of this folder as they are put beside a batch that is compiled. Not: the batch (generator/emit).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace kanec {

// File names and texts; they include each other, and abi.h, by bare name.
std::vector<std::pair<std::string, std::string>> lane_files();

// The text of cos_sin.hpp, of which emitted headers hold a part.
std::string cos_sin_text();

// For the compiler: the scalar, "double" or "float"; lanes, 0 for as many as the target has; and multiply-adds fused as
// in scalar code, which Clang would not do across the operators of a class.
std::vector<std::string> lane_flags(const std::string& scalar, int lanes);

}  // namespace kanec
