// The closing figures of an integration, for people and for machines. Not: the integration.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "runtime/text/json.hpp"
#include "runtime/trajectory/simulate.hpp"

namespace kanec {

// What the scene says about the figures (conservation.hpp).
struct Conservation {
  bool isolated = false;  // the momenta should be kept
  bool driven = false;    // energy change minus work is the work of prescribed coordinates, and no error
  bool attitudes = true;  // there are Euler parameters, of unit norm
};

std::string summary_text(const Summary& summary, const integrate::Options& options, const Conservation& conservation);
Json summary_json(const Summary& summary, const integrate::Options& options, const Conservation& conservation);

}  // namespace kanec
