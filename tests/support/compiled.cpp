// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/support/compiled.hpp"

#include "generator/symbolic/functions.hpp"
#include "runtime/integrate/options.hpp"

namespace kanec::test {

compile::Options compile_options() {
  compile::Options options;
  options.flags = {"-O0",     "-march=native", "-fno-math-errno", "-Wall",
                   "-Wextra", "-Wconversion",  "-Wshadow",        "-Werror"};
  options.flags_given = true;
  options.cache = std::string(KANEC_BINARY_DIR) + "/tests/compiled_cache";
  return options;
}

compile::Source source(const Generated& generated, const scene::Scene& scene, const std::string& main,
                       const std::string& text) {
  return {generated.name,
          generated.hash,
          n_coordinates(scene),
          n_speeds(scene),
          {{generated.name + ".hpp", generated.header}, {main, text}},
          main};
}

compile::Model compiled(const Generated& generated, const scene::Scene& scene) {
  compile::Source abi = source(generated, scene, generated.name + "_abi.cpp", generated.abi);
  if (!generated.taylor.empty()) {
    abi.files.push_back({generated.name + "_taylor.hpp", generated.taylor});
    abi.flags = {"-DKANEC_TAYLOR"};
  }
  return compile::build(abi, compile_options());
}

std::vector<std::string> all_rates(const scene::Scene& scene) {
  return integrate::needed_functions({}, symbolic::has_loads(scene), n_coordinates(scene));
}

}  // namespace kanec::test
