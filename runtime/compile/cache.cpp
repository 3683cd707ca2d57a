// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/cache.hpp"

#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/hash.hpp"

namespace kanec::compile {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes patience{2};  // for another process that makes the same entry

fs::path variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

// The folder and all that are missing above it, for their owner alone.
void create_private(const fs::path& path) {
  int error = ::mkdir(path.c_str(), 0700) == 0 ? 0 : errno;
  if (error == ENOENT && path.has_relative_path()) {
    create_private(path.parent_path());
    error = ::mkdir(path.c_str(), 0700) == 0 ? 0 : errno;
  }
  std::error_code ignored;
  if (error == 0 || (error == EEXIST && fs::is_directory(path, ignored))) return;
  throw FileError(path.string(), std::strerror(error == EEXIST ? ENOTDIR : error));
}

void refuse(const fs::path& path, const std::string& why) {
  throw InputError(path.string() + ": not used as the model cache, because " + why +
                   "; change that or name another folder in KANEC_CACHE");
}

void require_private(const fs::path& path) {
  struct stat link {};
  struct stat folder {};
  if (::lstat(path.c_str(), &link) != 0 || ::stat(path.c_str(), &folder) != 0)
    throw FileError(path.string(), std::strerror(errno));
  if (link.st_uid != ::geteuid() || folder.st_uid != ::geteuid()) refuse(path, "it belongs to another user");
  if ((folder.st_mode & (S_IWGRP | S_IWOTH)) != 0) refuse(path, "others may write to it (chmod go-w)");
}

std::string seal(const std::string& library) {
  return std::to_string(library.size()) + " " + fingerprint(library) + "\n";
}

}  // namespace

fs::path default_cache() {
  if (const fs::path own = variable("KANEC_CACHE"); !own.empty()) return fs::absolute(own);
  if (const fs::path xdg = variable("XDG_CACHE_HOME"); xdg.is_absolute()) return xdg / "kanec";
  if (const fs::path home = variable("HOME"); home.is_absolute()) return home / ".cache" / "kanec";
  return temporary_root() / ("kanec-" + std::to_string(::geteuid()));
}

Cache::Place Cache::place(const std::string& model, std::string key) {
  return {model + "-" + fingerprint(key), std::move(key)};
}

Cache::Cache(const fs::path& folder) : folder_(fs::absolute(folder)) {
  create_private(folder_);
  require_private(folder_);
}

std::optional<fs::path> Cache::find(const Place& place) const {
  const fs::path entry = folder_ / place.entry;
  try {
    if (read_file(entry / "key", any_size) != place.key) return std::nullopt;
    if (read_file(entry / "seal") != seal(read_file(entry / library_name, any_size))) return std::nullopt;
    return entry / library_name;
  } catch (const FileError&) {
    return std::nullopt;
  }
}

Lock Cache::lock(const Place& place) const {
  try {
    create_private(folder_ / "tmp");
  } catch (const FileError&) {
    return {};
  }
  return Lock(folder_ / "tmp" / (place.entry + ".lock"), patience);
}

TemporaryFolder Cache::workplace(const Place& place) const {
  create_private(folder_ / "tmp");
  sweep(folder_ / "tmp");
  return TemporaryFolder(folder_ / "tmp" / place.entry);
}

fs::path Cache::store(const fs::path& made, const Place& place) const {
  const fs::path entry = folder_ / place.entry;
  write_file(made / "key", place.key);
  write_file(made / "seal", seal(read_file(made / library_name, any_size)));
  while (::rename(made.c_str(), entry.c_str()) != 0) {
    const int error = errno;
    if (error != EEXIST && error != ENOTEMPTY && error != ENOTDIR)
      throw FileError(entry.string(), std::strerror(error));
    if (const auto equal = find(place)) return *equal;
    discard(place);
  }
  return entry / library_name;
}

void Cache::discard(const Place& place) const {
  const fs::path entry = folder_ / place.entry;
  const TemporaryFolder bin(folder_ / "tmp" / place.entry);
  if (::rename(entry.c_str(), (bin.path() / "old").c_str()) != 0 && errno != ENOENT)
    throw FileError(entry.string(), std::strerror(errno));
}

}  // namespace kanec::compile
