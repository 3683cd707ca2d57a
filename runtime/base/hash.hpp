// A short fingerprint of a text. Not a defence: whoever must be certain compares the texts themselves.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace kanec {

// FNV-1a, 64 bit, as 16 lower-case hexadecimal digits (Fowler, Noll, Vo; RFC 9923).
std::string fingerprint(std::string_view text);

}  // namespace kanec
