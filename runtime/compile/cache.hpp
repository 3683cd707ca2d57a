// A folder of compiled models, one entry a key, shared by all processes of one user. Not: how a model is compiled or
// loaded.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "runtime/compile/lock.hpp"

namespace kanec::compile {

// $KANEC_CACHE, else $XDG_CACHE_HOME/kanec, else $HOME/.cache/kanec, else kanec-<uid> in the system's temporary folder.
// Of the latter two variables only absolute paths count.
std::filesystem::path default_cache();

// Layout: <folder>/<entry>/{model.so, key, seal}, and <folder>/tmp/ for what is not finished. An entry is made
// elsewhere and renamed into place, so it is there whole or not at all; what damage it takes later is found before it
// is used.
class Cache {
 public:
  // The model's name and the key's fingerprint name the entry.
  struct Place {
    std::string entry;
    std::string key;
  };
  static Place place(const std::string& model, std::string key);

  // Creates the folder with rights for its owner alone. Throws FileError when it cannot be, InputError when it belongs
  // to or may be written by somebody else: whoever writes there could run code as us.
  explicit Cache(const std::filesystem::path& folder);

  // The library of that very key, byte for byte as it was stored; empty for anything else.
  std::optional<std::filesystem::path> find(const Place& place) const;

  // Held while an entry is made, so that a second process waits for it instead of making it as well.
  Lock lock(const Place& place) const;

  // Where to make an entry. Also clears away what interrupted processes left. Throws FileError.
  TemporaryFolder workplace(const Place& place) const;

  // Moves `made`, a folder below the workplace that holds model.so, into its place; the library's new path. Where
  // another process was faster its equal is kept. Throws FileError.
  std::filesystem::path store(const std::filesystem::path& made, const Place& place) const;

  // Removes an entry that turned out to be of no use. Throws FileError.
  void discard(const Place& place) const;

 private:
  std::filesystem::path folder_;
};

// The library's name in an entry and where it is made.
inline constexpr char library_name[] = "model.so";

}  // namespace kanec::compile
