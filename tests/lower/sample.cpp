// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/lower/sample.hpp"

#include "generator/lower/lower.hpp"
#include "generator/program/passes.hpp"
#include "generator/symbolic/derive.hpp"

namespace kanec::test {

Sample sample_of(const scene::Scene& scene, Random& random) {
  return {scene, random_state(random, scene), random_parameters(random, scene), random_inputs(random, scene)};
}

program::Program program_of(const scene::Scene& scene, const std::vector<std::string>& functions) {
  return program::optimized(lower::lower(symbolic::derive(scene), functions));
}

std::vector<long double> generic_result(const Sample& s, const std::string& function,
                                        const program::Arguments<long double>& arguments) {
  const generic::System<long double> system(s.scene, s.parameters);
  return generic::evaluate<long double>(system, function,
                                        {0, arguments.x, arguments.y, arguments.ydot, arguments.inputs});
}

}  // namespace kanec::test
