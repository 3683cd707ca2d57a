// kanec eval: one function in one state. SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/layout.hpp"
#include "runtime/cli/model.hpp"
#include "runtime/cli/paths.hpp"
#include "runtime/cli/scene_argument.hpp"
#include "runtime/cli/settings.hpp"

namespace kanec::cli {
namespace {

constexpr auto footer = R"(Example: begin with the scene's initial state, change what you like, evaluate
  kanec eval models/six_body accelerations --template > state.json
  kanec eval models/six_body accelerations --input state.json
  kanec eval models/six_body accelerations --input state.json --path generic --json

Functions: kinematics, mass_matrix, forcing, residual, accelerations, partial_velocities, partial_velocity_rates,
energy, momentum, poses, power. The input is one JSON object
  {"x": {"eps_1": [4 numbers], ..., "s_1": [3], ...}, "y": {"omega_1": [3], ..., "sdot_1": [3], ...},
   "ydot": {"omegadot_1": [3], ..., "sddot_1": [3], ...}, "parameters": {name: number}, "inputs": {name: number}}
x is needed always, y and ydot where the function reads them; each of them complete. A parameter or input that is left
out has the scene's value; --set goes before both. Euler parameters off unit norm by more than rounding (1e-15) are
normalised, with a note where it is more than 1e-6; the output shows the state that was used.

Three paths to a result: emitted (the compiled code), precise (the same program in 50 digits, then rounded), generic
(loops over the scene in long double, sharing no code with the generator, then rounded). Numbers read back exactly.)";

struct Options {
  SceneArgument scene;
  BuildArguments build;
  std::vector<std::string> settings;
  std::string function, input, path = "emitted";
  bool show_template = false;
  bool json = false;
};

std::string read_input(const std::string& path) { return read_file(path == "-" ? "/dev/stdin" : path); }

std::vector<double> rounded(const std::vector<Precise>& values) {
  std::vector<double> result;
  for (const Precise& value : values) result.push_back(value.rounded());
  return result;
}

std::vector<double> evaluate(const Options& options, const scene::Scene& scene, const State& state) {
  if (options.path == "generic") {
    const auto values = generic_path<long double>(scene, options.function, state);
    return {values.begin(), values.end()};
  }
  if (options.path == "precise")
    return rounded(precise(generate(scene, {{options.function}}).program, options.function, state));
  return emitted(build(scene, {options.function}, options.build).library.abi(), options.function, state);
}

// The values of --set go before those of the file.
void overrule(scene::Scene scene, const std::vector<std::string>& settings, State& state) {
  for (std::size_t i = 0; i < scene.parameters.size(); ++i) scene.parameters[i].value = state.parameters[i];
  for (std::size_t i = 0; i < scene.inputs.size(); ++i) scene.inputs[i].value = state.inputs[i];
  if (settings.empty()) check_defaults(scene, "--input");
  const scene::Scene set = with_settings(scene, settings);
  state.parameters = default_parameters(set);
  state.inputs = default_inputs(set);
}

State input_state(const Options& options, const scene::Scene& scene) {
  if (options.input.empty())
    throw InputError(
        "--input is not given; allowed: a file, or - for standard input (--template prints one to begin with)");
  const std::string name = options.input == "-" ? "standard input" : options.input;
  ReadState read = read_state(read_input(options.input), name, scene, needs_of(scene, options.function));
  for (const std::string& note : read.notes) remark("note: " + note);
  overrule(scene, options.settings, read.state);
  return read.state;
}

void keep_what_is_read(State& state, const Needs& needs) {
  if (!needs.y) state.y.clear();
  if (!needs.ydot) state.ydot.clear();
}

int print_template(const Options& options, const scene::Scene& scene) {
  State state = initial_state(with_settings(scene, options.settings));
  keep_what_is_read(state, needs_of(scene, options.function));
  print_json(state_json(scene, state));
  return 0;
}

std::string text_of(const Options& options, const scene::Scene& scene, const State& state, const Layout& layout,
                    const std::vector<double>& values) {
  std::string text = fmt::format("{} of {}, {}\n\nx\n{}", options.function, scene.name, options.path,
                                 coordinates_layout(scene).text(state.x));
  if (!state.y.empty()) text += "\ny\n" + speeds_layout(scene).text(state.y);
  if (!state.ydot.empty()) text += "\nydot\n" + speed_rates_layout(scene).text(state.ydot);
  for (const auto* list : {&scene.parameters, &scene.inputs})
    for (std::size_t i = 0; i < list->size(); ++i)
      text += fmt::format("{}{} = {:.16e}\n", i == 0 ? "\n" : "", (*list)[i].name,
                          (list == &scene.parameters ? state.parameters : state.inputs)[i]);
  return text + "\nresult: " + layout.name + "\n" + layout.text(values);
}

Json json_of(const Options& options, const scene::Scene& scene, const State& state, const Layout& layout,
             const std::vector<double>& values) {
  Json json = {{"model", scene.name}, {"function", options.function}, {"path", options.path}};
  json["state"] = state_json(scene, state);
  json["result"] = {{layout.name, layout.json(values)}};
  return json;
}

int eval(const Options& given) {
  Options options = given;
  if (options.function.empty() && !options.scene.connection.empty()) std::swap(options.function, options.scene.path);
  const scene::Scene scene = load(options.scene);
  check_function(scene, options.function);
  if (options.show_template) return print_template(options, scene);
  State state = input_state(options, scene);
  const std::vector<double> values = evaluate(options, scene, state);
  const Layout layout = result_layout(scene, options.function);
  if (std::any_of(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }))
    remark("note: a result is not finite (null in JSON)");
  keep_what_is_read(state, needs_of(scene, options.function));
  if (options.json)
    print_json(json_of(options, scene, state, layout, values));
  else
    print(text_of(options, scene, state, layout, values));
  return 0;
}

}  // namespace

void add_eval(CLI::App& app, Action& action) {
  const auto [command, options] =
      add_command(app, action, "eval", "one function in one state, by name, to all digits: for anybody's verification",
                  footer, &eval);
  add_scene(*command, options->scene);
  command->add_option("FUNCTION", options->function, "its name, as below")->option_text(" ");
  command->add_option("--input", options->input, "the state as JSON; - is standard input")->option_text("FILE");
  command->add_flag("--template", options->show_template, "print such a file with the scene's initial state");
  command->add_option("--path", options->path, "how to compute it (emitted)")
      ->option_text("emitted|generic|precise")
      ->check(CLI::IsMember({"emitted", "generic", "precise"}));
  add_settings(*command, options->settings);
  command->add_flag("--json", options->json, "state and result for machines");
  add_build(*command, options->build);
}

}  // namespace kanec::cli
