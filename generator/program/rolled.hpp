// A function as a sequence of calls of few section bodies, each on its own row of tables: sections that do the same
// operations in the same order on other constants, entries of arguments and results. Not: its text (emit/rolled.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/program/canonical.hpp"
#include "generator/program/program.hpp"

namespace kanec::program {

// The name of a quantity's entry around the number of its body: "omega7_1" is {"omega", "_1"}.
struct Stem {
  std::string front, back;
  bool has_number = false;

  std::string with(const std::string& letter) const { return front + (has_number ? letter : "") + back; }
  bool operator==(const Stem&) const = default;
  auto operator<=>(const Stem&) const = default;
};

Stem stem(const std::string& label, int body);

// One thing that a section reads, for every member of its class. What is the same for all stands in each.
struct Leaf {
  LeafKind kind = LeafKind::constant;
  std::vector<Number> numbers;  // of a constant
  std::vector<Index> places;    // of an entry of an argument its index, of a result of parameters its node, of a frame
                                // the body whose it is
  std::vector<Index> fields;    // of a frame
};

// A result that other sections read, kept in the frame of its body.
struct Kept {
  Ref value;  // in the class's body; never negative
  Index field;
};

// A value that is an output, and its index for every member.
struct Output {
  Ref value;
  std::vector<std::size_t> places;
};

struct SectionClass {
  Pass pass = Pass::outward;
  std::vector<Index> bodies;  // of the members, in order of execution; -1 as in Section
  Program body;               // one function; its variable x[i] is leaf i, constants are those of all members
  std::vector<Stem> names;    // of the entries of the body's quantities, one after another
  std::vector<Leaf> leaves;
  std::vector<Kept> kept;
  std::vector<Output> outputs;
};

struct Step {
  std::size_t of, member;  // class and member
};

struct Rolled {
  std::vector<SectionClass> classes;  // by their first member
  std::vector<Step> steps;            // in order
  std::vector<Stem> fields;           // of frames, by pass and name
  std::vector<Index> slots;           // of the fields: place in a frame; fields that no body has both of may share one
  std::vector<Index> begins;          // of the frames of the bodies from 0, which is the whole system
  Index frames_size = 0;              // of all frames

  std::size_t operations = 0;  // of one evaluation, all nodes counted
  std::size_t written = 0;     // of all classes
};

// Absent where the function places blocks.
std::optional<Rolled> rolled(const Program& program, const Function& function);

}  // namespace kanec::program
