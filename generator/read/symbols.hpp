// The names in a scene: which are allowed, and which parameter or input a text means. Not: where numbers stand.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/read/node.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::scene {

// The text at `node`, which must be a name that C++ and the emitted code allow. Throws SceneError.
std::string read_name(const Node& node);

// The same for a scene, whose name becomes a namespace and a file name.
std::string read_scene_name(const Node& node);

// The parameters and inputs of a scene, and which of them it uses.
class Symbols {
 public:
  void add_parameters(const Table& table);  // name = default
  void add_inputs(const Table& table);

  Number constant_or_parameter(const Node& node);
  Vector vector(const Node& node);                      // of three such
  std::optional<Number> find(const std::string& name);  // the parameter or input, now used; or none

  // The constant, or the parameter's or input's default.
  double value(const Number& number) const;
  // How a number is written in a message: "0.5", "m_payload = 0.5".
  std::string shown(const Number& number) const;

  void mark_used(const Expression& expression);
  // Refuses names that mean something else already; `taken` says what. Throws SceneError.
  void refuse(const std::map<std::string, std::string>& taken) const;

  std::vector<std::string> warnings() const;  // one a parameter or input that nothing uses
  std::vector<Named> parameters() const { return named(parameters_); }
  std::vector<Named> inputs() const { return named(inputs_); }

 private:
  struct Symbol {
    Named named;
    Place place;
    bool used = false;
  };
  void add(std::vector<Symbol>& list, const Table& table);
  static std::vector<Named> named(const std::vector<Symbol>& list);

  std::vector<Symbol> parameters_;
  std::vector<Symbol> inputs_;
};

}  // namespace kanec::scene
