// A folder of compiled models, one entry a key, shared by all processes of one user. Not: how a model is compiled or
// loaded.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "runtime/base/temporary.hpp"
#include "runtime/compile/entry.hpp"
#include "runtime/compile/lock.hpp"

namespace kanec::compile {

// $KANEC_CACHE, else $XDG_CACHE_HOME/kanec, else $HOME/.cache/kanec, else kanec-<uid> in the system's temporary folder.
// Of the latter two variables only absolute paths count.
std::filesystem::path default_cache();

// Layout: <folder>/<entry>/{model.so, key, seal}, <folder>/answers/ for short texts, and <folder>/tmp/ for what is not
// finished. An entry is made
// elsewhere and renamed into place, so it is there whole or not at all; what damage it takes later is found before it
// is used. Whoever can write to a library runs code as us: folders and files must be our user's and writable by nobody
// else, also where the folder is so now, for what it holds may be from a time when it was not.
class Cache {
 public:
  // The model's name and the key's fingerprint name the entry.
  struct Place {
    std::string entry;
    std::string key;
  };
  static Place place(const std::string& model, std::string key);

  // Creates the folder with rights for its owner alone, and clears away what dead processes left. Throws FileError when
  // it cannot be, or when another one may be put in its place (trusted_folder.hpp), InputError when it belongs to or
  // may be written by somebody else.
  explicit Cache(const std::filesystem::path& folder);

  Finding find(const Place& place) const;

  // Held while an entry is made, so that a second process waits for it instead of making it as well.
  Lock lock(const Place& place, const Waiting& waiting = {}) const;

  // Where to make an entry. Throws FileError.
  TemporaryFolder workplace(const Place& place) const;

  // Moves `made`, a folder below the workplace that holds model.so, into its place; the library's new path. Where
  // another process was faster its equal is kept. Throws FileError, also where a foreign entry is in the way.
  std::filesystem::path store(const std::filesystem::path& made, const Place& place) const;

  // A short text that is kept for what is told apart by `question`, all of it compared: "" where none is.
  std::string recall(const std::string& question) const;
  // Only a saving: where it cannot be kept nothing happens.
  void remember(const std::string& question, const std::string& answer) const;

  // Removes an entry that turned out to be of no use. Throws FileError.
  void discard(const Place& place) const;

 private:
  void clear() const;
  // Made where they are not there; throw FileError.
  std::filesystem::path subfolder(const char* name) const;
  std::filesystem::path temporary() const { return subfolder("tmp"); }

  std::filesystem::path folder_;
};

// Removes from `folder` all that is our user's and used by nobody: lock files and folders of processes that ended
// without doing so.
void sweep(const std::filesystem::path& folder);

}  // namespace kanec::compile
