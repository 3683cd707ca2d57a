// Any text as emitted code that is read again: it passes, or is told as an error of the generator. Not: which of these.
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>

#include "generator/emit/check_code.hpp"
#include "runtime/base/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    kanec::emit::check_code({reinterpret_cast<const char*>(data), size}, {});
  } catch (const kanec::InternalError&) {
  }
  return 0;
}
