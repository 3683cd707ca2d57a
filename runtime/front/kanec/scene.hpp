// A scene: read or built, asked for its equations, its code, its compiled model; checked and simulated. Not: what a
// compiled model does (model.hpp, batch.hpp, motion.hpp). Links GiNaC: GPL.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kanec/batch.hpp"
#include "kanec/model.hpp"
#include "kanec/motion.hpp"
#include "kanec/value.hpp"

namespace kanec {

// Numbers that belong together, in a state or a result.
struct Part {
  std::string name;        // "eps_1"
  std::vector<int> shape;  // none: a number; one: a list; two: a matrix, row by row
  std::string unit;        // "rad/s"
  int begin = 0;           // its first number
  int size = 1;
};

// What the numbers of a state or a result are, in order.
struct Shape {
  std::string name;  // "x", "mass_matrix"
  std::vector<Part> parts;
  std::vector<std::string> rows, columns;  // their names in wide matrices; else empty
  int size = 0;
};

// A function that a solver of the scene can have.
struct Offer {
  std::string name, meaning;
  Shape result;
  bool reads_t = false, reads_x = false, reads_y = false, reads_ydot = false, reads_inputs = false;
  bool usual = true;  // emitted unless functions are named
};

struct File {
  std::string name, text;
};

// What is emitted.
struct Emission {
  std::vector<std::string> functions =
      {};                          // empty: those that the scene names, else the usual ones; "a+b": both in one
  std::string language = "cpp";    // or "c"
  std::string optimize = "speed";  // "size", "line", "loops"
  std::string algorithm = "auto";  // "composite", "articulated"
  bool taylor = false;             // with the Taylor series of the motion
  bool abi = false;                // with what a shared library is made of
  std::function<void(const std::string& note)> tell = {};
};

// How a model is compiled.
struct Compilation {
  std::string compiler = {};  // empty: $KANEC_CXX, $CXX, clang++, c++ or g++
  std::string flags = {};     // empty: the usual ones
  bool use_cache = true;
  std::filesystem::path cache = {};  // empty: $KANEC_CACHE or ~/.cache/kanec
  std::function<void()> poll = {};   // called now and then; what it throws ends it
};

// How far a function's compiled code is from 50-digit arithmetic and from the generic path (`kanec check --help`).
struct Agreed {
  std::string function;
  double largest_ulps = 0.0, median_ulps = 0.0;
  double generic = 0.0;         // relative, from the generic path in long double
  double generic_double = 0.0;  // of the generic path in double from that
  int undefined = 0;            // of the states, without a result
  bool passed = false;
};

// Cheap to copy; all functions may be called from several threads at once, but that derivations take turns: GiNaC
// counts references without a lock.
class KANEC_API Scene {
 public:
  // A scene.toml, or the folder of one. Throws SceneError, FileError.
  static Scene read(const std::filesystem::path& path);
  // `origin` only names the text in messages.
  static Scene parse(std::string_view text, const std::string& origin = "scene");
  static Scene build(const Table& table);
  // The all-symbolic system of a connection array.
  static Scene tree(const std::vector<int>& lower);

  std::string name() const;
  std::string text() const;                  // TOML that reads back as the same scene
  std::vector<std::string> remarks() const;  // notes and warnings of reading
  std::vector<std::string> bodies() const;
  std::vector<int> connection() const;
  int nx() const;
  int ny() const;
  Shape x() const;
  Shape y() const;
  Shape ydot() const;
  std::vector<Quantity> parameters() const;
  std::vector<Quantity> inputs() const;
  std::vector<double> initial_x() const;
  std::vector<double> initial_y() const;
  Run run() const;  // its [simulate], with its events

  // With other values of parameters and inputs; masses and inertias are judged anew. Throws InputError, SceneError.
  Scene with(const std::vector<Quantity>& values) const;

  std::vector<Offer> functions() const;
  // One a part of a request, "kinematics+accelerations". Throws InputError for a function that the scene does not have.
  std::vector<Shape> results(const std::string& request) const;

  // The equations: "text", "latex" (a document), "json". Throws InputError.
  std::string derive(const std::string& format = "text") const;
  // Throws InputError for what cannot be emitted.
  std::vector<File> generate(const Emission& emission = {}) const;
  // From the cache where it was compiled before, with the scene's values of parameters and inputs. Throws InputError,
  // BuildError, LoadError.
  Model compile(const Emission& emission = {}, const Compilation& compilation = {}) const;
  // scalar: "double" or "float"; lanes: 0 for as many as the processor computes with at once.
  Batch compile_batch(const Emission& emission = {}, const Compilation& compilation = {}, int threads = 0,
                      const std::string& scalar = "double", int lanes = 0) const;
  // In seeded random states, the first of which is the initial one.
  std::vector<Agreed> check(const Emission& emission = {}, const Compilation& compilation = {}, int states = 32,
                            std::uint64_t seed = 1) const;
  // From its initial state with its own values of parameters and inputs.
  Motion simulate(const Run& run, const Compilation& compilation = {}, const Progress& progress = {}) const;
  // The functions that simulate() compiles, for an Emission.
  std::vector<std::string> functions_to_simulate(const Run& run) const;

 private:
  struct Data;
  explicit Scene(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

// Of this kanec: "0.1.0".
KANEC_API std::string library_version();

}  // namespace kanec
