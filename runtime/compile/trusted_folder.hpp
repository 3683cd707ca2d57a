// Whether a folder is our user's alone, and stays in its place. Not: what is kept in it.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace kanec::compile {

// Why others could write into the folder, a link to one included: it, or the link, is another user's, or its rights
// allow it. Empty where they cannot. Throws FileError where it is not there.
std::optional<std::string> exposure(const std::filesystem::path& folder);

// Who may write to a folder above, may put another one in this one's place. Folders above must be of our user or of
// the system's (of root, or of whoever owns /), and writable by nobody else, but for those where only owners rename
// what is theirs (sticky, /tmp) and for our user's private group. Throws FileError, which says which one is not so.
void require_lasting_place(const std::filesystem::path& folder);

}  // namespace kanec::compile
