// Emitted models compiled together in one translation unit, which takes little longer than one of them, and called.
// Not: any expectation.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/pipeline.hpp"
#include "tests/base/folder.hpp"
#include "tests/lower/sample.hpp"

namespace kanec::test {

class ManyModels {
 public:
  ManyModels() = default;
  ~ManyModels();
  ManyModels(const ManyModels&) = delete;
  ManyModels& operator=(const ManyModels&) = delete;

  // Names of models differ.
  void add(const Generated& generated);

  // What the compiler says to every function of every model in double, every warning an error; empty where it has
  // nothing to say.
  std::string complaints(const std::string& compiler) const;

  // Compiles without optimisation, and loads. Throws std::runtime_error with what the compiler says.
  void load(const std::string& compiler);

  // The result of a function of a loaded model.
  std::vector<double> result(const std::string& model, const std::string& function, const Sample& sample) const;

 private:
  std::vector<std::string> command(const std::string& compiler, const std::vector<std::string>& more) const;

  Folder folder_;
  std::vector<std::string> names_;
  void* handle_ = nullptr;
};

}  // namespace kanec::test
