// Everything that decides what a compiled model is, as one text. Not: where it is kept.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/compile/compiler.hpp"
#include "runtime/compile/source.hpp"

namespace kanec::compile {

// ABI version, all source texts with abi.h (before they are made, what they follow from), the compiler (path, file
// behind it, version), flags, the environment that compilers heed, and the processor that -march=native means. Two
// builds may share a library only if their keys are equal.
std::string cache_key(const Source& source, const Compiler& compiler, const std::vector<std::string>& flags);

// Path, size and time of the file that a path leads to; the path alone where there is none.
std::string file_behind(const std::filesystem::path& path);

// The lines of /proc/cpuinfo that name the first processor's kind and abilities; its clock rates and the like are left
// out.
std::string processor(std::string_view cpuinfo);

}  // namespace kanec::compile
