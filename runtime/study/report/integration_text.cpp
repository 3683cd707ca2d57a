// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/integration_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "runtime/base/fit.hpp"
#include "runtime/base/text.hpp"
#include "runtime/bench/contest_text.hpp"
#include "runtime/picture/svg.hpp"
#include "runtime/study/report/choice.hpp"
#include "runtime/text/table.hpp"

namespace kanec {
namespace {

// In the order of run_row(); the last ones stand there only where a run has them.
const TextRow run_headings = {"",          "method", "setting",    "wall",     "steps",    "evaluations",
                              "Jacobians", "error",  "at the end", "position", "attitude", "speed",
                              "spin",      "energy", "momentum",   "|eps|-1"};
const TextRow units = {"", "", "", "", "", "", "", "", "", "[m]", "[rad]", "[m/s]", "[rad/s]", "", "", ""};

std::string shown(double value) { return fmt::format("{:.1e}", value); }

std::string shown(const std::optional<double>& value) { return value ? shown(*value) : ""; }

TextRow run_row(const IntegrationRun& run) {
  TextRow row = {run.is_on_front ? "*" : "", run.method, run.setting, duration_text(run.wall_seconds)};
  const TextRow rest = {std::to_string(run.steps),
                        std::to_string(run.evaluations),
                        run.jacobians ? std::to_string(*run.jacobians) : "",
                        shown(run.worst_error),
                        shown(run.end_error),
                        shown(run.worst.position),
                        shown(run.worst.attitude),
                        shown(run.worst.speed),
                        shown(run.worst.spin),
                        shown(run.energy),
                        shown(run.momentum),
                        shown(run.norm)};
  row.insert(row.end(), rest.begin(), rest.end());
  return row;
}

// What stands after the setting where a run failed.
std::string failure_text(const IntegrationRun& run) {
  if (run.wall_seconds == 0.0) return "failed: " + run.failure;
  return fmt::format("failed after {}: {}", duration_text(run.wall_seconds), run.failure);
}

std::vector<double> wanted_errors(std::optional<double> error) {
  return error ? std::vector<double>{*error} : std::vector<double>{1e-3, 1e-6, 1e-9, 1e-12};
}

// Recommendations, and other engines beside them where there are any.
std::vector<std::string> advice(const SceneRuns& scene, std::optional<double> error) {
  std::vector<std::string> lines;
  for (const double wanted : wanted_errors(error)) lines.push_back(recommendation(scene, wanted));
  const bool is_alone = std::all_of(scene.runs.begin(), scene.runs.end(),
                                    [](const IntegrationRun& run) { return run.options || !run.ok(); });
  for (const double wanted : wanted_errors(error))
    if (!is_alone) lines.push_back(comparison(scene, wanted));
  return lines;
}

constexpr auto kept_text =
    "energy, momentum: change beside its size; |eps|-1: at the ends of steps; *: no other is as fast and as accurate";

// Of rows of one length, the columns in which one below the headings has something.
std::vector<TextRow> without_empty_columns(const std::vector<TextRow>& rows, std::size_t n_headings) {
  std::vector<TextRow> kept(rows.size());
  for (std::size_t column = 0; column < rows.front().size(); ++column) {
    const bool is_empty = std::all_of(rows.begin() + static_cast<std::ptrdiff_t>(n_headings), rows.end(),
                                      [column](const TextRow& row) { return row[column].empty(); });
    for (std::size_t i = 0; i < rows.size() && !is_empty; ++i) kept[i].push_back(rows[i][column]);
  }
  return kept;
}

std::string runs_text(const SceneRuns& scene) {
  std::vector<TextRow> rows = {run_headings, units};
  for (const IntegrationRun& run : scene.runs)
    if (run.ok()) rows.push_back(run_row(run));
  return rows.size() == 2 ? "" : text_table(without_empty_columns(rows, 2), "lllr");
}

Json error_json(const MotionError& error, double relative) {
  return {{"relative", relative},
          {"position", error.position},
          {"attitude", error.attitude},
          {"speed", error.speed},
          {"spin", error.spin}};
}

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json run_json(const IntegrationRun& run) {
  Json json = {{"method", run.options ? name_of(run.options->method) : run.method}};
  if (run.options && has_jacobian(run.options->method)) json["jacobian"] = name_of(run.options->jacobian);
  if (!run.options) json["other_engine"] = true;
  if (run.step > 0.0) json["step"] = run.step;
  if (run.tolerance > 0.0) json["relative_tolerance"] = run.tolerance;
  if (run.tolerance > 0.0 && run.options) json["absolute_tolerance"] = run.options->absolute_tolerance;
  json["wall_seconds"] = run.wall_seconds;
  if (!run.ok()) {
    json["failure"] = run.failure;
    return json;
  }
  json.update({{"steps", run.steps},
               {"rejected_steps", run.rejected},
               {"evaluations", run.evaluations},
               {"jacobians", run.jacobians ? Json(*run.jacobians) : Json(nullptr)},
               {"worst", error_json(run.worst, run.worst_error)},
               {"end", error_json(run.end, run.end_error)},
               {"energy", optional_json(run.energy)},
               {"momentum", optional_json(run.momentum)},
               {"norm_error", optional_json(run.norm)},
               {"pareto", run.is_on_front}});
  return json;
}

Json recommendations_json(const SceneRuns& scene, std::optional<double> error) {
  Json list = Json::array();
  for (const double wanted : wanted_errors(error)) {
    const IntegrationRun* run = wanted < scene.reference_error ? nullptr : fastest_within(scene, wanted);
    list.push_back({{"error", wanted}, {"run", run ? run_json(*run) : Json(nullptr)}});
  }
  return list;
}

std::string csv_numbers(const IntegrationRun& run) {
  const auto number = [](const std::optional<double>& value) { return value ? shortest(*value) : std::string(); };
  const MotionError &e = run.end, &w = run.worst;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", run.steps, run.rejected, run.evaluations,
                     run.jacobians ? std::to_string(*run.jacobians) : "", run.worst_error, w.position, w.attitude,
                     w.speed, w.spin, run.end_error, e.position, e.attitude, e.speed, e.spin, number(run.energy),
                     number(run.momentum), number(run.norm), run.is_on_front ? 1 : 0);
}

std::string csv_line(const SceneRuns& scene, const IntegrationRun& run) {
  const auto positive = [](double value) { return value > 0.0 ? shortest(value) : std::string(); };
  return fmt::format("{},{},{},{},{},{},{}\n", fit::csv(scene.model), fit::csv(run.method), positive(run.step),
                     positive(run.tolerance), shortest(run.wall_seconds),
                     run.ok() ? csv_numbers(run) : std::string(17, ','), fit::csv(run.failure));
}

std::string runs_table(const SceneRuns& scene) {
  TextRow top = run_headings;
  for (std::size_t i = 0; i < top.size(); ++i)
    top[i] = fit::markdown(top[i]) + (units[i].empty() ? "" : " " + units[i]);
  std::string text = markdown_row(top) + "|---|---|---|";
  for (std::size_t i = 3; i < run_headings.size(); ++i) text += "--:|";
  text += '\n';
  for (const IntegrationRun& run : scene.runs) {
    TextRow row = run_row(run);
    if (!run.ok()) {
      std::fill(row.begin() + 4, row.end(), "");
      row[2] += ": " + fit::markdown(run.failure);
    }
    text += markdown_row(row);
  }
  return text;
}

constexpr auto page_head =
    R"(Each line is one run of the emitted model by one integrator with one tolerance or step, compared with a reference that
is stated, at {} rows after the start. Wall times are the least of a few runs on one core of this machine:
{}. Tolerances: 1e-4 to 1e-14, of Taylor series finer ones, the absolute ones in proportion as the scene has them;
steps: halved again and again. A method's finer runs are left out once one took longer than the limit a run, which
stands there as failed.

- *error*: without unit, worst over the rows; *at the end*: the same there. Position, attitude (angle of the error
  rotation), speed and spin are the largest over bodies and rows, in their own units.
- *energy*: change less work of the loads beside the energies exchanged; *momentum*: change beside its size, where
  nothing acts from outside; *|eps|-1*: largest at the ends of steps, before any correction.
- *Jacobians*: evaluations of emitted derivatives; those for differences count as evaluations of the rates.
- `*` marks the Pareto front: no other run is as fast and as accurate.
)";

