// kanec check: the emitted code against its oracles.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cstdint>

#include "runtime/base/error.hpp"
#include "runtime/cli/arguments.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/kanec.hpp"
#include "runtime/cli/numbers.hpp"
#include "runtime/cli/scene_argument.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/terminal/interrupt.hpp"
#include "runtime/terminal/output.hpp"
#include "runtime/terminal/progress.hpp"
#include "runtime/text/json.hpp"
#include "runtime/text/table.hpp"
#include "runtime/verify/agreement.hpp"
#include "runtime/verify/samples.hpp"

namespace kanec::cli {
namespace {

constexpr auto check_footer = R"(Example: does the code that g++ -O3 makes of the six bodies compute what they do?
  kanec check models/six_body --flags "-O3 -march=native"
  kanec check models --functions accelerations

Every compiled function is evaluated in seeded random states (the first is the scene's initial one; in every second one
parameters and inputs stand off their defaults) and compared with
  - the same program in 50-digit arithmetic: the rounding error of the emitted code, as the largest error of a
    component in ulps of the largest component of that result (of its median over the states where it cancels to less);
  - the generic numeric path, which loops over the scene and shares no code with the generator, in long double: the
    largest difference of a component relative to that same size. Beside it stands what the path itself loses in double.
A state in which the generic path has no result either (A singular there, or an expression of the scene outside its
domain) is counted as undefined and left out. Derivatives by x are those of the emitted formulas; with the generic
path, which has others off unit norm, they have in common what is along the unit sphere, and that is compared. The
bounds: 200 ulps (roundings mostly cancel: below 20 over trees of 1 to 64 bodies; a wrong term is 1e10 and more)
and 1e-12 from the generic path (200 ulps are 4.4e-14, and the path has an error of its own); where A is so ill
conditioned that the generic path loses 1e-13 and more in double, four times its loss. Exit status 1 beyond.)";

struct CheckArguments {
  SceneArgument scene;
  BuildOptions build;
  int states = 32;
  std::uint64_t seed = 1;
  std::vector<std::string> functions;
  bool all = false;
  Bounds bounds;
  bool json = false;
};

std::string remark_on(const Agreement& a, const Bounds& bounds) {
  const std::string undefined = a.undefined > 0 ? fmt::format("undefined in {} states", a.undefined) : "";
  if (bounds.hold(a)) return undefined;
  return a.undefined == a.states ? "undefined in all states" : "beyond the bound";
}

std::string text_of(const std::vector<Agreement>& list, const Bounds& bounds) {
  std::vector<TextRow> rows = {{"function", "ulps: median", "largest", "in state", "from generic", "its own", ""}};
  for (const Agreement& a : list)
    rows.push_back({a.function, fmt::format("{:.1f}", a.median_ulps), fmt::format("{:.1f}", a.largest_ulps),
                    std::to_string(a.worst_state), fmt::format("{:.1e}", a.generic),
                    fmt::format("{:.1e}", a.generic_double), remark_on(a, bounds)});
  return text_table(rows, "lrrrrrl");
}

Json check_json(const std::vector<Agreement>& list, const Bounds& bounds) {
  Json functions = Json::array();
  for (const Agreement& a : list)
    functions.push_back({{"name", a.function},
                         {"largest_ulps", a.largest_ulps},
                         {"median_ulps", a.median_ulps},
                         {"worst_state", a.worst_state},
                         {"generic", a.generic},
                         {"generic_double", a.generic_double},
                         {"undefined_states", a.undefined},
                         {"passed", bounds.hold(a)}});
  return functions;
}

std::string verdict(const std::vector<Agreement>& list, const Bounds& bounds) {
  std::vector<std::string> beyond;
  for (const Agreement& a : list)
    if (!bounds.hold(a))
      beyond.push_back(a.undefined == a.states ? a.function + " (undefined in every state: is A singular?)"
                                               : fmt::format("{} ({:.4g} ulps, {:.2g} from the generic path)",
                                                             a.function, a.largest_ulps, a.generic));
  if (beyond.empty()) return "";
  const std::string more = beyond.size() > 1 ? fmt::format(" and {} more", beyond.size() - 1) : "";
  return fmt::format("check failed: {}{}; allowed: {} ulps, {}", beyond.front(), more, brief(bounds.ulps),
                     brief(bounds.generic));
}

std::vector<Agreement> compare(const scene::Scene& scene, const CheckArguments& options, const CompiledModel& model) {
  const std::vector<State> states = samples(scene, options.states, options.seed);
  const Interrupts interrupts;
  ProgressBar bar(scene.name);
  return agreements(scene, model, states, [&](double fraction) {
    interrupts.poll();
    bar.show(fraction);
  });
}

// What was found of one scene; `failure` says what is beyond the bounds, if anything is.
struct Found {
  std::string text, failure;
  Json json;
};

Found found(const scene::Scene& scene, const CheckArguments& options) {
  const Functions functions(scene);
  const CompiledModel model =
      build(scene, options.all ? functions.names() : functions.chosen(options.functions), options.build);
  const std::vector<Agreement> list = compare(scene, options, model);
  const std::string failure = verdict(list, options.bounds);
  return {fmt::format("{}: {} states, seed {}; bounds {} ulps and {} from the generic path in long double\n\n{}",
                      scene.name, options.states, options.seed, brief(options.bounds.ulps),
                      brief(options.bounds.generic), text_of(list, options.bounds)),
          failure,
          {{"model", scene.name},
           {"hash", model.hash()},
           {"states", options.states},
           {"seed", options.seed},
           {"bounds", {{"ulps", options.bounds.ulps}, {"generic", options.bounds.generic}}},
           {"functions", check_json(list, options.bounds)},
           {"passed", failure.empty()}}};
}

int check_all(const std::vector<scene::Scene>& scenes, const CheckArguments& options) {
  int status = success;
  Json all = Json::array();
  for (const scene::Scene& scene : scenes) {
    Found one = found(scene, options);
    if (!options.json) print((all.empty() ? "" : "\n") + one.text);
    if (!one.failure.empty()) {
      remark(scenes.size() > 1 ? scene.name + ": " + one.failure : one.failure);
      status = check_failed;
    }
    all.push_back(std::move(one.json));
  }
  if (options.json) print_json(scenes.size() > 1 ? all : all.front());
  return status;
}

int check(const CheckArguments& options) {
  const bool is_path = !options.scene.path.empty() && options.scene.connection.empty();
  return check_all(is_path ? load_all({options.scene.path}, "") : std::vector{load(options.scene)}, options);
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, "check", "the compiled functions against two independent computations", check_footer, &check);
  add_scene(*command, options->scene, "a scene.toml, a folder that holds one, or a folder of these");
  command->add_option("--states", options->states, "random states (32)")
      ->option_text("NUMBER")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--seed", options->seed, "of the random states (1)")->option_text("NUMBER");
  add_functions(*command, options->functions);
  command->add_flag("--all", options->all, "every function that the scene can have");
  command->add_option("--bound", options->bounds.ulps, "largest error allowed, in ulps (200)")
      ->option_text("ULPS")
      ->check(not_negative());
  command->add_option("--generic-bound", options->bounds.generic, "largest difference from the generic path (1e-12)")
      ->option_text("NUMBER")
      ->check(not_negative());
  command->add_flag("--json", options->json, "report for machines");
  add_build(*command, options->build);
}

}  // namespace kanec::cli
