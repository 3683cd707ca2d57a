// kanec report: what speed costs in digits.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <filesystem>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/split.hpp"
#include "runtime/cli/arguments.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/kanec.hpp"
#include "runtime/cli/numbers.hpp"
#include "runtime/cli/scene_argument.hpp"
#include "runtime/model/model.hpp"
#include "runtime/study/hard/hard_report.hpp"
#include "runtime/study/report/evaluation_diagram.hpp"
#include "runtime/study/report/findings.hpp"
#include "runtime/study/report/integration_diagram.hpp"
#include "runtime/terminal/output.hpp"

namespace kanec::cli {
namespace {

constexpr auto report_footer =
    R"(Example: which integrator for the double pendulum, which tolerance, at what cost, as tables and as a picture
  kanec report models/double_pendulum --integration --error 1e-9 --plot pendulum.svg
  kanec report models/bench_cr7 --evaluation --functions accelerations
  kanec report models/bench_* --evaluation --markdown -o docs/accuracy.md

Integration: the emitted model is compiled and run by every integrator over tolerances 1e-4 to 1e-14 (of
Taylor series finer ones), or steps halved again and again, each compared at 20 rows with a reference that is stated, together with how well that is known. A run
shows its wall time (the least of a few), steps, evaluations, worst and last error, what it kept of energy and momentum,
or why it failed; cvode_bdf stands there with the emitted Jacobian and with differences. A recommendation names the
fastest run for a wanted error, as a command to type. --plot draws wall time against error, a line an integrator, the
Pareto front marked.

With --peers other engines that kanec was built beside integrate the same motion, compared in the same way; scenes with
loads, locked or prescribed coordinates are refused by them.

Evaluation: each function that is named, else accelerations, residual, forcing and mass_matrix, is derived in the way
that `generate` keeps, and in ways that differ from it in one thing: the other algorithm, other axes, origins as typed,
masses not regrouped, regrouped within a few links or altogether, no passes. Each is evaluated in double and in float, in
seeded random states (those of kanec check) and in hard ones (speeds a thousand times as high, angles zero, at multiples
of a right angle, and of ten thousand radians), and compared with
  - the same program in 50 digits: what rounding costs, in ulps of the largest component;
  - the generic numeric path in 50 digits, which shares no code with the generator: no mistake in algebra hides;
and beside it stands the error of the generic path in double, and the condition of A. `expected` is what the generator
chooses by: the error that independent roundings of all operations would make. With --timed the emitted code is compiled:
as it is, both algorithms, loops for size, lanes in double and in float, each with the time of one evaluation and its
error from the generic path in 50 digits; --plot draws that, --csv writes it.

Without --integration or --evaluation both are made; with --functions evaluation alone. Of several scenes one that fails
says so in its place, and the exit status is 1.

Hard cases: scenes with known answers, or of which physics keeps something, at their full length (minutes), with a table
of what is kept to what; exit status 1 where one is not. --short takes the length of the tests
  kanec report --hard models/hard --markdown -o docs/hard_cases.md)";

void refuse(const std::string& found, const std::string& allowed) { throw InputError(found + "; allowed: " + allowed); }

// Of several scenes each has its name behind the file's.
std::vector<std::string> picture_files(const ReportOptions& options, const std::vector<scene::Scene>& scenes) {
  std::vector<std::string> list;
  const std::filesystem::path plot = options.plot;
  for (const scene::Scene& scene : scenes) {
    const std::string name = plot.stem().string() + "_" + scene.name + plot.extension().string();
    list.push_back(scenes.size() == 1 ? options.plot : (plot.parent_path() / name).string());
    if (std::count(list.begin(), list.end(), list.back()) > 1)
      refuse("--plot: found two scenes named " + scene.name, "a picture each");
  }
  return list;
}

void require_one_format(const ReportOptions& options) {
  if (options.json + options.csv + options.markdown > 1)
    refuse("--json, --csv, --markdown: found several of them", "one");
}

// Of "a,b" given once or many times.
std::vector<std::string> names_in(const std::vector<std::string>& lists, const std::string& option) {
  std::vector<std::string> names;
  for (const std::string& list : lists)
    for (const std::string_view name : split(list, ',')) {
      if (name.empty()) refuse(option + ": found an empty name in '" + list + "'", "names with commas between");
      names.emplace_back(name);
    }
  return names;
}

// The first option given that integration alone reads, or evaluation alone; empty: none.
std::string given_for_integration(const ReportOptions& options) {
  const IntegrationOptions& run = options.integration;
  if (options.with_peers) return "--peers";
  if (!run.integrators.empty()) return "--integrators";
  if (run.duration) return "--duration";
  if (run.error) return "--error";
  return run.limit != IntegrationOptions().limit ? "--limit" : "";
}

std::string given_for_evaluation(const EvaluationOptions& options) {
  const EvaluationOptions usual;
  if (!options.functions.empty()) return "--functions";
  if (options.is_timed) return "--timed";
  if (options.states != usual.states) return "--states";
  return options.seed != usual.seed ? "--seed" : "";
}

// Options of one part beside what makes the other alone.
void require_their_part(const ReportOptions& options) {
  if (const std::string name = given_for_integration(options); !options.integrates() && !name.empty())
    refuse(name + ": found it beside " + (options.evaluation_alone ? "--evaluation" : "--functions"),
           "with integration");
  if (const std::string name = given_for_evaluation(options.evaluation); !options.evaluates() && !name.empty())
    refuse(name + ": found it beside --integration", "with --evaluation");
}

void check_options(const ReportOptions& options) {
  for (const std::string& name : options.integration.integrators) integrate::method_of(name);
  require_one_format(options);
  if (options.evaluation_alone && options.integration_alone)
    refuse("--evaluation: found it beside --integration", "one of them; without either both are made");
  require_their_part(options);
  if (options.csv && options.evaluates() && options.integrates())
    refuse("--csv: found two tables to write", "it beside --evaluation or --integration");
  if (is_same_file(options.plot, options.output)) refuse("--plot, --output: found the same file", "a file each");
}

// Other engines that integrate.
std::vector<Peer> integrating_peers() {
  std::vector<Peer> list;
  for (Peer& peer : peers_beside_program())
    if (peer.functions().n_integrators > 0) list.push_back(std::move(peer));
  if (list.empty())
    refuse("--peers: found no other engine in the folder peers beside kanec",
           "where libsimbody-dev or libmujoco-dev was installed when kanec was built");
  return list;
}

// What the other reports read.
bool asks_for_more(const ReportOptions& options) {
  return !options.connection.empty() || options.csv || !options.plot.empty() || options.evaluation_alone ||
         options.integration_alone || !given_for_integration(options).empty() ||
         !given_for_evaluation(options.evaluation).empty();
}

int report_hard(const ReportOptions& options) {
  require_one_format(options);
  if (asks_for_more(options))
    refuse("--hard: found it beside other reports", "folders of cases, --short, --json, --markdown, --output");
  if (hard::report_hard_cases(
          {options.scenes, options.brief, options.json, options.markdown, options.output, options.build}))
    return success;
  remark("not everything was kept to what it is allowed");
  return check_failed;
}

int report_all(const ReportOptions& given) {
  ReportOptions options = given;
  if (options.hard) return report_hard(options);
  if (options.brief) refuse("--short: found it without --hard", "with --hard");
  options.integration.integrators = names_in(given.integration.integrators, "--integrators");
  check_options(options);
  if (options.with_peers) options.integration.peers = integrating_peers();
  const std::vector<scene::Scene> scenes = load_all(options.scenes, options.connection);
  AtomicFile file(options.output);
  std::deque<AtomicFile> pictures;
  std::vector<std::string> files;
  if (!options.plot.empty()) files = picture_files(options, scenes);
  for (const std::string& name : files) pictures.emplace_back(name);
  Findings findings = found(options, scenes);
  std::vector<AtomicFile*> written;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (!(options.draws_evaluation() ? findings.errors[i].failure : findings.runs[i].failure).empty()) continue;
    pictures[i].write(options.draws_evaluation() ? evaluation_svg(findings.errors[i])
                                                 : integration_svg(findings.runs[i]));
    written.push_back(&pictures[i]);
    if (!options.draws_evaluation()) findings.runs[i].picture = files[i];
  }
  file.write(text_of(findings, options));
  written.push_back(&file);
  commit_all(written);
  const std::vector<std::string> failures = findings.failures();
  for (const std::string& failure : failures) remark_lines(failure);
  return failures.empty() ? success : check_failed;
}

