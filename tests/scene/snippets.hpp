// Scenes as short texts, and the message that a bad one gives. Not: any expectation.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "generator/read/read.hpp"
#include "runtime/base/error.hpp"

namespace kanec::scene {

// The message of the error that `text` gives, or "no error".
inline std::string message(const std::string& text) {
  try {
    parse(text, "f");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

// Lines 1 to 3 of a scene of one body without the keys `mass` and `inertia`; `body` begins on line 4.
inline std::string bare_body(const std::string& body) {
  return "name = 'one'\nconnection = [0]\n[[body]]\n" + body + "\n";
}

// A good scene of one body; `body` begins on line 6.
inline std::string one_body(const std::string& body) { return bare_body("mass = 1\ninertia = [1, 1, 1]\n" + body); }

// A good body, with what follows `name` if any.
inline std::string good_body(const std::string& name = "") {
  return "[[body]]\n" + (name.empty() ? "" : "name = '" + name + "'\n") + "mass = 1\ninertia = [1, 1, 1]\n";
}

// A scene of `bodies` good bodies with the connection array as it is written, on line 2.
inline std::string tree(const std::string& connection, int bodies) {
  std::string text = "name = 'tree'\nconnection = " + connection + "\n";
  for (int k = 0; k < bodies; ++k) text += good_body();
  return text;
}

// A good scene of one body, with `table` from line 6.
inline std::string with_table(const std::string& table) { return tree("[0]", 1) + table + "\n"; }

}  // namespace kanec::scene
