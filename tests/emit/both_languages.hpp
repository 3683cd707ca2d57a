// Models emitted in C and in C++, compiled each by its own compiler in double and in float, and called on the same
// arguments. Not: any expectation.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/pipeline.hpp"
#include "tests/base/folder.hpp"
#include "tests/lower/sample.hpp"

namespace kanec::test {

// What a strict user of C would ask for.
std::vector<std::string> strict_c_flags();

class BothLanguages {
 public:
  // Names of models differ. The states, parameters and inputs are random, of this seed.
  void add(const scene::Scene& scene, const Generated& cpp, const Generated& c, std::uint64_t seed);

  // What a compiler says to a program that calls every function of every model, "float" or "double" as `real`; empty
  // where it has nothing to say.
  std::string complaints(const std::vector<std::string>& compiler_and_flags, const std::string& real) const;

  // What differs in the last bit, a line each; or what goes wrong before.
  std::string differences(const std::string& c_compiler, const std::string& cpp_compiler) const;

 private:
  struct Pair {
    std::string name, c, cpp;          // the calls of all functions
    std::vector<std::string> results;  // "accelerations[3]", in order
    std::vector<std::vector<double>> arguments;
  };
  std::string c_file(const std::string& real, const std::string& name) const;

  Folder folder_;
  std::vector<Pair> models_;
};

}  // namespace kanec::test
