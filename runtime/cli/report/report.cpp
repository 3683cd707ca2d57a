// kanec report: what speed costs in digits.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <optional>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/functions.hpp"
#include "runtime/cli/interrupt.hpp"
#include "runtime/cli/kanec.hpp"
#include "runtime/cli/model.hpp"
#include "runtime/cli/progress.hpp"
#include "runtime/cli/report/evaluation_text.hpp"
#include "runtime/cli/scene_argument.hpp"

namespace kanec::cli {
namespace {

constexpr auto footer =
    R"(Example: what each way of computing the accelerations of a seven-joint chain costs in operations and in digits
  kanec report models/bench_cr7 --functions accelerations
  kanec report models/bench_* --markdown -o docs/accuracy.md

Each function that is named, else accelerations, residual, forcing and mass_matrix, is derived in the way that `generate` keeps, and in ways that differ from it in one thing: the other
algorithm, other axes, origins as typed, masses not regrouped, regrouped within a few links or altogether, no passes.
Each is evaluated in double and in float, in seeded random states (those of kanec check) and in hard ones (speeds a
thousand times as high, angles zero, at multiples of a right angle, and of ten thousand radians), and compared with
  - the same program in 50 digits: what rounding costs, in ulps of the largest component;
  - the generic numeric path in long double, which shares no code with the generator: no mistake in algebra hides;
and beside it stands the error of the generic path in double, and the condition of A. `expected` is what the generator
chooses by: the error that independent roundings of all operations would make. Nothing is compiled.)";

struct Options {
  std::vector<std::string> scenes;
  std::string connection;
  EvaluationOptions evaluation;
  bool json = false, csv = false, markdown = false;
  std::string output = "-";
};

std::vector<SceneErrors> measured(const Options& options, const std::vector<scene::Scene>& scenes) {
  const Interrupts interrupts;
  std::vector<SceneErrors> list;
  for (const scene::Scene& scene : scenes) {
    EvaluationOptions evaluation = options.evaluation;
    evaluation.functions = Functions(scene).chosen(evaluation.functions);
    ProgressBar bar(scene.name);
    list.push_back(evaluation_errors(scene, evaluation, [&](double fraction) {
      interrupts.poll();
      bar.show(fraction);
    }));
  }
  return list;
}

std::string command_of(const Options& options) {
  std::string command = "kanec report";
  for (const std::string& scene : options.scenes) command += " " + scene;
  if (!options.connection.empty()) command += " --connection " + options.connection;
  for (std::size_t i = 0; i < options.evaluation.functions.size(); ++i)
    command += (i == 0 ? " --functions " : ",") + options.evaluation.functions[i];
  const EvaluationOptions usual;
  if (options.evaluation.states != usual.states) command += " --states " + std::to_string(options.evaluation.states);
  if (options.evaluation.seed != usual.seed) command += " --seed " + std::to_string(options.evaluation.seed);
  return command + " --markdown";
}

int report(const Options& options) {
  if (options.json + options.csv + options.markdown > 1)
    throw InputError("--json, --csv, --markdown: found several of them; allowed: one");
  const std::vector<scene::Scene> scenes = load_all(options.scenes, options.connection);
  std::optional<AtomicFile> file;
  if (!is_standard_output(options.output)) file.emplace(options.output);
  const std::vector<SceneErrors> errors = measured(options, scenes);
  const std::string text = options.json       ? json_text(evaluation_json(errors, options.evaluation))
                           : options.csv      ? evaluation_csv(errors)
                           : options.markdown ? evaluation_markdown(errors, options.evaluation, command_of(options))
                                              : evaluation_text(errors);
  if (!file) {
    print(text);
    return success;
  }
  file->write(text);
  file->commit();
  return success;
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(app, action, "report", "operations against digits", footer, &report);
  command->add_option("SCENE", options->scenes, "scene.toml files, folders that hold one, or folders of these")
      ->option_text("...");
  command->add_option("--connection", options->connection, "instead of a scene: the all-symbolic system of this tree")
      ->option_text("L(1),L(2),...");
  add_functions(*command, options->evaluation.functions);
  command->add_option("--states", options->evaluation.states, "random states (32)")
      ->option_text("NUMBER")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--seed", options->evaluation.seed, "of the random states (1)")->option_text("NUMBER");
  command->add_flag("--json", options->json, "for machines");
  command->add_flag("--csv", options->csv, "as a table for machines");
  command->add_flag("--markdown", options->markdown, "as a page (docs/accuracy.md)");
  command->add_option("-o,--output", options->output, "the report's file, or - (-)")->option_text("FILE");
}

}  // namespace kanec::cli
