// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/library.hpp"

#include <dlfcn.h>

#include <string>

#include "runtime/base/error.hpp"

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

// In this order: what follows the ABI version and size can only be read where these two are right.
void check(const kanec_model& model, const Source& expected) {
  require_equal(expected, "ABI version", model.abi_version, KANEC_ABI_VERSION);
  require_equal(expected, "descriptor size", model.struct_size, static_cast<std::uint32_t>(sizeof(kanec_model)));
  const std::string hash = model.hash != nullptr ? model.hash : "";
  if (hash != expected.hash) fail(expected, "hash is " + hash + ", expected " + expected.hash);
  require_equal(expected, "nx", model.nx, expected.nx);
  require_equal(expected, "ny", model.ny, expected.ny);
  if (model.prepare == nullptr || model.functions == nullptr) fail(expected, "descriptor without functions");
}

}  // namespace

void Library::Close::operator()(void* handle) const { ::dlclose(handle); }

Library::Library(const std::filesystem::path& path, const Source& expected)
    : handle_(::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)), model_(nullptr) {
  if (!handle_) fail(expected, last_error());
  const auto entry = reinterpret_cast<kanec_entry>(::dlsym(handle_.get(), KANEC_ENTRY));
  if (entry == nullptr) fail(expected, last_error());
  model_ = entry();
  if (model_ == nullptr) fail(expected, "no descriptor");
  check(*model_, expected);
}

}  // namespace kanec::compile
