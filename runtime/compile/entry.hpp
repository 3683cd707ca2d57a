// What stands in the place of an entry of the cache, looked at without trust. Not: where entries are, or what follows
// (cache.hpp, build.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "runtime/base/descriptor.hpp"

namespace kanec::compile {

// The library's name in an entry and where it is made.
inline constexpr char library_name[] = "model.so";

struct Finding {
  enum class Kind {
    sound,    // the library of that very key, byte for byte as it was stored
    none,     // nothing, or what is damaged, of another key or no regular file: to be replaced without a word
    exposed,  // our user's, but others may write there, so that it may be anybody's: not read, to be replaced
    foreign,  // another user's: not read, and not ours to remove
  };
  Kind kind = Kind::none;
  std::filesystem::path path = {};    // where sound the library, where exposed or foreign what is
  Descriptor library = Descriptor();  // where sound: the very file that was compared
  std::string what = {};              // where exposed or foreign: "belongs to another user (1001)"
};

// Opened without following links and without waiting, so that neither a link nor a pipe leads astray, and judged by
// owner and rights before a byte is read. No library is larger than 1 GiB.
Finding look_at(const std::filesystem::path& entry, const std::string& key);

// What makes `made`, a folder that holds model.so, a sound entry: key and seal beside it, writable by nobody else
// whatever the mask. Throws FileError.
void complete(const std::filesystem::path& made, const std::string& key);

}  // namespace kanec::compile
