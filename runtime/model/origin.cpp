// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/origin.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <cstring>
#include <string_view>

#include "runtime/base/text.hpp"
#include "runtime/model/scene_text.hpp"

namespace kanec {
namespace {

struct BuildId {
  std::uintptr_t inside;  // an address in the object that is looked for
  std::string id;
};

std::uintptr_t padded(std::uintptr_t size) { return (size + 3) / 4 * 4; }

// The note "GNU" of type NT_GNU_BUILD_ID among these, in hexadecimal digits.
std::string id_among(const char* notes, std::size_t size) {
  for (std::size_t at = 0; at + sizeof(ElfW(Nhdr)) <= size;) {
    ElfW(Nhdr) note{};
    std::memcpy(&note, notes + at, sizeof(note));
    const char* name = notes + at + sizeof(note);
    const char* bytes = name + padded(note.n_namesz);
    if (note.n_type == NT_GNU_BUILD_ID && std::string_view(name, note.n_namesz) == std::string_view("GNU", 4)) {
      std::string id;
      for (std::size_t i = 0; i < note.n_descsz; ++i) id += fmt::format("{:02x}", static_cast<unsigned char>(bytes[i]));
      return id;
    }
    at += sizeof(note) + padded(note.n_namesz) + padded(note.n_descsz);
  }
  return "";
}

int look(dl_phdr_info* object, std::size_t, void* wanted) {
  auto& build = *static_cast<BuildId*>(wanted);
  bool is_it = false;
  std::string id;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = object->dlpi_phdr[i];
    const std::uintptr_t begin = object->dlpi_addr + part.p_vaddr;
    if (part.p_type == PT_LOAD) is_it = is_it || (build.inside >= begin && build.inside < begin + part.p_memsz);
    if (part.p_type == PT_NOTE && id.empty()) id = id_among(reinterpret_cast<const char*>(begin), part.p_memsz);
  }
  if (is_it) build.id = id;
  return is_it ? 1 : 0;
}

// Of the program or library that holds this code.
const std::string& build_id() {
  static const std::string id = [] {
    BuildId build{reinterpret_cast<std::uintptr_t>(&build_id), ""};
    ::dl_iterate_phdr(&look, &build);
    return build.id;
  }();
  return id;
}

std::string numbers_of(const scene::Joint& joint) {
  std::string text;
  const auto add = [&text](double value) { text += shortest(value) + " "; };
  for (const auto* list : {&joint.turns, &joint.slides})
    for (const scene::Coordinate& coordinate : *list)
      for (const double entry : coordinate.axis) add(entry);
  for (const auto& row : joint.zero)
    for (const double entry : row) add(entry);
  return text + "\n";
}

}  // namespace

std::string origin_of(const scene::Scene& scene, const GenerateOptions& options) {
  if (build_id().empty()) return "";
  std::string text = fmt::format("kanec {}, build {}\n", version(), build_id());
  for (const std::string& function : options.functions) text += function + " ";
  text += fmt::format("\nalgorithm {}, optimize {}, longest line {}, taylor {}\n",
                      options.algorithm ? static_cast<int>(*options.algorithm) : -1, static_cast<int>(options.optimize),
                      options.longest_line, options.with_taylor);
  const emit::Lengths& lengths = options.lengths;
  text += fmt::format("lengths {} {}\n", lengths.whole, lengths.piece);
  scene::Scene bare = scene;
  bare.simulation = {};
  bare.ensemble = {};
  text += scene_text(bare);
  for (const scene::Body& body : scene.bodies) text += numbers_of(body.joint);  // which text gives to rounding alone
  return text;
}

}  // namespace kanec
