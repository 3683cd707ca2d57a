// Temporary files and folders, known by their names and locked as long as their process lives, so that those of dead
// processes can be told from those in use and from files that only look alike. Not: what stands in them.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "runtime/base/descriptor.hpp"

namespace kanec {

// "<name>.kanec-<16 hexadecimal digits>": eight of chance, and eight that follow from these and the name, so that
// nothing else is called so by accident. Long names are cut to what a file system takes.
std::string temporary_name(const std::string& name);
bool is_temporary_name(std::string_view name);

// Removes from `folder` what has such a name and was left by a process that is dead.
void clear_abandoned(const std::filesystem::path& folder);

// A new empty file beside `path`, for this process alone (mode 0600) and locked; what dead processes left in that
// folder is cleared away first. Whoever makes it removes or renames it before the lock ends. Throws FileError of
// `path`.
struct TemporaryFile {
  std::filesystem::path path;
  Descriptor file;
};
TemporaryFile make_temporary_file(const std::filesystem::path& path);

// The same as a folder beside `path` (mode 0700), removed at the end with all that it holds.
class TemporaryFolder {
 public:
  // Throws FileError.
  explicit TemporaryFolder(const std::filesystem::path& path);
  TemporaryFolder(TemporaryFolder&&) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Descriptor lock_;
};

// The system's folder for temporary files, absolute, so that its name is no option of a program that it is handed to;
// /tmp where the one that is set is none.
std::filesystem::path temporary_root();

}  // namespace kanec
