// kanec bench: what an evaluation costs, beside what it costs elsewhere. SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/cli/bench/contest_chart.hpp"
#include "runtime/cli/bench/contest_text.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/functions.hpp"
#include "runtime/cli/scene_argument.hpp"

namespace kanec::cli {
namespace {

constexpr auto footer = R"(Examples: the functions of S6F, emitted beside generic; then the accelerations of many, as a picture
  kanec bench models/bench_s6f --functions accelerations,residual
  taskset -c 1 kanec bench models/bench_* --svg bench.svg

Processor time per evaluation, one core, by Google Benchmark: 256 random states in turn, five repetitions in random
order of which the median counts, nothing allocated around the emitted call. Generic is runtime/generic in double,
compiled as kanec was; the emitted code is compiled with --flags. Other engines (MuJoCo, Simbody, Bullet, as installed
when kanec was built; docs/benchmarks.md) go their shortest way from a state to accelerations, loads and states put
into their coordinates beforehand. First all are compared with the generic path, emitted code within the bounds of
`kanec check`: what is wrong is not timed. Ratios are to emitted code. Operations are exact counts, not time.)";

struct Options {
  std::vector<std::string> scenes;
  std::string connection;
  BuildArguments build;
  std::vector<std::string> functions;
  double min_time = 0.5;
  bool no_peers = false;
  bool json = false;
  std::string svg;
};

std::vector<scene::Scene> load(const Options& options) {
  std::vector<scene::Scene> list;
  for (const std::string& path : options.scenes) list.push_back(cli::load(SceneArgument{path, options.connection}));
  if (list.empty()) list.push_back(cli::load(SceneArgument{"", options.connection}));
  return list;
}

// Of one scene those that it asks for, or the usual ones; of several, the accelerations.
std::vector<std::string> functions(const Options& options, const std::vector<scene::Scene>& scenes) {
  if (options.functions.empty() && scenes.size() > 1) return {"accelerations"};
  for (const scene::Scene& scene : scenes) Functions(scene).chosen(options.functions);  // refuses what is not there
  return options.functions;
}

// "g++ (Debian 12.2.0-14) 12.2.0, -O2 -march=native"
std::string compiler_text(const BuildArguments& arguments) {
  const compile::Options options = compile_options(arguments);
  const std::string version = compile::find_compiler(options.compiler).version;
  const std::vector<std::string> flags = options.flags_given ? options.flags : compile::default_flags();
  return fmt::format("{}, {}", version.substr(0, version.find('\n')), fmt::join(flags, " "));
}

void report(const std::vector<Contest>& list, const Conditions& conditions, bool as_json) {
  if (as_json) {
    Json scenes = Json::array();
    for (const Contest& contest : list) scenes.push_back(json(contest));
    return print_json({{"kanec", version()},
                       {"processor", conditions.processor},
                       {"compiler", conditions.compiler},
                       {"scenes", scenes}});
  }
  print(fmt::format("processor time per evaluation on {}\nemitted code by {}\n", conditions.processor,
                    conditions.compiler));
  for (const Contest& contest : list) print("\n" + text(contest));
}

int bench(const Options& options) {
  const std::vector<scene::Scene> scenes = load(options);
  const ContestOptions contest{{{"emitted", {functions(options, scenes)}, options.build}},
                               options.no_peers ? std::vector<Peer>{} : peers_beside_program(),
                               options.min_time};
  const std::vector<Contest> list = contests(scenes, contest);
  const Conditions conditions{processor_name(), compiler_text(options.build)};
  if (!options.svg.empty()) write_file(options.svg, chart(list, conditions));
  report(list, conditions, options.json);
  return 0;
}

}  // namespace

void add_bench(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, "bench", "time per evaluation, emitted beside generic and other engines", footer, &bench);
  command->add_option("SCENE", options->scenes, "scene.toml files, or folders that hold one")->option_text("...");
  command->add_option("--connection", options->connection, "instead of a scene: the all-symbolic system of this tree")
      ->option_text("L(1),L(2),...");
  add_functions(*command, options->functions);
  command->add_option("--min-time", options->min_time, "for each function and path (0.5) [s]")
      ->option_text("SECONDS")
      ->check(CLI::Range(0.001, 3600.0));
  command->add_flag("--no-peers", options->no_peers, "without other engines");
  command->add_flag("--json", options->json, "report for machines");
  command->add_option("--svg", options->svg, "a picture as well: bars on a logarithmic axis")->option_text("FILE");
  add_build(*command, options->build);
}

}  // namespace kanec::cli
