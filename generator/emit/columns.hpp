// Places that a section of many bodies reads or writes, as columns of a table: places that keep their distance from
// body to body share one. Not: the text of the tables (section_text.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "generator/program/program.hpp"

namespace kanec::emit {

class Columns {
 public:
  using Places = std::vector<program::Index>;  // one for every body

  // Places of one array, all of them, before any is asked for.
  void add(const std::string& array, const Places& places);

  // "4" where all bodies have the same, else "x_at" or "x_at + 2" of a column of that name.
  std::string index(const std::string& array, const Places& places);

  // Those asked for, in that order.
  const std::vector<std::pair<std::string, Places>>& all() const { return columns_; }

 private:
  using Key = std::pair<std::string, Places>;  // array, and distances from the first body's place
  static Key key_of(const std::string& array, const Places& places);

  std::map<Key, program::Index> lowest_;  // first body's place
  std::map<Key, std::string> names_;
  std::map<std::string, int> counts_;  // columns of an array
  std::vector<std::pair<std::string, Places>> columns_;
};

}  // namespace kanec::emit
