// The ways of emitting and compiling that kanec bench knows by name. Not: how they are timed (contest.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "runtime/bench/contest.hpp"

namespace kanec {

struct NamedVariant {
  std::string name;
  std::string meaning;
};
std::vector<NamedVariant> variants_known();

// "emitted" first, then those named, each once; "all" names all. Throws InputError for another name.
std::vector<Variant> variants(const std::vector<std::string>& names, const BuildOptions& build);

}  // namespace kanec
