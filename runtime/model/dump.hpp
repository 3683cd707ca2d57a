// What stands between the stages of the pipeline, as text for whoever looks for a mistake. Not: what they do.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/pipeline.hpp"
#include "generator/program/ledger.hpp"
#include "runtime/text/json.hpp"
#include "runtime/text/table.hpp"

namespace kanec {

// scene, equations, program, ledger, header, abi
std::vector<std::string> stage_names();

// scene: TOML that reads back; equations: the named quantities in order; program: one operation a line, named results
// and outputs by function; ledger, header, abi: as `generate` has them. Throws InputError for another stage.
std::string dump(const scene::Scene& scene, const std::vector<std::string>& functions, const std::string& stage);

// Operations by function: rows of a table, the table, and for machines.
TextRow ledger_headings();
TextRow ledger_row(const std::string& function, const program::Ledger& ledger, const std::string& results);
std::string ledger_text(const program::Program& program);
Json ledger_json(const program::Ledger& ledger);
Json ledgers_json(const program::Program& program);

}  // namespace kanec
