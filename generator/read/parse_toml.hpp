// TOML as text to a tree, with a guard before toml++, which takes the whole stack for keys nested some ten thousand
// deep and has no defined behaviour for some letters outside of texts. Not: what the tree means (node.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "generator/read/node.hpp"

namespace kanec::scene {

// Refuses dotted keys (a.b.c…) of over 32 parts, and anything but ASCII outside of comments and texts in quotes, as
// TOML does; values nested by brackets are limited by toml++ itself. Throws SceneError, its line in `file`.
toml::table parse_toml(std::string_view text, const std::string& file);

}  // namespace kanec::scene
