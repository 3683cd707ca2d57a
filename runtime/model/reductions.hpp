// What was taken out of a scene before its equations, for people and for machines. Not: the reductions themselves
// (generator/pipeline.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/pipeline.hpp"
#include "runtime/text/json.hpp"

namespace kanec {

// A line a reduction; one line where there is none.
std::string reductions_text(const std::string& scene, const std::vector<Reduction>& reductions);
Json reductions_json(const std::string& scene, const std::vector<Reduction>& reductions);

}  // namespace kanec