void add_parts(CLI::App& command, ReportOptions& options) {
  command.add_flag("--evaluation", options.evaluation_alone, "rounding errors of functions alone");
  command.add_flag("--integration", options.integration_alone, "integrators alone");
  command.add_flag("--hard", options.hard, "hard cases: folders with a hard.toml, or of such folders (models/hard)");
  command.add_flag("--short", options.brief, "hard cases at the length of the tests");
}

void add_evaluation(CLI::App& command, EvaluationOptions& options) {
  add_functions(command, options.functions);
  command.add_option("--states", options.states, "random states (32)")
      ->option_text("NUMBER")
      ->check(CLI::Range(1, 1000000));
  command.add_option("--seed", options.seed, "of the random states (1)")->option_text("NUMBER");
  command.add_flag("--timed", options.is_timed, "emitted variants compiled: time beside error, lanes beside scalar");
}

void add_integration(CLI::App& command, ReportOptions& options) {
  const std::string group = "Integration";
  IntegrationOptions& run = options.integration;
  command
      .add_option("--integrators", run.integrators,
                  fmt::format("these alone ({})", fmt::join(integrate::method_names(), ", ")))
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false)
      ->option_text("a,b,...")
      ->group(group);
  command.add_option("--duration", run.duration, "from t = 0 (the scene's) [s]")
      ->option_text("SECONDS")
      ->check(positive())
      ->group(group);
  command.add_option("--error", run.error, "to recommend an integrator for (1e-3, 1e-6, 1e-9 and 1e-12)")
      ->option_text("NUMBER")
      ->check(positive())
      ->group(group);
  command.add_option("--limit", run.limit, "wall time of one run, of the reference's five times that (1) [s]")
      ->option_text("SECONDS")
      ->check(within(1e-3, 1e6))
      ->group(group);
  command
      .add_flag("--peers", options.with_peers,
                "other engines' integrators beside them (Simbody, MuJoCo), gravity alone")
      ->group(group);
  command
      .add_option("--plot", options.plot,
                  "wall time against error, as a picture (of several scenes FILE_<scene>.svg each); with "
                  "--evaluation nanoseconds against ulps")
      ->option_text("FILE.svg")
      ->group(group);
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(app, action, "report", "speed against error", report_footer, &report_all);
  command->add_option("SCENE", options->scenes, "scene.toml files, folders that hold one, or folders of these")
      ->option_text("...");
  command->add_option("--connection", options->connection, "instead of a scene: the all-symbolic system of this tree")
      ->option_text("L(1),L(2),...");
  add_parts(*command, *options);
  add_evaluation(*command, options->evaluation);
  command->add_flag("--json", options->json, "for machines");
  command->add_flag("--csv", options->csv, "one table for machines");
  command->add_flag("--markdown", options->markdown, "as a page (docs/accuracy.md)");
  command->add_option("-o,--output", options->output, "the report's file, or - (-)")->option_text("FILE");
  add_integration(*command, *options);
  add_build(*command, options->build);
}

}  // namespace kanec::cli
