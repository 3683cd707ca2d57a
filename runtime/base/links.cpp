// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/links.hpp"

#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <string>
#include <system_error>

#include "runtime/base/error.hpp"

namespace kanec {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // as many as Linux follows

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

bool is_in_proc(const fs::path& path) {
  struct statfs system {};
  return ::statfs(folder_of(path).c_str(), &system) == 0 && system.f_type == PROC_SUPER_MAGIC;
}

bool is_planted(const fs::path& path, const struct stat& link) {
  struct stat folder {};
  if (::stat(folder_of(path).c_str(), &folder) != 0) return false;
  const bool is_shared = (folder.st_mode & S_ISVTX) != 0 && (folder.st_mode & S_IWOTH) != 0;
  return is_shared && link.st_uid != ::geteuid() && link.st_uid != folder.st_uid;
}

}  // namespace

fs::path follow_links(const fs::path& path) {
  fs::path place = path;
  for (int links = 0; links <= most_links; ++links) {
    struct stat status {};
    if (::lstat(place.c_str(), &status) != 0 || !S_ISLNK(status.st_mode) || is_in_proc(place)) return place;
    if (is_planted(place, status))
      throw FileError(path.string(), "a link of another user in a folder where all may write; not followed");
    std::error_code failed;
    const fs::path next = fs::read_symlink(place, failed);
    if (failed) throw FileError(path.string(), failed.message());
    place = next.is_absolute() ? next : place.parent_path() / next;
  }
  throw FileError(path.string(), std::strerror(ELOOP));
}

int own_descriptor(const fs::path& path) {
  std::error_code failed;
  const fs::path folder = fs::canonical(folder_of(path), failed);
  if (failed || folder != "/proc/" + std::to_string(::getpid()) + "/fd") return -1;
  const std::string name = path.filename().string();
  int number = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() ? number : -1;
}

}  // namespace kanec
