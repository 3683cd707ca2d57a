// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/library.hpp"

#include <dlfcn.h>

#include <string>

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

// In this order: what follows the ABI version and size can only be read where these two are right.
void check(const kanec_model& model, const Source& expected) {
  require_equal(expected, "ABI version", model.abi_version, KANEC_ABI_VERSION);
  require_equal(expected, "descriptor size", model.struct_size, static_cast<std::uint32_t>(sizeof(kanec_model)));
  const std::string hash = model.hash != nullptr ? model.hash : "";
  if (!expected.hash.empty() && hash != expected.hash) fail(expected, "hash is " + hash + ", expected " + expected.hash);
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

}  // namespace

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
