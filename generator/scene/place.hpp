// Where something stands in a scene, and the messages that begin with it. Not: what is wrong there.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kanec::scene {

// A place in a scene file; empty or zero parts are left out of messages.
struct Place {
  std::string file;
  int line = 0;
  std::string body = {};   // "body 3 (arm)"
  std::string field = {};  // "r[2]", "initial.eps"; components count from 1
};

// Throws the SceneError "file:line: body: field: found …; allowed: …".
[[noreturn]] void fail(const Place& place, const std::string& found, const std::string& allowed);

// A note or warning: "file:line: body: field: text".
std::string remark(const Place& place, const std::string& text);

// In double quotes, on one line, cut after 40 bytes.
std::string in_quotes(std::string_view text);

// "a, b, c"; where one of them is near to `found`: "a, b, c (did you mean b?)". Empty text is near to none.
std::string one_of(const std::vector<std::string>& known, std::string_view found);

}  // namespace kanec::scene