std::int64_t most_rows(const std::vector<SceneRuns>& scenes) {
  std::int64_t most = 0;
  for (const SceneRuns& scene : scenes) most = std::max(most, scene.rows);
  return most;
}

}  // namespace

std::string stretch_text(const SceneRuns& scene) {
  if (!scene.end) return fmt::format("0 to {} s", shortest(scene.duration));
  return fmt::format("0 to {:.10g} s, where an event ends it (of {} s)", *scene.end, shortest(scene.duration));
}

std::string reference_text(const SceneRuns& scene) {
  if (scene.is_disputed)
    return fmt::format("no reference to be trusted: {} and {} differ by {}, more than either changes with its steps",
                       scene.reference, scene.check, shown(scene.check_difference));
  std::string text = fmt::format("reference: {}; its own error {} (change from {})", scene.reference,
                                 shown(scene.reference_error), scene.coarser);
  return scene.check.empty() ? text
                             : text + fmt::format("; {} differs by {}", scene.check, shown(scene.check_difference));
}

std::string scales_text(const SceneRuns& scene) {
  return fmt::format(
      "error: worst of {} rows, largest of position / {:.3g} m, attitude, speed / {:.3g} m/s, spin / {:.3g} rad/s",
      scene.rows, scene.scales.length, scene.scales.length * scene.scales.rate, scene.scales.rate);
}

