// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/lanes/files.hpp"

#include "kanec_lanes_text.hpp"

namespace kanec {

std::vector<std::pair<std::string, std::string>> lane_files() {
  return {{"lanes.hpp", lanes_text},       {"lane_functions.hpp", lane_functions_text},
          {"cos_sin.hpp", cos_sin_header}, {"batch.hpp", batch_text},
          {"rk4.hpp", rk4_text},           {"rk4_step.hpp", rk4_step_text}};
}

std::string cos_sin_text() { return cos_sin_header; }

std::vector<std::string> lane_flags(const std::string& scalar, int lanes) {
  std::vector<std::string> flags = {"-ffp-contract=fast", "-DKANEC_SCALAR=" + scalar};
  if (lanes > 0) flags.push_back("-DKANEC_LANES=" + std::to_string(lanes));
  return flags;
}

}  // namespace kanec
