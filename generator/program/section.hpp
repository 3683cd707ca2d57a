// A function cut where its quantities pass from one body, or one pass, to the next; every operation stands in the first
// section that needs it, as emitted code has it. Not: which sections are alike (alike.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "generator/program/program.hpp"

namespace kanec::program {

// An output of the function and its value.
struct Store {
  std::size_t output;
  Ref value;
};

struct Section {
  Pass pass = Pass::outward;
  int body = 0;                         // as of a quantity; -1: what the outputs need beside the quantities, at the end
  std::vector<std::size_t> quantities;  // of the function
  std::vector<Ref> entries;             // operations made here that are entries of quantities, in order
  std::vector<Store> stores;            // in order
};

struct Sections {
  std::vector<Section> list;
  std::vector<Index> home;  // of a node: its section; -1 for what is no operation of the state's stage or not needed
};

Sections sections(const Program& program, const Function& function, const std::vector<Stage>& stages);

}  // namespace kanec::program
