// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/bench/code_size.hpp"

#include <elf.h>

#include <cstring>
#include <string_view>
#include <vector>

#include "runtime/base/files.hpp"

namespace kanec {
namespace {

// Copies of `count` entries at `offset`; none where they do not lie within the file.
template <class Entry>
std::vector<Entry> entries(std::string_view file, std::size_t offset, std::size_t count) {
  if (offset > file.size() || count > (file.size() - offset) / sizeof(Entry)) return {};
  std::vector<Entry> list(count);
  if (count > 0) std::memcpy(list.data(), file.data() + offset, count * sizeof(Entry));
  return list;
}

struct Symbol {
  std::string name;
  std::size_t size;
};

// The functions and tables of a section of symbols, whose names stand in the section `text`.
std::vector<Symbol> symbols(std::string_view file, const Elf64_Shdr& table, const Elf64_Shdr& text) {
  const std::vector<char> names = entries<char>(file, text.sh_offset, text.sh_size);
  std::vector<Symbol> list;
  for (const Elf64_Sym& symbol : entries<Elf64_Sym>(file, table.sh_offset, table.sh_size / sizeof(Elf64_Sym))) {
    const auto type = ELF64_ST_TYPE(symbol.st_info);
    if ((type != STT_FUNC && type != STT_OBJECT) || symbol.st_name >= names.size()) continue;
    const char* name = names.data() + symbol.st_name;
    list.push_back({std::string(name, ::strnlen(name, names.size() - symbol.st_name)), symbol.st_size});
  }
  return list;
}

std::vector<Symbol> symbols(std::string_view file) {
  const auto header = entries<Elf64_Ehdr>(file, 0, 1);
  if (header.empty() || std::memcmp(header[0].e_ident, ELFMAG, SELFMAG) != 0 ||
      header[0].e_ident[EI_CLASS] != ELFCLASS64)
    return {};
  const auto sections = entries<Elf64_Shdr>(file, header[0].e_shoff, header[0].e_shnum);
  for (const Elf64_Shdr& section : sections)
    if (section.sh_type == SHT_SYMTAB && section.sh_link < sections.size())
      return symbols(file, section, sections[section.sh_link]);
  return {};
}

// Whether the mangled name is of `function`, emitted or as the ABI has it, or of its pieces or sections.
bool is_of(const std::string& mangled, const std::string& function) {
  for (const char* ending : {"", "_pieces", "_sections"}) {
    const std::string name = function + ending, part = std::to_string(name.size()) + name;
    const std::size_t at = mangled.find(part);
    if (at != mangled.npos && mangled.find_first_of("EI0123456789", at + part.size()) == at + part.size()) return true;
  }
  return false;
}

}  // namespace

std::optional<std::size_t> code_bytes(const compile::Model& model, const std::string& function) {
  std::size_t bytes = 0;
  for (const Symbol& symbol : symbols(read_file(model.library(), any_size)))
    if (is_of(symbol.name, function)) bytes += symbol.size;
  return bytes > 0 ? std::optional(bytes) : std::nullopt;
}

}  // namespace kanec
