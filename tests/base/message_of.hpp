// What a FileError says that an action throws. Not: any expectation.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "runtime/base/error.hpp"

namespace kanec::test {

inline std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const FileError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace kanec::test
