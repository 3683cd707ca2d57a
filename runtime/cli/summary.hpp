// The closing figures of an integration, for people and for machines. Not: the integration.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "runtime/cli/output.hpp"
#include "runtime/integrate/simulate.hpp"

namespace kanec::cli {

// `isolated`: neither gravity nor loads act, so that the momenta should be kept.
std::string summary_text(const integrate::Summary& summary, const integrate::Options& options, bool isolated);
Json summary_json(const integrate::Summary& summary, const integrate::Options& options);

}  // namespace kanec::cli
