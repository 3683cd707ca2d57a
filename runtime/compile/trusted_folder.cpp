// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/trusted_folder.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "runtime/base/error.hpp"

namespace kanec::compile {
namespace {

namespace fs = std::filesystem;

bool is_systems(uid_t owner) {
  struct stat top {};
  return owner == 0 || (::stat("/", &top) == 0 && owner == top.st_uid);
}

// A group of the same number as its user's holds nobody else (Debian, Red Hat): umask 002 is for it.
bool is_private_group(gid_t group) { return group == ::getegid() && group == ::geteuid(); }

void require_trusted(const fs::path& above) {
  struct stat status {};
  if (::stat(above.c_str(), &status) != 0) return;  // made by us, or told when it is entered
  const auto refuse = [&above](const std::string& why) {
    throw FileError(above.string(), why +
                                        ", who could put another folder in the place of the cache below it; name "
                                        "another one in KANEC_CACHE, or --cache");
  };
  if (status.st_uid != ::geteuid() && !is_systems(status.st_uid))
    refuse("belongs to another user (" + std::to_string(status.st_uid) + ")");
  const bool others = (status.st_mode & S_IWOTH) != 0;
  const bool group = (status.st_mode & S_IWGRP) != 0 && !is_private_group(status.st_gid);
  if ((others || group) && (status.st_mode & S_ISVTX) == 0) refuse("may be written to by others (chmod go-w)");
}

}  // namespace

std::optional<std::string> exposure(const fs::path& path) {
  struct stat link {};
  struct stat folder {};
  if (::lstat(path.c_str(), &link) != 0 || ::stat(path.c_str(), &folder) != 0)
    throw FileError(path.string(), std::strerror(errno));
  if (link.st_uid != ::geteuid() || folder.st_uid != ::geteuid()) return "it belongs to another user";
  if ((folder.st_mode & (S_IWGRP | S_IWOTH)) != 0) return "others may write to it (chmod go-w)";
  return std::nullopt;
}

// Both as it is named and where it is: a folder with a link in it counts as one above.
void require_lasting_place(const fs::path& folder) {
  std::error_code failed;
  const fs::path real = fs::weakly_canonical(folder, failed);
  for (const fs::path& path : {folder, failed ? folder : real})
    for (fs::path above = path.parent_path();; above = above.parent_path()) {
      require_trusted(above);
      if (!above.has_relative_path()) break;
    }
}

}  // namespace kanec::compile
