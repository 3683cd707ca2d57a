// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/taylor/compiled.hpp"

namespace kanec::test {

std::vector<std::string> all_rates(const scene::Scene& scene) {
  const std::string rates = "kinematics+accelerations";
  for (const Available& function : available_functions(scene))
    if (function.name == "power") return {rates + "+power"};
  return {rates};
}

compile::Model compiled(const Generated& generated, const scene::Scene& scene) {
  compile::Options options;
  options.flags = {"-O0", "-fno-math-errno", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"};
  options.flags_given = true;
  options.cache = std::string(KANEC_BINARY_DIR) + "/tests/taylor_cache";
  compile::Source source{generated.name,
                         generated.hash,
                         n_coordinates(scene),
                         n_speeds(scene),
                         {{generated.name + ".hpp", generated.header}, {"main.cpp", generated.abi}},
                         "main.cpp"};
  if (!generated.taylor.empty()) {
    source.files.push_back({generated.name + "_taylor.hpp", generated.taylor});
    source.flags = {"-DKANEC_TAYLOR"};
  }
  return compile::build(source, options);
}

}  // namespace kanec::test
