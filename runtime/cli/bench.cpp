// kanec bench: what an evaluation costs, beside what it costs elsewhere.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/bench/contest_chart.hpp"
#include "runtime/bench/contest_page.hpp"
#include "runtime/bench/contest_text.hpp"
#include "runtime/bench/variants.hpp"
#include "runtime/cli/arguments.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/numbers.hpp"
#include "runtime/cli/scene_argument.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/model/scene_files.hpp"
#include "runtime/terminal/output.hpp"
#include "runtime/text/json.hpp"

namespace kanec::cli {
namespace {

constexpr auto bench_footer =
    R"(Example: functions of S6F, emitted beside generic; then the accelerations of many, as a picture
  kanec bench models/bench_s6f --functions accelerations,residual
  taskset -c 1 kanec bench models/bench_* --svg bench.svg

Processor time per evaluation, one core, by Google Benchmark: 256 random states in turn, five repetitions in random
order of which the median counts, nothing allocated around the emitted call. Generic is runtime/generic in double,
compiled as kanec was; the emitted code is compiled with --flags. Other engines (MuJoCo, Simbody, Bullet, as installed
when kanec was built; docs/benchmarks.md) go their shortest way from a state to accelerations, loads and states put
into their coordinates beforehand. First all are compared with the generic path: what differs by more than 1e-9 (in
float_lanes as many roundings) is not timed. Ratios are to emitted code. Operations are exact counts, not time.

Variants:)";

struct BenchArguments {
  std::vector<std::string> scenes;
  std::string connection;
  BuildOptions build;
  std::vector<std::string> functions;
  std::vector<std::string> variants;
  double min_time = 0.5;
  bool no_peers = false;
  bool json = false;
  bool markdown = false;
  std::string output = "-";
  std::string svg;
};

// Of one scene those that it asks for, or the usual ones; of several, the accelerations.
std::vector<std::string> functions(const BenchArguments& options, const std::vector<scene::Scene>& scenes) {
  if (options.functions.empty() && scenes.size() > 1) return {"accelerations"};
  for (const scene::Scene& scene : scenes) Functions(scene).chosen(options.functions);  // refuses what is not there
  return options.functions;
}

std::string compiler_version(const std::string& wish, compile::Code code) {
  const std::string version = compile::find_compiler(wish, code).version;
  return version.substr(0, version.find('\n'));
}

// "g++ (Debian 12.2.0-14) 12.2.0, -O2 -march=native"
std::string compiler_text(const BuildOptions& arguments) {
  const compile::Options options = compile_options(arguments);
  const std::string scalar = compiler_version(options.compiler, compile::Code::scalar);
  const std::string lanes = compiler_version(options.compiler, compile::Code::lanes);
  const std::vector<std::string> flags = options.flags_given ? options.flags : compile::default_flags();
  return fmt::format("{}{}, {}", scalar, lanes == scalar ? "" : " (lanes: " + lanes + ")", fmt::join(flags, " "));
}

std::string as_text(const std::vector<Contest>& list, const Conditions& conditions) {
  std::string report = fmt::format("processor time per evaluation on {}\nemitted code by {}\n",
                                   fit::line(conditions.processor), fit::line(conditions.compiler));
  for (const Contest& contest : list) report += "\n" + text(contest);
  const std::string notes = footnotes(list);
  return notes.empty() ? report : report + "\n" + notes;
}

std::string as_json(const std::vector<Contest>& list, const Conditions& conditions) {
  Json scenes = Json::array();
  for (const Contest& contest : list) scenes.push_back(json(contest));
  return json_text({{"kanec", version()},
                    {"processor", conditions.processor},
                    {"compiler", conditions.compiler},
                    {"scenes", scenes}});
}

// That writes the same report again, bar the times.
std::string command_of(const BenchArguments& options) {
  std::string command = "kanec bench";
  for (const std::string& scene : options.scenes) command += " " + typed(scene);
  if (!options.connection.empty()) command += " --connection " + fit::shell(options.connection);
  if (!options.functions.empty())
    command += " --functions " + fit::shell(fmt::format("{}", fmt::join(options.functions, ",")));
  if (!options.variants.empty())
    command += " --variants " + fit::shell(fmt::format("{}", fmt::join(options.variants, ",")));
  command += options.no_peers ? " --no-peers" : "";
  command += build_text(options.build);
  command += options.build.no_cache ? " --no-cache" : "";
  command += is_standard_output(options.output) ? " --markdown" : " --markdown -o " + fit::shell(options.output);
  return options.svg.empty() ? command : command + " --svg " + fit::shell(options.svg);
}

std::string report_of(const std::vector<Contest>& list, const BenchArguments& options) {
  const Conditions conditions{processor_name(), compiler_text(options.build)};
  if (options.json) return as_json(list, conditions);
  if (options.markdown) return page(list, conditions, command_of(options), options.svg);
  return as_text(list, conditions);
}

int bench(const BenchArguments& options) {
  if (options.json && options.markdown) throw InputError("--json: found it beside --markdown; allowed: one of them");
  if (is_same_file(options.svg, options.output))
    throw InputError("--svg, --output: found the same file; allowed: a file each");
  AtomicFile report(options.output);
  std::optional<AtomicFile> picture;
  if (!options.svg.empty()) picture.emplace(options.svg);
  const std::vector<scene::Scene> scenes = load_all(options.scenes, options.connection);
  const ContestOptions contest{functions(options, scenes), variants(options.variants, options.build),
                               options.no_peers ? std::vector<Peer>{} : peers_beside_program(), options.min_time};
  const std::vector<Contest> list = contests(scenes, contest);
  std::vector<AtomicFile*> files = {&report};
  if (picture) {
    picture->write(chart(list, {processor_name(), compiler_text(options.build)}));
    files.insert(files.begin(), &*picture);
  }
  report.write(report_of(list, options));
  commit_all(files);
  return 0;
}

std::string variants_help() {
  std::string names;
  for (const NamedVariant& one : variants_known()) names += one.name + ", ";
  return "other ways to emit and compile, beside the default (all, " + names.substr(0, names.size() - 2) + ")";
}

}  // namespace

void add_bench(CLI::App& app, Action& action) {
  std::string more = bench_footer;
  for (const NamedVariant& one : variants_known()) more += fmt::format("\n  {:<12} {}", one.name, one.meaning);
  const auto [command, options] =
      add_command(app, action, "bench", "time per evaluation, emitted beside generic and other engines", more, &bench);
  command->add_option("SCENE", options->scenes, "scene.toml files, or folders that hold one")->option_text("...");
  command->add_option("--connection", options->connection, "instead of a scene: the all-symbolic system of this tree")
      ->option_text("L(1),L(2),...");
  add_functions(*command, options->functions);
  command->add_option("--variants", options->variants, variants_help())
      ->delimiter(',')
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false)
      ->option_text("all|a,b,...");
  command->add_option("--min-time", options->min_time, "for each function and path (0.5) [s]")
      ->option_text("SECONDS")
      ->check(within(0.001, 3600.0));
  command->add_flag("--no-peers", options->no_peers, "without other engines");
  command->add_flag("--json", options->json, "report for machines");
  command->add_flag("--markdown", options->markdown, "report as a page (docs/benchmarks.md)");
  command->add_option("-o,--output", options->output, "the report's file, or - (-)")->option_text("FILE");
  command->add_option("--svg", options->svg, "a picture as well: bars on a logarithmic axis")->option_text("FILE");
  add_build(*command, options->build);
}

}  // namespace kanec::cli
