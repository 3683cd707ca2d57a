// A guard before the TOML parser, which crashes on keys nested some ten thousand deep. Not: a parser.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace kanec::scene {

// Refuses dotted keys (a.b.c…) of over 32 parts; values nested by brackets are limited by toml++ itself. Throws
// SceneError.
void check_key_depth(std::string_view text, const std::string& file);

}  // namespace kanec::scene
