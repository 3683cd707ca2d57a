// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/taylor/compiled.hpp"

#include "runtime/integrate/options.hpp"

namespace kanec::test {

std::vector<std::string> all_rates(const scene::Scene& scene) {
  bool has_power = false;
  for (const Available& function : available_functions(scene)) has_power = has_power || function.name == "power";
  return integrate::needed_functions({}, has_power, n_coordinates(scene));
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
