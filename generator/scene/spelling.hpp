// Names of a scene that emitted code spells otherwise, since where it is included they may be macros, or keywords of C.
// Not: names that no scene may have (symbols.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace kanec::scene {

// `near` as "near_", all others as they are. No other name of a scene is spelled so.
std::string spelled(const std::string& name);

// Whether spelled() gives this name to another: "near_".
bool is_spelling(const std::string& name);

}  // namespace kanec::scene