std::string integration_text(const SceneRuns& scene, std::optional<double> error) {
  if (!scene.failure.empty()) return fmt::format("{}: integration failed: {}\n", scene.model, scene.failure);
  std::string text = fmt::format("{}: integration from t = {}\n{}\n{}\n{}\n\n{}", scene.model, stretch_text(scene),
                                 reference_text(scene), scales_text(scene), kept_text, runs_text(scene));
  std::string failures;
  for (const IntegrationRun& run : scene.runs)
    if (!run.ok()) failures += title_of(run) + ": " + failure_text(run) + "\n";
  text += (failures.empty() ? "" : "\n") + failures + "\n";
  for (const std::string& line : advice(scene, error)) text += line + "\n";
  return text;
}

Json integration_json(const SceneRuns& scene, std::optional<double> error) {
  if (!scene.failure.empty()) return Json::object({{"failure", scene.failure}});
  Json runs = Json::array();
  for (const IntegrationRun& run : scene.runs) runs.push_back(run_json(run));
  return {{"duration", scene.duration},
          {"end", scene.end.value_or(scene.duration)},
          {"rows", scene.rows},
          {"length", scene.scales.length},
          {"rate", scene.scales.rate},
          {"reference",
           {{"method", scene.reference},
            {"coarser", scene.coarser},
            {"error", scene.reference_error},
            {"check", scene.check},
            {"check_difference", scene.check_difference},
            {"disputed", scene.is_disputed}}},
          {"runs", std::move(runs)},
          {"recommended", recommendations_json(scene, error)}};
}

std::string integration_csv(const std::vector<SceneRuns>& scenes) {
  std::string text =
      "model,method,step[s],relative_tolerance,wall[s],steps,rejected,evaluations,jacobians,worst_error,worst_position["
      "m],"
      "worst_attitude[rad],worst_speed[m/s],worst_spin[rad/s],end_error,end_position[m],end_attitude[rad],"
      "end_speed[m/s],end_spin[rad/s],energy,momentum,norm_error,pareto,failure\n";
  for (const SceneRuns& scene : scenes) {
    for (const IntegrationRun& run : scene.runs) text += csv_line(scene, run);
    if (!scene.failure.empty()) text += fit::csv(scene.model) + std::string(23, ',') + fit::csv(scene.failure) + "\n";
  }
  return text;
}

std::string integration_markdown(const std::vector<SceneRuns>& scenes, std::optional<double> error,
                                 const std::string& command) {
  std::string text = "# Accuracy of integration\n\nWritten by " + fit::code(command) + ".\n\n" +
                     fmt::format(page_head, most_rows(scenes), fit::markdown(processor_name()));
  for (const SceneRuns& scene : scenes) {
    if (!scene.failure.empty()) {
      text += fmt::format("\n## {}\n\nFailed: {}\n", scene.model, fit::markdown(scene.failure));
      continue;
    }
    text += fmt::format("\n## {}\n\n{}. {}. {}.\n\n", scene.model, stretch_text(scene), reference_text(scene),
                        scales_text(scene));
    if (!scene.picture.empty())
      text += fmt::format("![Wall time over error]({})\n\n",
                          fit::link(std::filesystem::path(scene.picture).filename().string()));
    text += runs_table(scene) + "\n";
    for (const std::string& line : advice(scene, error)) text += "- " + fit::markdown(line) + "\n";
  }
  return text;
}

}  // namespace kanec
