// The subcommands of kanec, one file each. Not: what happens to errors (kanec.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>

namespace kanec::cli {

// What a parsed command line asks for; returns the exit status.
using Action = std::function<int()>;

// Each adds its subcommand to the application and, once that is parsed, says in `action` what is to be done.
void add_derive(CLI::App& app, Action& action);
void add_generate(CLI::App& app, Action& action);
void add_simulate(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_eval(CLI::App& app, Action& action);
void add_functions_command(CLI::App& app, Action& action);
void add_bench(CLI::App& app, Action& action);
void add_ledger(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);

// A subcommand with an `Options` of its own that the caller binds to options; `run` does the work.
template <class Options>
std::pair<CLI::App*, std::shared_ptr<Options>> add_command(CLI::App& app, Action& action, const std::string& name,
                                                           const std::string& description, const std::string& footer,
                                                           int (*run)(const Options&)) {
  CLI::App* command = app.add_subcommand(name, description)->footer(footer);
  auto options = std::make_shared<Options>();
  command->callback([&action, options, run] { action = [options, run] { return run(*options); }; });
  return {command, options};
}

}  // namespace kanec::cli
