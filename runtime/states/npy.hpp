// The header of NumPy's .npy files (format versions 1 to 3): a table of numbers. Not: what its columns are.
// Source: numpy.lib.format.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "runtime/states/file_reader.hpp"

namespace kanec {

struct NpyTable {
  std::int64_t rows = 0, columns = 1;
  int number_size = 8;  // float64 or float32, little endian
  bool by_columns = false;
  std::size_t begin = 0;  // of the numbers in the file
};

// Reads it off the front. Throws InputError that names the file and what is wrong; of a regular file also where the
// numbers that it announces are not there, or more than these.
NpyTable read_npy_header(FileReader& file);

// Of float64, row by row.
std::string npy_header(std::int64_t rows, std::int64_t columns);

}  // namespace kanec
