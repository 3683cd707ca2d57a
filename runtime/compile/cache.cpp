// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/cache.hpp"

#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include "runtime/base/error.hpp"
#include "runtime/base/file_lock.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/hash.hpp"
#include "runtime/compile/trusted_folder.hpp"

namespace kanec::compile {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes cache_patience{2};  // for another process that makes the same entry

fs::path path_variable(const char* name) {
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

void require_private(const fs::path& path) {
  if (const auto why = exposure(path))
    throw InputError(path.string() + ": not used as the model cache, because " + *why +
                     "; change that or name another folder in KANEC_CACHE");
}

}  // namespace

fs::path default_cache() {
  if (const fs::path own = path_variable("KANEC_CACHE"); !own.empty()) return fs::absolute(own);
  if (const fs::path xdg = path_variable("XDG_CACHE_HOME"); xdg.is_absolute()) return xdg / "kanec";
  if (const fs::path home = path_variable("HOME"); home.is_absolute()) return home / ".cache" / "kanec";
  return temporary_root() / ("kanec-" + std::to_string(::geteuid()));
}

Cache::Place Cache::place(const std::string& model, std::string key) {
  return {model + "-" + fingerprint(key), std::move(key)};
}

Cache::Cache(const fs::path& folder) : folder_(fs::absolute(folder)) {
  require_lasting_place(folder_);
  create_private(folder_);
  require_private(folder_);
  if (std::error_code ignored; fs::exists(folder_ / "tmp", ignored)) clear();
}

void Cache::clear() const {
  try {
    sweep(temporary());
  } catch (const FileError&) {  // told where it is needed
  }
}

fs::path Cache::subfolder(const char* name) const {
  fs::path path = folder_ / name;
  create_private(path);
  if (fs::is_symlink(path)) throw FileError(path.string(), "a link, where a folder belongs; remove it");
  if (const auto why = exposure(path)) throw FileError(path.string(), "not used, because " + *why + "; remove it");
  return path;
}

Finding Cache::find(const Place& place) const { return look_at(folder_ / place.entry, place.key); }

Lock Cache::lock(const Place& place, const Waiting& waiting) const {
  try {
    return Lock(temporary() / (place.entry + ".lock"), cache_patience, waiting);
  } catch (const FileError&) {
    return {};
  }
}

TemporaryFolder Cache::workplace(const Place& place) const { return TemporaryFolder(temporary() / place.entry); }

fs::path Cache::store(const fs::path& made, const Place& place) const {
  const fs::path entry = folder_ / place.entry;
  complete(made, place.key);
  while (::rename(made.c_str(), entry.c_str()) != 0) {
    const int error = errno;
    if (error != EEXIST && error != ENOTEMPTY && error != ENOTDIR)
      throw FileError(entry.string(), std::strerror(error));
    const Finding equal = find(place);
    if (equal.kind == Finding::Kind::sound) return equal.path;
    if (equal.kind == Finding::Kind::foreign) throw FileError(equal.path.string(), equal.what);
    discard(place);
  }
  return entry / library_name;
}

std::string Cache::recall(const std::string& question) const {
  try {
    constexpr std::size_t longest = 1 << 16;
    const fs::path path = folder_ / "answers" / fingerprint(question);
    if (!fs::exists(path) || !fs::is_regular_file(fs::symlink_status(subfolder("answers") / path.filename())))
      return "";
    const std::string text = read_file(path, longest);
    return text.rfind(question + "\n", 0) == 0 ? text.substr(question.size() + 1) : "";
  } catch (const FileError&) {
  } catch (const fs::filesystem_error&) {
  }
  return "";
}

void Cache::remember(const std::string& question, const std::string& answer) const {
  try {
    write_file(subfolder("answers") / fingerprint(question), question + "\n" + answer);
  } catch (const FileError&) {
  }
}

void Cache::discard(const Place& place) const {
  const fs::path entry = folder_ / place.entry;
  const TemporaryFolder bin(temporary() / place.entry);
  if (::rename(entry.c_str(), (bin.path() / "old").c_str()) != 0 && errno != ENOENT)
    throw FileError(entry.string(), std::strerror(errno));
}

void sweep(const fs::path& folder) {
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    remove_if_abandoned(entry->path());
}

}  // namespace kanec::compile
