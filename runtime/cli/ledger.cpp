// kanec ledger: the operations of all functions of many scenes.
// SPDX-License-Identifier: GPL-2.0-or-later

#include "generator/read/read.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/kanec.hpp"
#include "runtime/cli/scene_argument.hpp"
#include "runtime/model/costs.hpp"
#include "runtime/model/scene_files.hpp"
#include "runtime/terminal/interrupt.hpp"
#include "runtime/terminal/output.hpp"
#include "runtime/terminal/progress.hpp"
#include "runtime/text/json.hpp"

namespace kanec::cli {
namespace {

constexpr auto ledger_footer = R"(Example: what the shipped scenes cost, as the page that the documentation links
  kanec ledger models --markdown -o docs/ledger.md

A scene is a scene.toml or a folder that holds one; a folder of such folders means all of them, by name. Without any,
those under models/. Counted are the functions that a scene asks for, or the usual ones; with --all every function that
it can have, derivatives included. Nothing is compiled. In the JSON a list of scenes.)";

struct LedgerArguments {
  std::vector<std::string> scenes;
  bool markdown = false, json = false, all = false;
  std::string output = "-";
};

std::vector<SceneCost> costs_of(const LedgerArguments& options) {
  std::vector<std::string> files;
  for (const std::string& word : options.scenes.empty() ? std::vector<std::string>{"models"} : options.scenes)
    for (std::string& file : scene_files(word)) files.push_back(std::move(file));
  const Interrupts interrupts;
  ProgressBar bar("ledger");
  std::vector<SceneCost> costs;
  for (const std::string& file : files) {
    interrupts.poll();
    bar.show(static_cast<double>(costs.size()) / static_cast<double>(files.size()));
    costs.push_back(cost_of(scene::read(file), options.all, [](const std::string& note) { remark("note: " + note); }));
  }
  return costs;
}

std::string command_of(const LedgerArguments& options) {
  std::string command = "kanec ledger";
  for (const std::string& scene : options.scenes) command += " " + typed(scene);
  return command + (options.all ? " --all" : "") + " --markdown";
}

int ledger(const LedgerArguments& options) {
  if (options.markdown && options.json) throw InputError("--json: found it beside --markdown; allowed: one of them");
  AtomicFile file(options.output);
  const std::vector<SceneCost> costs = costs_of(options);
  file.write(options.markdown ? costs_markdown(costs, command_of(options))
             : options.json   ? json_text(costs_json(costs))
                              : costs_text(costs));
  file.commit();
  return success;
}

}  // namespace

void add_ledger(CLI::App& app, Action& action) {
  const auto [command, options] =
      add_command(app, action, "ledger", "the operations of every function of many scenes", ledger_footer, &ledger);
  command->add_option("SCENES", options->scenes, "scenes, or folders of scenes (models)")
      ->option_text(" ")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag("--all", options->all, "every function that a scene can have");
  command->add_flag("--markdown", options->markdown, "as a page of tables");
  command->add_flag("--json", options->json, "for machines");
  command->add_option("-o,--output", options->output, "into this file")->option_text("FILE");
}

}  // namespace kanec::cli
