// kanec eval: one function in one state.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "generator/scene/states.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/cli/arguments.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/scene_argument.hpp"
#include "runtime/model/evaluate.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/model/model.hpp"
#include "runtime/model/result_layout.hpp"
#include "runtime/model/settings.hpp"
#include "runtime/model/state_layout.hpp"
#include "runtime/states/evaluate_many.hpp"
#include "runtime/terminal/interrupt.hpp"
#include "runtime/terminal/output.hpp"
#include "runtime/terminal/progress.hpp"
#include "runtime/text/json.hpp"
#include "runtime/verify/paths.hpp"

namespace kanec::cli {
namespace {

constexpr auto eval_footer = R"(Example: begin with the scene's initial state, change what you like, evaluate
  kanec eval models/six_body accelerations --template > state.json
  kanec eval models/six_body accelerations --input state.json
  kanec eval models/six_body accelerations --input state.json --path generic --json

Functions are those of the scene (an unknown name lists them); several joined by + are evaluated in one call. The input
is one JSON object, of which --template prints the parts that the scene and the function have:
  {"t": 0, "x": {"eps_1": [4 numbers], "theta_2": number, ..., "s_1": [3], ...}, "y": {"omega_1": [3], "thetadot_2": ...},
   "ydot": {"omegadot_1": [3], "thetaddot_2": ...}, "parameters": {name: number}, "inputs": {name: number}}
x is needed always, y and ydot where the function reads them; each of them complete. Without t it is 0 s; a parameter or
input that is left out has the scene's value; --set goes before both. Euler parameters off unit norm by more than rounding
(1e-15) are normalised, with a note where it is more than 1e-6; the output shows the state that was used.

Three paths to a result: emitted (the compiled code), precise (the same program in 50 digits, then rounded), generic
(loops over the scene in long double, sharing no code with the generator, then rounded). Numbers read back exactly.

Many states from a file, results into one of the same kind (or that of -o), a line or row each:
  kanec simulate models/six_body --csv motion.csv && kanec eval models/six_body reactions --states motion.csv -o loads.csv
CSV has a header line of names, in any order (t, coordinates, speeds, their rates, parameters, inputs; theta_2 or
theta_<body>); JSON lines have an object as above a line; NumPy's .npy has x, then y and ydot where the function reads
them, or these behind t, a row a state, float64 or float32.)";

struct EvalArguments {
  SceneArgument scene;
  BuildOptions build;
  std::vector<std::string> settings;
  std::string function, input, path = "emitted";
  std::string states, format, output = "-";
  bool show_template = false;
  bool json = false;
};

std::string read_input(const std::string& path) { return read_file(path == "-" ? "/dev/stdin" : path); }

std::vector<double> rounded(const std::vector<Precise>& values) {
  std::vector<double> result;
  for (const Precise& value : values) result.push_back(value.rounded());
  return result;
}

std::vector<double> evaluate(const EvalArguments& options, const scene::Scene& scene, const State& state) {
  const std::string name = emitted_name(options.function);
  if (options.path == "generic") {
    const auto values = generic_path<long double>(scene, parts_of(options.function), state);
    return {values.begin(), values.end()};
  }
  if (options.path == "precise") return rounded(precise(generate(scene, {{options.function}}).program, name, state));
  return emitted(build(scene, {options.function}, options.build).library.abi(), scene, name, state);
}

std::function<const std::vector<double>&(const State&)> evaluation(const EvalArguments& options,
                                                                   const scene::Scene& scene,
                                                                   const std::optional<CompiledModel>& model) {
  if (model) return compiled_function(model->library.abi(), scene, emitted_name(options.function));
  const auto values = std::make_shared<std::vector<double>>();
  return [&options, &scene, values](const State& state) -> const std::vector<double>& {
    return *values = evaluate(options, scene, state);
  };
}

int evaluate_states(const EvalArguments& options, const scene::Scene& scene, const Needs& needs) {
  if (!options.input.empty() || options.show_template || options.json)
    throw InputError(
        "--states: found it beside --input, --template or --json; allowed: --states FILE with --format and -o");
  const scene::Scene set = with_settings(scene, options.settings);
  const TableFormat format =
      options.format.empty() ? table_format_of_file(options.states) : table_format_of(options.format);
  const TableFormat out = is_standard_output(options.output) ? format : table_format_of_file(options.output);
  const auto states = open_states(options.states, format, set, needs);
  const auto results = open_results(options.output, out, result_layouts(scene, options.function), states->count());
  std::optional<CompiledModel> model;
  if (options.path == "emitted") model = build(scene, {options.function}, options.build);
  const Interrupts interrupts;
  ProgressBar bar(scene.name);
  const ManyStates many = evaluate_many(set, *states, *results, evaluation(options, scene, model), [&](double share) {
    interrupts.poll();
    bar.show(share);
  });
  results->finish();
  if (many.normalised > 0)
    remark("note: Euler parameters of " + counted(static_cast<std::size_t>(many.normalised), "state", "states") +
           " normalised, which were off unit norm by more than 1e-6");
  return 0;
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

State input_state(const EvalArguments& options, const scene::Scene& scene, const Needs& needs) {
  if (options.input.empty())
    throw InputError(
        "--input is not given; allowed: a file, or - for standard input (--template prints one to begin with)");
  const std::string name = options.input == "-" ? "standard input" : options.input;
  ReadState read = read_state(read_input(options.input), name, scene, needs);
  for (const std::string& note : read.notes) remark("note: " + note);
  overrule(scene, options.settings, read.state);
  return read.state;
}

void keep_what_is_read(State& state, const Needs& needs) {
  if (!needs.y) state.y.clear();
  if (!needs.ydot) state.ydot.clear();
}

int print_template(const EvalArguments& options, const scene::Scene& scene, const Needs& needs) {
  State state = initial_state(with_settings(scene, options.settings));
  keep_what_is_read(state, needs);
  print_json(state_json(scene, state));
  return 0;
}

using Layouts = std::vector<Layout>;

std::string text_of(const EvalArguments& options, const scene::Scene& scene, const State& state, const Layouts& layouts,
                    std::span<const double> values) {
  std::string text = fmt::format("{} of {}, {}\n\n", options.function, scene.name, options.path);
  if (reads_time(scene)) text += fmt::format("t [s] = {:.16e}\n\n", state.t);
  text += "x\n" + coordinates_layout(scene).text(state.x);
  if (!state.y.empty()) text += "\ny\n" + speeds_layout(scene).text(state.y);
  if (!state.ydot.empty()) text += "\nydot\n" + speed_rates_layout(scene).text(state.ydot);
  for (const auto* list : {&scene.parameters, &scene.inputs})
    for (std::size_t i = 0; i < list->size(); ++i)
      text += fmt::format("{}{} = {:.16e}\n", i == 0 ? "\n" : "", (*list)[i].name,
                          (list == &scene.parameters ? state.parameters : state.inputs)[i]);
  for (const Layout& layout : layouts) {
    text += "\nresult: " + layout.name + "\n" + layout.text(values.first(layout.size()));
    values = values.subspan(layout.size());
  }
  return text;
}

Json eval_json(const EvalArguments& options, const scene::Scene& scene, const State& state, const Layouts& layouts,
               std::span<const double> values) {
  Json json = {{"model", scene.name}, {"function", options.function}, {"path", options.path}};
  json["state"] = state_json(scene, state);
  Json& result = json["result"] = Json::object();
  for (const Layout& layout : layouts) {
    result[layout.name] = layout.json(values.first(layout.size()));
    values = values.subspan(layout.size());
  }
  return json;
}

// Throws InternalError where names and numbers are not of one length.
Layouts layouts_of(const scene::Scene& scene, const std::string& function, std::size_t n_values) {
  Layouts layouts = result_layouts(scene, function);
  std::size_t named = 0;
  for (const Layout& layout : layouts) named += layout.size();
  if (named != n_values)
    throw InternalError(fmt::format("{}: {} results, {} of them with names", function, n_values, named));
  return layouts;
}

int eval(const EvalArguments& given) {
  EvalArguments options = given;
  if (options.function.empty() && !options.scene.connection.empty()) std::swap(options.function, options.scene.path);
  const scene::Scene scene = load(options.scene);
  const Functions functions(scene);
  functions.check(options.function);
  const Needs needs = functions.needs(options.function);
  if (!options.states.empty()) return evaluate_states(options, scene, needs);
  if (!options.format.empty() || !is_standard_output(options.output))
    throw InputError("--format, --output: found without --states; allowed: with it");
  if (options.show_template) return print_template(options, scene, needs);
  State state = input_state(options, scene, needs);
  const std::vector<double> values = evaluate(options, scene, state);
  const Layouts layouts = layouts_of(scene, options.function, values.size());
  if (std::any_of(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }))
    remark("note: a result is not finite (null in JSON)");
  keep_what_is_read(state, needs);
  print(options.json ? json_text(eval_json(options, scene, state, layouts, values))
                     : text_of(options, scene, state, layouts, values));
  return 0;
}

}  // namespace

void add_eval(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, "eval", "one function in one state or in many, by name, to all digits: for anybody's verification",
      eval_footer, &eval);
  add_scene(*command, options->scene);
  command->add_option("FUNCTION", options->function, "its name, as below")->option_text(" ");
  command->add_option("--input", options->input, "the state as JSON; - is standard input")->option_text("FILE");
  command->add_option("--states", options->states, "many states instead, as below; - is standard input")
      ->option_text("FILE");
  command->add_option("--format", options->format, "of --states (by the file's ending)")
      ->option_text("csv|jsonl|npy")
      ->check(CLI::IsMember({"csv", "jsonl", "npy"}));
  command->add_option("-o,--output", options->output, "of --states: the results' file, or - (-)")->option_text("FILE");
  command->add_flag("--template", options->show_template, "print such a file with the scene's initial state");
  command->add_option("--path", options->path, "how to compute it (emitted)")
      ->option_text("emitted|generic|precise")
      ->check(CLI::IsMember({"emitted", "generic", "precise"}));
  add_settings(*command, options->settings);
  command->add_flag("--json", options->json, "state and result for machines");
  add_build(*command, options->build);
}

}  // namespace kanec::cli
