// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/library.hpp"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "runtime/base/error.hpp"
#include "runtime/base/file_lock.hpp"

namespace kanec::compile {
namespace {

[[noreturn]] void fail(const Source& expected, const std::string& what) {
  throw LoadError("compiled model " + expected.name + ": " + what);
}

std::string last_error() {
  const char* text = ::dlerror();
  return text != nullptr ? text : "cause unknown";
}

template <class Value>
void require_equal(const Source& expected, const char* what, Value found, Value right) {
  if (found == right) return;
  fail(expected, std::string(what) + " is " + std::to_string(found) + ", expected " + std::to_string(right));
}

// What follows the ABI version and size can only be read where these two are right.
void check_version(const kanec_model& model, const Source& expected) {
  require_equal(expected, "ABI version", model.abi_version, KANEC_ABI_VERSION);
  require_equal(expected, "descriptor size", model.struct_size, static_cast<std::uint32_t>(sizeof(kanec_model)));
}

void check(const kanec_model& model, const Source& expected) {
  check_version(model, expected);
  const std::string hash = model.hash != nullptr ? model.hash : "";
  if (!expected.hash.empty() && hash != expected.hash)
    fail(expected, "hash is " + hash + ", expected " + expected.hash);
  require_equal(expected, "nx", model.nx, expected.nx);
  require_equal(expected, "ny", model.ny, expected.ny);
  if (model.functions == nullptr) fail(expected, "descriptor without functions");
  if (model.prepare == nullptr && !expected.is_batch) fail(expected, "descriptor without functions");
}

void check(const kanec_batch& batch, const Source& expected) {
  require_equal(expected, "ABI version", batch.abi_version, KANEC_ABI_VERSION);
  require_equal(expected, "batch descriptor size", batch.struct_size, static_cast<std::uint32_t>(sizeof(kanec_batch)));
  if (batch.model == nullptr || batch.prepare == nullptr || batch.evaluate == nullptr)
    fail(expected, "batch descriptor without functions");
}

// What the library's one exported function returns.
template <class Entry>
auto descriptor(void* library, const char* name, const Source& expected) {
  const auto entry = reinterpret_cast<Entry>(::dlsym(library, name));
  if (entry == nullptr) fail(expected, last_error());
  const auto* found = entry();
  if (found == nullptr) fail(expected, "no descriptor");
  return found;
}

// The loader maps what the headers announce: beyond the end of a file that was cut off, it is killed.
void require_whole(const std::filesystem::path& path) {
  std::error_code failed;
  const auto bytes = std::filesystem::file_size(path, failed);
  if (failed) throw FileError(path.string(), failed.message());
  std::ifstream file(path, std::ios::binary);
  ElfW(Ehdr) header{};
  if (!file.read(reinterpret_cast<char*>(&header), sizeof(header)) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0)
    throw FileError(path.string(), "no shared library");
  const std::uintmax_t sections = header.e_shoff + std::uintmax_t{header.e_shentsize} * header.e_shnum;
  std::uintmax_t end =
      std::max<std::uintmax_t>(sections, header.e_phoff + std::uintmax_t{header.e_phentsize} * header.e_phnum);
  file.seekg(static_cast<std::streamoff>(std::min<std::uintmax_t>(header.e_phoff, bytes)));
  for (int i = 0; i < header.e_phnum; ++i) {
    ElfW(Phdr) part{};
    if (!file.read(reinterpret_cast<char*>(&part), sizeof(part))) break;
    if (part.p_type == PT_LOAD) end = std::max<std::uintmax_t>(end, part.p_offset + part.p_filesz);
  }
  if (end > bytes) throw FileError(path.string(), "a shared library that was cut off");
}

}  // namespace

Library::Library(const std::filesystem::path& path) {
  require_whole(path);
  Source any;
  any.name = path.string();
  handle_.reset(::dlopen(std::filesystem::absolute(path).c_str(), RTLD_NOW | RTLD_LOCAL));
  if (!handle_) fail(any, last_error());
  any.is_batch = ::dlsym(handle_.get(), KANEC_BATCH_ENTRY) != nullptr;
  if (any.is_batch) {
    batch_ = descriptor<kanec_batch_entry>(handle_.get(), KANEC_BATCH_ENTRY, any);
    check(*batch_, any);
  }
  model_ = batch_ != nullptr ? batch_->model : descriptor<kanec_entry>(handle_.get(), KANEC_ENTRY, any);
  check_version(*model_, any);
}

void Library::Close::operator()(void* handle) const { ::dlclose(handle); }

Library::Library(const std::filesystem::path& path, const Source& expected, const Descriptor& looked_at) {
  if (looked_at && !leads_to(path, looked_at)) fail(expected, "another file stands at " + path.string() + " by now");
  handle_.reset(::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
  if (!handle_) fail(expected, last_error());
  if (expected.is_batch) {
    batch_ = descriptor<kanec_batch_entry>(handle_.get(), KANEC_BATCH_ENTRY, expected);
    check(*batch_, expected);
  }
  model_ = batch_ != nullptr ? batch_->model : descriptor<kanec_entry>(handle_.get(), KANEC_ENTRY, expected);
  check(*model_, expected);
}

const kanec_batch& Library::batch() const {
  if (batch_ == nullptr) throw InternalError("a compiled model is asked for a batch that its source does not have");
  return *batch_;
}

}  // namespace kanec::compile
