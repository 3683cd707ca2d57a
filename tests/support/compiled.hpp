// Emitted code of a test, compiled. Not: any expectation.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/pipeline.hpp"
#include "runtime/compile/compile.hpp"

namespace kanec::test {

// Every warning an error, for the processor that builds; one cache for all tests of this build.
compile::Options compile_options();

// `main`: the name of the file that is compiled, `text`: what stands in it, beside the header.
compile::Source source(const Generated& generated, const scene::Scene& scene, const std::string& main,
                       const std::string& text);

// With Taylor series where `generated` has them.
compile::Model compiled(const Generated& generated, const scene::Scene& scene);

// All rates in one function, as explicit integrators call them.
std::vector<std::string> all_rates(const scene::Scene& scene);

}  // namespace kanec::test
