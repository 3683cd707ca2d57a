// Text of the runtime's that travels with emitted code. Not: the texts.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace kanec::emit {

// What stands between the first and the last line of dashes.
inline std::string between_marks(const std::string& file) {
  const std::string mark = "// --------\n";
  const std::size_t begin = file.find(mark) + mark.size();
  return file.substr(begin, file.rfind(mark) - begin);
}

}  // namespace kanec::emit
