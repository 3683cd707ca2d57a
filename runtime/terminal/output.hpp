// Standard output that notices when nobody gets it, and remarks on standard error. Not: files, which runtime/base
// writes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "runtime/text/json.hpp"

namespace kanec {

// Standard descriptors that the caller closed are given a place, so that no file opened later is taken for them.
// Writing to a closed standard output fails, as it should.
void guard_standard_streams();

// To standard output, at once. Throws FileError (closed, disk full).
void print(std::string_view text);

// The output option that stands for standard output.
bool is_standard_output(const std::string& path);

// A report for people: to standard output, or, where that is taken by a product, to standard error.
void report(std::string_view text, bool output_is_taken);

// JSON to standard output. Throws FileError.
void print_json(const Json& json);

// "kanec: <text>" on standard error, on one line; a failure there is nobody's.
void remark(std::string_view text);

// The same with the line feeds that the text has: another program's words.
void remark_lines(std::string_view text);

}  // namespace kanec
