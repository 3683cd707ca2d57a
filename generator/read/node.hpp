// Typed reading of a TOML tree, every error with its place. Not: which keys a scene has (read.cpp, body.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// toml++ 3.3 asserts what some malformed texts violate ("[" and a line's end), and then reports them as errors: the
// errors are wanted, also where the library comes as headers with assertions on.
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>

#include <optional>
#include <string>
#include <vector>

#include "generator/scene/place.hpp"

namespace kanec::scene {

// A value and where it stands. Refers to the parsed tree, which must outlive it.
class Node {
 public:
  Node(const toml::node& value, Place place);

  const toml::node& value() const { return *value_; }
  const Place& place() const { return place_; }
  bool is_text() const { return value_->is_string(); }
  bool is_list() const { return value_->is_array(); }

  // What stands here, for a message: "the text \"abc\"", "-1", "a list of 3".
  std::string found() const;
  [[noreturn]] void refuse(const std::string& allowed) const { fail(place_, found(), allowed); }

  // Each throws SceneError unless the value is of its kind; `allowed` says what would be right.
  double real(const std::string& allowed = "a finite number") const;  // an integer is accepted
  int integer(const std::string& allowed) const;                      // no float, not even 1.0
  std::string text(const std::string& allowed) const;
  std::vector<Node> list(const std::string& allowed) const;  // field of entry i: "field[i]", from 1
  std::vector<Node> list(std::size_t size, const std::string& allowed) const;

 private:
  const toml::node* value_;
  Place place_;
};

// A table whose fields are named `prefix` + key in messages.
class Table {
 public:
  Table(const Node& node, std::string prefix);
  Table(const toml::table& table, Place place, std::string prefix);

  const Place& place() const { return place_; }
  void only(const std::vector<std::string>& known) const;  // refuses the first key that is not one of these
  std::optional<Node> find(const std::string& key) const;
  Node at(const std::string& key, const std::string& allowed) const;  // refuses its absence

  struct Entry {
    std::string key;
    Node node;
  };
  std::vector<Entry> entries() const;  // in the order of the file

 private:
  Node node(const toml::key& key, const toml::node& value) const;

  const toml::table* table_;
  Place place_;
  std::string prefix_;
};

}  // namespace kanec::scene
