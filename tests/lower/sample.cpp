// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/lower/sample.hpp"

#include "generator/choice/candidates.hpp"
#include "generator/choice/requests.hpp"

namespace kanec::test {

Sample sample_of(const scene::Scene& scene, Random& random) {
  return {scene, random_state(random, scene), random_parameters(random, scene), random_inputs(random, scene),
          random.uniform(0, 2)};
}

program::Program program_of(const scene::Scene& scene, const std::vector<std::string>& functions) {
  return cheapest_program(scene, requested_functions(scene, functions));
}

std::vector<long double> generic_result(const Sample& s, const std::string& function,
                                        const program::Arguments<long double>& arguments) {
  const generic::System<long double> system(s.scene, s.parameters);
  return generic::evaluate<long double>(system, function,
                                        {arguments.time, arguments.x, arguments.y, arguments.ydot, arguments.inputs});
}

}  // namespace kanec::test
