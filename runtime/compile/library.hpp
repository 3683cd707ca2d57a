// A model's shared library, loaded and compared with what it should be. Not: where it comes from.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "runtime/abi/abi.h"
#include "runtime/base/descriptor.hpp"
#include "runtime/compile/source.hpp"

namespace kanec::compile {

class Library {
 public:
  // Loads the file and checks its descriptors: ABI version and size, hash, nx, ny. Throws LoadError. The file must be
  // whole: a truncated one may kill the process. Where `looked_at` is open, `path` must still lead to that file: it is
  // loaded by its path all the same, because the loader takes one name for one library, as debuggers do, and
  // /proc/self/fd/N is many; nobody else can put another file there (trusted_folder.hpp).
  Library(const std::filesystem::path& path, const Source& expected, const Descriptor& looked_at = Descriptor());
  // Loads a file whose model is not known: ABI version and size are checked. Throws FileError where it is not there or
  // not whole, LoadError.
  explicit Library(const std::filesystem::path& path);
  const kanec_model& model() const { return *model_; }
  bool is_batch() const { return batch_ != nullptr; }
  const kanec_batch& batch() const;  // InternalError where there is none

 private:
  struct Close {
    void operator()(void* handle) const;
  };
  std::unique_ptr<void, Close> handle_;
  const kanec_model* model_ = nullptr;
  const kanec_batch* batch_ = nullptr;
};

}  // namespace kanec::compile
