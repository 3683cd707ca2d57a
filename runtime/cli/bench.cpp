// kanec bench: what an evaluation costs. SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runtime/base/error.hpp"
#include "runtime/cli/agreement.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/dump.hpp"
#include "runtime/cli/functions.hpp"
#include "runtime/cli/samples.hpp"
#include "runtime/cli/scene_argument.hpp"
#include "runtime/cli/table.hpp"
#include "runtime/cli/timing.hpp"

namespace kanec::cli {
namespace {

constexpr auto footer = R"(Example: the accelerations of S6F, emitted beside generic
  kanec bench models/bench_s6f --functions accelerations,residual

Processor time per evaluation, one core, by Google Benchmark: 256 random states in turn, five repetitions in random
order of which the median counts, nothing allocated around the emitted call. Generic is runtime/generic in double,
compiled as kanec was; the emitted code is compiled with --flags. First both are compared, within the bounds of
`kanec check`: what is wrong is not timed. Operations are exact counts, not time.)";

constexpr int compared_states = 4;

struct Options {
  SceneArgument scene;
  BuildArguments build;
  std::vector<std::string> functions;
  double min_time = 0.5;
  bool json = false;
};

void require_agreement(const scene::Scene& scene, const CompiledModel& model) {
  const Bounds bounds;
  for (const Agreement& a : agreements(scene, model, samples(scene, compared_states, 1), [](double) {}))
    if (!bounds.hold(a))
      throw InputError(
          fmt::format("{}: emitted and generic differ by {:.2g}, rounding is {:.4g} ulps: not timed; "
                      "kanec check tells more",
                      a.function, a.generic, a.largest_ulps));
}

// "g++ (Debian 12.2.0-14) 12.2.0, -O2 -march=native"
std::string compiler_text(const BuildArguments& arguments) {
  const compile::Options options = compile_options(arguments);
  const std::string version = compile::find_compiler(options.compiler).version;
  const std::vector<std::string> flags = options.flags_given ? options.flags : compile::default_flags();
  return fmt::format("{}, {}", version.substr(0, version.find('\n')), fmt::join(flags, " "));
}

std::string text_of(const program::Program& program, const std::vector<Timing>& list) {
  std::vector<TextRow> rows = {{"function", "emitted", "generic", "ratio", "operations", "operations"}};
  for (std::size_t i = 0; i < list.size(); ++i) {
    const program::Ledger cost = program::ledger(program, program.functions[i]);
    rows.push_back({list[i].function, fmt::format("{:.1f} ns", list[i].emitted),
                    fmt::format("{:.1f} ns", list[i].generic), fmt::format("{:.1f}", list[i].ratio()),
                    std::to_string(cost.operations()), program::text(cost)});
  }
  rows[0].back() = "of which";
  return text_table(rows, "lrrrrl");
}

Json json_of(const program::Program& program, const std::vector<Timing>& list) {
  Json functions = ledgers_json(program);
  for (std::size_t i = 0; i < list.size(); ++i)
    functions[i].update({{"emitted_ns", list[i].emitted}, {"generic_ns", list[i].generic}, {"ratio", list[i].ratio()}});
  return functions;
}

int bench(const Options& options) {
  const scene::Scene scene = load(options.scene);
  const CompiledModel model = build(scene, Functions(scene).chosen(options.functions), options.build);
  require_agreement(scene, model);
  const std::vector<Timing> list = timings(scene, model, options.min_time);
  const program::Program& program = model.generated.program;
  const std::string compiler = compiler_text(options.build);
  if (options.json)
    print_json({{"model", scene.name},
                {"hash", model.generated.hash},
                {"compiler", compiler},
                {"functions", json_of(program, list)}});
  else
    print(fmt::format("{}: processor time per evaluation\nemitted code by {}\n\n{}", scene.name, compiler,
                      text_of(program, list)));
  return 0;
}

}  // namespace

void add_bench(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, "bench", "time per evaluation, emitted beside generic, with the operations", footer, &bench);
  add_scene(*command, options->scene);
  add_functions(*command, options->functions);
  command->add_option("--min-time", options->min_time, "for each function and path (0.5) [s]")
      ->option_text("SECONDS")
      ->check(CLI::Range(0.001, 3600.0));
  command->add_flag("--json", options->json, "report for machines");
  add_build(*command, options->build);
}

}  // namespace kanec::cli
