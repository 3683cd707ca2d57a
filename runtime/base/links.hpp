// Where a path that is written to leads. Not: opening or writing what is there.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace kanec {

// `path`, or what its symbolic links lead to at last, whether that is there or not. Links to open descriptors, which
// the system keeps in /proc, are not followed. Throws FileError for a loop, and for another user's link in a folder
// where all may make some (/tmp), as Linux itself refuses to follow it (fs.protected_symlinks, proc(5)).
std::filesystem::path follow_links(const std::filesystem::path& path);

// The number of our own descriptor that the path stands for (/dev/fd/3, /proc/self/fd/3), else -1.
int own_descriptor(const std::filesystem::path& path);

}  // namespace kanec
