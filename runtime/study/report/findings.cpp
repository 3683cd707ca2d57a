// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "runtime/base/error.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/base/text.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/model/model.hpp"
#include "runtime/model/scene_files.hpp"
#include "runtime/study/report/evaluation_text.hpp"
#include "runtime/study/report/integration_text.hpp"
#include "runtime/terminal/interrupt.hpp"
#include "runtime/terminal/output.hpp"
#include "runtime/terminal/progress.hpp"
#include "runtime/text/json.hpp"

namespace kanec {
namespace {

SceneErrors errors_of(const scene::Scene& scene, const ReportOptions& given, const Interrupts& interrupts) {
  EvaluationOptions options = given.evaluation;
  options.functions = Functions(scene).chosen(options.functions);
  options.is_timed = options.is_timed || given.draws_evaluation();
  options.build = given.build;
  ProgressBar bar(scene.name);
  return evaluation_errors(scene, options, [&](double fraction) {
    interrupts.poll();
    bar.show(fraction);
  });
}

// Each scene as it is typed on a command line, in the order of load_all().
std::vector<std::string> arguments_of(const ReportOptions& options) {
  std::vector<std::string> list;
  for (const std::string& word : options.scenes)
    for (const std::string& file : scene_files(word)) list.push_back(typed(file));
  if (list.empty()) list.push_back("--connection " + fit::shell(options.connection));
  return list;
}

SceneRuns runs_of(const scene::Scene& scene, const ReportOptions& options, const Interrupts& interrupts) {
  const CompiledModel model =
      build(scene, integration_functions(scene, options.integration), options.build, /*with_taylor=*/true);
  ProgressBar bar(scene.name + ", integration");
  return integration_runs(scene, model.library.abi(), options.integration, [&](double fraction) {
    interrupts.poll();
    bar.show(fraction);
  });
}

// That writes the same page again, bar the times.
std::string command_of(const ReportOptions& options) {
  std::string command = "kanec report";
  for (const std::string& scene : options.scenes) command += " " + typed(scene);
  if (!options.connection.empty()) command += " --connection " + fit::shell(options.connection);
  if (!options.integrates()) command += " --evaluation";
  if (!options.evaluates()) command += " --integration";
  if (!options.evaluation.functions.empty())
    command += " --functions " + fit::shell(fmt::format("{}", fmt::join(options.evaluation.functions, ",")));
  const EvaluationOptions usual;
  if (options.evaluation.states != usual.states) command += fmt::format(" --states {}", options.evaluation.states);
  if (options.evaluation.seed != usual.seed) command += fmt::format(" --seed {}", options.evaluation.seed);
  if (options.evaluation.is_timed) command += " --timed";
  const IntegrationOptions& run = options.integration;
  if (!run.integrators.empty())
    command += " --integrators " + fit::shell(fmt::format("{}", fmt::join(run.integrators, ",")));
  if (run.duration) command += " --duration " + shortest(*run.duration);
  if (run.error) command += " --error " + shortest(*run.error);
  if (run.limit != IntegrationOptions().limit) command += " --limit " + shortest(run.limit);
  if (options.with_peers) command += " --peers";
  if (!options.plot.empty()) command += " --plot " + fit::shell(options.plot);
  return command + build_text(options.build) + " --markdown";
}

std::string as_text(const Findings& findings, const ReportOptions& options) {
  std::string text;
  for (std::size_t i = 0; i < std::max(findings.errors.size(), findings.runs.size()); ++i) {
    if (i < findings.errors.size()) text += (text.empty() ? "" : "\n") + evaluation_text({findings.errors[i]});
    if (i < findings.runs.size())
      text += (text.empty() ? "" : "\n") + integration_text(findings.runs[i], options.integration.error);
  }
  return text;
}

std::string as_json(const Findings& findings, const ReportOptions& options) {
  Json json = evaluation_json(findings.errors, options.evaluation);
  for (std::size_t i = 0; i < findings.runs.size(); ++i) {
    if (!options.evaluates()) json["scenes"].push_back({{"model", findings.runs[i].model}});
    json["scenes"][i]["integration"] = integration_json(findings.runs[i], options.integration.error);
  }
  return json_text(json);
}

std::string as_page(const Findings& findings, const ReportOptions& options) {
  const std::string command = command_of(options);
  std::string text;
  if (options.evaluates()) text += evaluation_markdown(findings.errors, options.evaluation, command);
  if (options.evaluates() && options.integrates()) text += "\n";
  if (options.integrates()) text += integration_markdown(findings.runs, options.integration.error, command);
  return text;
}

// What `make` returns, or why it failed where others may still be made.
template <class Part>
Part part_of(const scene::Scene& scene, bool is_alone, const std::function<Part()>& make) {
  try {
    return make();
  } catch (const InternalError&) {
    throw;
  } catch (const Error& error) {
    if (is_alone) throw;
    Part failed;
    failed.model = scene.name;
    failed.failure = error.what();
    return failed;
  }
}

}  // namespace

std::vector<std::string> Findings::failures() const {
  std::vector<std::string> list;
  const auto add = [&list](const auto& part) {
    if (!part.failure.empty()) list.push_back(part.model + ": " + part.failure);
  };
  for (const SceneErrors& part : errors) add(part);
  for (const SceneRuns& part : runs) add(part);
  return list;
}

Findings found(const ReportOptions& options, const std::vector<scene::Scene>& scenes) {
  const Interrupts interrupts;
  const std::vector<std::string> arguments = arguments_of(options);
  const bool is_alone = scenes.size() == 1;
  Findings findings;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const scene::Scene& scene = scenes[i];
    if (options.evaluates())
      findings.errors.push_back(
          part_of<SceneErrors>(scene, is_alone, [&] { return errors_of(scene, options, interrupts); }));
    if (!options.integrates()) continue;
    findings.runs.push_back(part_of<SceneRuns>(scene, is_alone, [&] { return runs_of(scene, options, interrupts); }));
    findings.runs.back().path = arguments[i];
  }
  const std::vector<std::string> failures = findings.failures();
  if (!failures.empty() && failures.size() == findings.errors.size() + findings.runs.size())
    throw Error(failures.front(), Error::Lines::several);
  return findings;
}

std::string text_of(const Findings& findings, const ReportOptions& options) {
  if (options.json) return as_json(findings, options);
  if (options.markdown) return as_page(findings, options);
  if (!options.csv) return as_text(findings, options);
  if (!options.evaluates()) return integration_csv(findings.runs);
  return options.evaluation.is_timed ? variants_csv(findings.errors) : evaluation_csv(findings.errors);
}

}  // namespace kanec
