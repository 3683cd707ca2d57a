// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/states/npy.hpp"

#include <charconv>
#include <cstring>
#include <optional>
#include <vector>

#include "runtime/base/error.hpp"

namespace kanec {
namespace {

constexpr std::string_view npy_magic("\x93NUMPY", 6);
constexpr auto npy_rule = "a table of float64 or float32, little endian";

[[noreturn]] void refuse_npy(const FileReader& file, const std::string& found, const std::string& allowed = npy_rule) {
  throw InputError(file.name() + ": found " + found + "; allowed: " + allowed);
}

// The text behind "'key':" in the header's dictionary, up to what ends a value there.
std::string_view npy_value(const FileReader& file, std::string_view header, const std::string& key) {
  const std::string mark = "'" + key + "':";
  const std::size_t at = header.find(mark);
  if (at == header.npos) refuse_npy(file, "an .npy header without " + key);
  std::string_view value = header.substr(at + mark.size());
  while (!value.empty() && value.front() == ' ') value.remove_prefix(1);
  const std::size_t end = value.starts_with('(') ? value.find(')') + 1 : value.find_first_of(",}");
  return value.substr(0, end);
}

std::vector<std::int64_t> npy_shape(const FileReader& file, std::string_view text) {
  std::vector<std::int64_t> shape;
  for (std::size_t at = 1; at < text.size();) {
    const std::size_t begin = text.find_first_of("0123456789", at);
    if (begin == text.npos) break;
    std::int64_t extent = 0;
    const auto [end, error] = std::from_chars(text.data() + begin, text.data() + text.size(), extent);
    constexpr std::int64_t most_rows = std::int64_t{1} << 40, most_columns = 1 << 20;
    if (error != std::errc() || extent > (shape.empty() ? most_rows : most_columns))
      refuse_npy(file, "an .npy shape " + std::string(text));
    shape.push_back(extent);
    at = static_cast<std::size_t>(end - text.data());
  }
  return shape;
}

std::size_t header_length(FileReader& file, char version) {
  const std::string_view bytes = file.bytes(version == 1 ? 2 : 4);
  std::size_t length = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) length = length << 8 | static_cast<unsigned char>(bytes[i]);
  if (length > (1u << 20))
    refuse_npy(file, "an .npy header of " + std::to_string(length) + " bytes", "one of at most 1 MiB");
  return length;
}

}  // namespace

NpyTable read_npy_header(FileReader& file) {
  const std::string start(file.bytes(8));
  if (start.size() < 8 || !std::string_view(start).starts_with(npy_magic))
    refuse_npy(file, "no .npy file", "NumPy's .npy");
  if (start[6] < 1 || start[6] > 3) refuse_npy(file, "an .npy file of version " + std::to_string(start[6]), "1 to 3");
  const std::size_t length = header_length(file, start[6]);
  const std::string header(file.bytes(length));
  if (header.size() < length) refuse_npy(file, "an .npy file that ends in its header");
  const std::string_view kind = npy_value(file, header, "descr"), order = npy_value(file, header, "fortran_order");
  if (kind != "'<f8'" && kind != "'<f4'") refuse_npy(file, "numbers of the kind " + std::string(kind.substr(0, 40)));
  const std::vector<std::int64_t> shape = npy_shape(file, npy_value(file, header, "shape"));
  if (shape.empty() || shape.size() > 2)
    refuse_npy(file, "an array of " + std::to_string(shape.size()) + " dimensions", "one (a column) or two");
  NpyTable table{shape[0], shape.size() == 2 ? shape[1] : 1, kind == "'<f8'" ? 8 : 4, order == "True",
                 8 + (start[6] == 1 ? 2u : 4u) + length};
  const std::size_t wanted = table.begin + static_cast<std::size_t>(table.rows) *
                                               static_cast<std::size_t>(table.columns) *
                                               static_cast<std::size_t>(table.number_size);
  if (file.is_regular() && file.size() != wanted)
    refuse_npy(file, std::to_string(file.size()) + " bytes", std::to_string(wanted) + ", which its header announces");
  return table;
}

std::string npy_header(std::int64_t rows, std::int64_t columns) {
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(rows) + ", " +
                       std::to_string(columns) + "), }";
  const std::size_t unpadded = 10 + header.size() + 1;
  header += std::string((64 - unpadded % 64) % 64, ' ') + "\n";
  return std::string(npy_magic) + '\x01' + '\0' + static_cast<char>(header.size() & 0xff) +
         static_cast<char>(header.size() >> 8) + header;
}

}  // namespace kanec
