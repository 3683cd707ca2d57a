// A cart with a pole that its tests share, and where compiled models are kept. Not: any expectation.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "kanec/kanec.hpp"
#include "tests/base/folder.hpp"

namespace kanec::test {

inline Scene shipped(const std::string& name) {
  return Scene::read(std::filesystem::path(KANEC_SOURCE_DIR) / "models" / name);
}

// The cache that all tests of this build share.
inline Compilation shared_cache() {
  Compilation compilation;
  compilation.cache = std::filesystem::path(KANEC_BINARY_DIR) / "tests" / "front_cache";
  return compilation;
}

// The message of what is thrown.
template <class Error, class Action>
std::string refusal(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing is thrown";
  return "";
}

}  // namespace kanec::test
