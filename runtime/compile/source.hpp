// What the generator hands over for compilation. Not: how it is emitted (generator/emit).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace kanec::compile {

struct Source {
  std::string name;  // of the model, an identifier
  std::string hash;  // expected kanec_model::hash; empty: any, where the key says enough
  int nx = 0;        // expected sizes
  int ny = 0;
  // File name and text: the emitted header, and what instantiates it for double and exports the descriptor. They
  // include each other by bare name; abi.h is put beside them.
  std::vector<std::pair<std::string, std::string>> files;
  std::string main;                     // the file to compile
  std::vector<std::string> flags = {};  // before those of Options, which may overrule them
  bool is_batch = false;                // exports a kanec_batch, else a kanec_model
  // What hash and files follow from, where that is known sooner than they are: what was compiled of the same origin is
  // fetched from the cache without them, else `make` fills them in.
  std::string origin = {};
  std::function<void(Source&)> make = {};
};

}  // namespace kanec::compile
