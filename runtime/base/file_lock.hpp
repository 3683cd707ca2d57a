// Whether an open file or folder is in use: flock(2), and whether its path still leads to it. Not: waiting for it.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "runtime/base/descriptor.hpp"

namespace kanec {

enum class LockAttempt { locked, taken, impossible };  // the last where the file system knows no locks

// Without waiting. The lock ends with the descriptor, and so with its process, however that dies.
LockAttempt try_lock(const Descriptor& file);

// Whether the path, itself no link, is that of the open file; another process may have removed or replaced it.
bool leads_to(const std::filesystem::path& path, const Descriptor& file);

// Removes a file, or a folder with all that it holds, that is our user's and locked by nobody: its process is dead.
// Where there are no locks it must be a day old. What is in use, and what cannot be opened or removed, stays.
void remove_if_abandoned(const std::filesystem::path& path);

}  // namespace kanec
