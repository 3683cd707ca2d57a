// Options that several commands have. Not: what they mean to the libraries that take them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "runtime/ensemble/ensemble.hpp"
#include "runtime/model/model.hpp"

namespace kanec::cli {

// Of building a model; its notes go to standard error, and Ctrl-C ends it.
void add_build(CLI::App& command, BuildOptions& options);
// --algorithm of accelerations.
void add_algorithm(CLI::App& command, std::optional<symbolic::Algorithm>& algorithm);
// --optimize: loops over bodies or straight lines.
void add_optimize(CLI::App& command, emit::Optimize& optimize);
// --functions a,b+c
void add_functions(CLI::App& command, std::vector<std::string>& functions);
// --set name=value
void add_settings(CLI::App& command, std::vector<std::string>& settings);
void add_ensemble(CLI::App& command, EnsembleArguments& arguments);

}  // namespace kanec::cli
