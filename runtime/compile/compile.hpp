// A generated model compiled by the system's C++ compiler, kept in a cache, loaded and checked. Not: how the model was
// derived (generator/) or what is done with it (runtime/abi/solver.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/abi/abi.h"
#include "runtime/compile/cache.hpp"
#include "runtime/compile/compiler.hpp"
#include "runtime/compile/source.hpp"

namespace kanec::compile {

struct Options {
  std::string compiler;            // program name or path; empty = find_compiler's choice
  std::vector<std::string> flags;  // where flags_given, in place of default_flags()
  bool flags_given = false;
  std::filesystem::path cache;  // empty = default_cache()
  bool use_cache = true;        // false = compiled anew, for this run alone
  // While another process compiles the same model: told after two seconds which one, and what becomes of it; called all
  // the while, and what it throws ends the wait. Both may be empty.
  std::function<void(const std::string&)> tell = {};
  std::function<void()> poll = {};
};

// A loaded model; its code is there as long as this object. Moved, not copied.
class Model {
 public:
  struct State;
  explicit Model(std::unique_ptr<State> state);
  ~Model();
  Model(Model&&) noexcept;
  Model& operator=(Model&&) noexcept;

  const kanec_model& abi() const;                 // of a batch: names and sizes, no functions
  const kanec_batch& batch() const;               // InternalError unless the source is a batch
  bool from_cache() const;                        // nothing was compiled
  double compile_seconds() const;                 // wall time of the compiler [s], 0 from the cache
  const std::filesystem::path& library() const;   // a file, as long as this object
  const std::vector<std::string>& notes() const;  // what a person should know: why nothing is kept

 private:
  std::unique_ptr<State> state_;
};

// Fetches or compiles, loads and checks. What the cache holds in a damaged form is made anew without a word, what
// others may have written with a note; a cache that cannot be written or trusted, or where another user's entry is in
// the way, is done without, with a note. Throws BuildError (no compiler, or it fails), LoadError (not the model that
// `source` announces), InputError (a cache that others may write to), InternalError (a source with unsound names).
Model build(const Source& source, const Options& options = {});

}  // namespace kanec::compile
