// kanec simulate: a scene compiled and integrated.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <array>
#include <map>
#include <optional>

#include "generator/read/check.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/base/text.hpp"
#include "runtime/cli/arguments.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/numbers.hpp"
#include "runtime/cli/scene_argument.hpp"
#include "runtime/ensemble/ensemble.hpp"
#include "runtime/model/evaluate.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/model/model.hpp"
#include "runtime/model/settings.hpp"
#include "runtime/model/state_file.hpp"
#include "runtime/picture/plot.hpp"
#include "runtime/run/conservation.hpp"
#include "runtime/run/integration_options.hpp"
#include "runtime/run/needed_functions.hpp"
#include "runtime/run/resume.hpp"
#include "runtime/run/summary.hpp"
#include "runtime/run/watched_events.hpp"
#include "runtime/terminal/interrupt.hpp"
#include "runtime/terminal/output.hpp"
#include "runtime/terminal/progress.hpp"
#include "runtime/text/json.hpp"
#include "runtime/trajectory/trajectory.hpp"
#include "runtime/verify/paths.hpp"

namespace kanec::cli {
namespace {

constexpr auto simulate_footer =
    R"(Example: the six bodies with a heavier payload and no thrust, 20 s, as numbers and as a picture
  kanec simulate models/six_body --set m_payload=2.5 --set thrust=0 --duration 20 --csv six.csv --plot six.svg

What is not given here is as in the scene's [simulate]. Euler parameters have unit norm: lie4, gauss4 and gauss6 keep it
by themselves; cvode and ida project the rows, and start anew from projected values once the norm has drifted; the other
integrators project after every step. The summary says how far they were off at the ends of steps, before that. Energy
change minus work, and where nothing acts from outside the momenta too, would be zero if there were no errors.
Prescribed coordinates do work that no function of the model adds up: with them that difference is their work, and
energy is no check. The CSV has a column a coordinate, speed and energy, with units in its header, every number exact;
--csv - writes it to standard output, and the summary goes to standard error. --final leaves the last state as
`kanec eval --input` takes it.

Where the scene has [[event]] tables the summary lists what happened when, and the CSV shows the inputs that events set.
A run that fails or is interrupted (Ctrl-C) says where, and leaves the rows until then; a longer run, a mended one or the
same again goes on from the last of them
  kanec simulate models/pendulum --duration 5 --csv swing.csv
  kanec simulate models/pendulum --duration 9 --resume swing.csv --csv swing.csv

Many runs at once: --ensemble takes a CSV file whose columns are named as coordinates, speeds, parameters or inputs (others
stay as the scene has them), a line a scenario; or draws them as the scene's [ensemble] says
  kanec simulate models/cart_pole --ensemble runs.csv --integrator rk4 --csv ends.csv
With rk4 the scenarios run side by side in the processor's vector registers, which is the fastest by far; with every other
integrator one in each thread. Results do not depend on the number of threads. --csv then has a line a scenario, its end
or with --keep-every its rows; a scenario that stops early has its last finite row there, and the summary tells of it.)";

struct SimulateArguments {
  SceneArgument scene;
  BuildOptions build;
  std::vector<std::string> settings;
  std::optional<double> duration, output_step, step, longest_step, relative_tolerance, absolute_tolerance;
  std::optional<std::string> integrator, jacobian;
  std::optional<int> order;
  EnsembleArguments ensemble;
  std::string csv, plot, final_state, resume;
  bool json = false;
};

// The scene's settings, overruled by the command line, each judged where it stands.
scene::Simulation simulation_of(const scene::Scene& scene, const SimulateArguments& options) {
  scene::Simulation run = scene.simulation;
  std::map<std::string, std::string> given;  // the option in place of a key
  const auto overrule = [&](const char* key, const char* name, const auto& option, auto& value) {
    if (!option) return;
    value = *option;
    given[key] = name;
  };
  overrule("duration", "--duration", options.duration, run.duration);
  overrule("output_step", "--output-step", options.output_step, run.output_step);
  overrule("integrator", "--integrator", options.integrator, run.integrator);
  overrule("step", "--step", options.step, run.step);
  overrule("longest_step", "--longest-step", options.longest_step, run.longest_step);
  overrule("relative_tolerance", "--rtol", options.relative_tolerance, run.relative_tolerance);
  overrule("absolute_tolerance", "--atol", options.absolute_tolerance, run.absolute_tolerance);
  overrule("jacobian", "--jacobian", options.jacobian, run.jacobian);
  overrule("order", "--order", options.order, run.order);
  scene::check_simulation(run, [&](const std::string& key) {
    const auto option = given.find(key);
    return option != given.end() ? scene::Place{option->second} : scene::Place{scene.name, 0, "", "simulate." + key};
  });
  return run;
}

bool takes_standard_output(const SimulateArguments& options) {
  return is_standard_output(options.csv) || is_standard_output(options.plot) ||
         is_standard_output(options.final_state) || is_standard_output(options.ensemble.drawn);
}

void refuse_same_file(const SimulateArguments& options) {
  if (options.json && takes_standard_output(options))
    throw InputError("--json: found it beside a file on standard output; allowed: one of them");
  const std::string read = options.ensemble.from == "-" ? "" : options.ensemble.from;  // standard input is no file
  const std::array<std::string, 5> files = {options.csv, options.plot, options.final_state, options.ensemble.drawn,
                                            read};
  for (std::size_t i = 0; i < files.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (is_same_file(files[i], files[j]))
        throw InputError("--csv, --plot, --final, --drawn, --ensemble: found '" + files[i] +
                         "' twice; allowed: a file each");
  if (is_same_file(options.plot, options.resume) || is_same_file(options.final_state, options.resume))
    throw InputError("--resume: found its file '" + options.resume +
                     "' as --plot or --final; allowed: --csv to go on in");
}

// What the run leaves behind; each file is opened before the run and appears after it.
class Outputs {
 public:
  // rows_before: of the trajectory that the run goes on from.
  Outputs(const SimulateArguments& options, const scene::Scene& scene, const std::string& rows_before) {
    refuse_same_file(options);
    csv_path_ = options.csv;
    const StateNames names = trajectory_names(scene);
    if (!options.csv.empty()) csv_.emplace(options.csv, names, true);
    if (csv_ && is_same_file(options.csv, options.resume)) csv_->add_text(rows_before);
    if (!options.plot.empty()) plot_.emplace(options.plot, names, true, has_drives(scene));
    if (!options.final_state.empty()) final_.emplace(options.final_state);
  }

  void add(const Row& row) {
    end_ = row.t;
    if (csv_) csv_->add(row);
    if (plot_) plot_->add(row);
  }

  // After a run that failed or was interrupted: the rows until there. Says until when [s], where there are any.
  std::optional<double> keep_rows() {
    if (!csv_ || !end_) return std::nullopt;
    csv_->finish();
    return end_;
  }

  // All of them, or none; but rows that were integrated are kept whatever befalls the rest, which the message says.
  void finish(const Json& final_state) {
    try {
      if (plot_) plot_->draw();
      if (final_) final_->write(json_text(final_state));
      commit_all(files());
    } catch (const FileError& error) {
      if (!csv_) throw;
      csv_->finish();
      throw Error(error.what() + std::string("; the rows are in ") + csv_path_);
    }
  }

 private:
  std::vector<AtomicFile*> files() {
    std::vector<AtomicFile*> list;
    if (plot_) list.push_back(&plot_->file());
    if (final_) list.push_back(&*final_);
    if (csv_) list.push_back(&csv_->file());
    return list;
  }

  std::string csv_path_;
  std::optional<Trajectory> csv_;
  std::optional<Plot> plot_;
  std::optional<AtomicFile> final_;
  std::optional<double> end_;  // time of the last row [s]
};

// What the integrator calls, and what the summary tells of.
std::vector<std::string> functions_for(const scene::Scene& scene, integrate::Options& run) {
  std::vector<std::string> list = functions_to_integrate(scene, run);
  list.insert(list.end(), {"energy", "momentum"});
  return list;
}

// " (body 3, arm)" of the component that a message names.
std::string body_named(const scene::Scene& scene, const std::string& message) {
  const std::string words = message + " ";
  const StateNames known = state_names(scene);
  for (const auto& names : {known.coordinates, known.speeds})
    for (const std::string& name : names) {
      if (words.find(" " + name + " ") == std::string::npos) continue;
      const int k = component_of(name, known.bodies).body;
      return " (body " + std::to_string(k) + ", " + scene.bodies[static_cast<std::size_t>(k - 1)].name + ")";
    }
  return "";
}

Summary integrate_model(const kanec_model& model, const scene::Scene& scene, const State& start,
                        const integrate::Options& options, Outputs& outputs, const Interrupts& interrupts) {
  const Solver solver = solver_of(model, scene, start);
  ProgressBar bar(scene.name);
  const auto progress = [&](double fraction) {
    interrupts.poll();
    bar.show(fraction);
  };
  return simulate(
      solver, start.x, start.y, options, [&](const auto& row) { outputs.add(row); }, progress);
}

State final_state(const scene::Scene& scene, const Summary& summary) {
  // without events the model may read some of the inputs alone
  const std::vector<double> inputs = scene.events.empty() ? default_inputs(scene) : summary.inputs;
  return {summary.t, summary.x, summary.y, {}, default_parameters(scene), inputs};
}

// An input that events set has a column, where its value is from.
void refuse_set_columns(const SimulateArguments& options, const scene::Scene& scene) {
  for (const std::string& input : trajectory_names(scene).inputs)
    for (const std::string& setting : options.settings)
      if (setting.substr(0, setting.find('=')) == input)
        throw InputError("--set: found '" + setting + "' beside --resume; allowed: inputs that are no column of " +
                         options.resume + ", which holds the value of " + input);
}

// The scene's own start, or where a trajectory ends.
Resumed start_of(const SimulateArguments& options, const scene::Scene& scene, integrate::Options& run) {
  if (options.resume.empty()) return {initial_state(scene), 0.0, {}};
  refuse_set_columns(options, scene);
  Resumed resumed = read_trajectory(read_file(options.resume, most_of_a_table), options.resume, scene);
  run.start = resumed.state.t;
  run.work = resumed.work;
  if (run.duration < run.start)
    throw InputError("--resume: found a trajectory until " + shortest(run.start) +
                     " s; allowed: one that ends before " + shortest(run.duration) + " s, the duration");
  return resumed;
}

[[noreturn]] void tell_failure(const IntegrationError& error, const SimulateArguments& options,
                               const scene::Scene& scene, Outputs& outputs) {
  std::string message = error.what() + body_named(scene, error.what());
  if (outputs.keep_rows()) message += "; the rows until there are in " + options.csv;
  throw IntegrationError(message);
}

[[noreturn]] void tell_interruption(const SimulateArguments& options, Outputs& outputs) {
  const std::optional<double> end = outputs.keep_rows();
  if (!end) throw Interrupted();
  const std::string rows = "; the rows until " + shortest(*end) + " s are ";
  if (is_standard_output(options.csv)) throw Interrupted(rows + "on standard output");
  throw Interrupted(rows + "in " + options.csv + ", and --resume " + fit::shell(options.csv) + " goes on from there");
}

int simulate_many(const SimulateArguments& options, const scene::Scene& scene, const integrate::Options& run) {
  refuse_same_file(options);
  if (!options.plot.empty() || !options.final_state.empty())
    throw InputError("--plot, --final: found beside --ensemble; allowed: --csv, which has every scenario's end");
  if (!options.resume.empty()) throw InputError("--resume: found beside --ensemble; allowed: one run");
  if (!scene.events.empty())
    throw InputError("--ensemble: found a scene with [[event]] tables; allowed: one without, or single runs");
  return simulate_ensemble({scene, run, options.ensemble, options.build, options.csv, options.json});
}

int simulate_scene(const SimulateArguments& options) {
  const scene::Scene scene = load(options.scene);
  const scene::Scene set = with_settings(scene, options.settings);
  integrate::Options run = integration_options(set, simulation_of(scene, options));
  if (options.ensemble.is_wanted()) return simulate_many(options, set, run);
  options.ensemble.refuse_without_ensemble();
  const Interrupts interrupts;
  const Resumed resumed = start_of(options, set, run);
  Outputs outputs(options, scene, resumed.rows);
  const CompiledModel model =
      build(scene, functions_for(scene, run), options.build, integrate::needs_series(run.method));
  Summary summary;
  try {
    summary = integrate_model(model.library.abi(), set, resumed.state, run, outputs, interrupts);
  } catch (const IntegrationError& error) {
    tell_failure(error, options, scene, outputs);
  } catch (const Interrupted&) {
    tell_interruption(options, outputs);
  }
  const Conservation conservation{is_isolated(scene), has_drives(scene), has_attitudes(scene)};
  const Json last = state_json(set, final_state(set, summary));
  outputs.finish(last);
  if (!options.json) {
    report(scene.name + "\n" + summary_text(summary, run, conservation), takes_standard_output(options));
    return 0;
  }
  Json json = {{"model", scene.name}, {"hash", model.hash()}};
  json.update(summary_json(summary, run, conservation));
  json["final"] = last;
  print_json(json);
  return 0;
}

void add_files(CLI::App& command, SimulateArguments& options) {
  const std::string group = "Files";
  command.add_option("--csv", options.csv, "the trajectory")->option_text("FILE")->group(group);
  command.add_option("--plot", options.plot, "coordinates, speeds, energies, drawn by gnuplot")
      ->option_text("FILE.svg")
      ->group(group);
  command.add_option("--final", options.final_state, "the state at the end, for kanec eval")
      ->option_text("FILE.json")
      ->group(group);
  command.add_option("--resume", options.resume, "go on from the last full row of a trajectory that --csv left")
      ->option_text("FILE.csv")
      ->group(group);
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
  const auto [command, options] =
      add_command(app, action, "simulate", "compile a scene (once), integrate it, tell what became of it",
                  simulate_footer, &simulate_scene);
  add_scene(*command, options->scene);
  command->add_option("--duration", options->duration, "from t = 0 [s]")->option_text("SECONDS")->check(positive());
  command->add_option("--output-step", options->output_step, "between rows [s]")
      ->option_text("SECONDS")
      ->check(positive());
  command
      ->add_option("--integrator", options->integrator,
                   "rk4, lie4, gauss4, gauss6: fixed step; the others: error control; arkode_dirk, cvode_bdf, ida: for "
                   "stiff scenes; taylor: for tight tolerances")
      ->option_text(fmt::format("{}", fmt::join(integrate::method_names(), "|")));
  command->add_option("--step", options->step, "of the fixed steps, the longest [s]")
      ->option_text("SECONDS")
      ->check(positive());
  command
      ->add_option("--longest-step", options->longest_step,
                   "of those with error control, which may miss a load that is short (as long as the error allows) [s]")
      ->option_text("SECONDS")
      ->check(not_negative());
  command->add_option("--order", options->order, "of arkode, 4, 5, 6 or 8; of arkode_dirk, 2 to 5 (0: by itself)")
      ->option_text("N");
  command
      ->add_option(
          "--jacobian", options->jacobian,
          "of arkode_dirk, cvode_bdf, ida: emitted derivatives, solved dense or sparse, or difference quotients")
      ->option_text("auto|dense|sparse|differences");
  command->add_option("--rtol", options->relative_tolerance, "relative tolerance of a step")
      ->option_text("NUMBER")
      ->check(positive());
  command->add_option("--atol", options->absolute_tolerance, "absolute tolerance of a step")
      ->option_text("NUMBER")
      ->check(positive());
  add_settings(*command, options->settings);
  command->add_flag("--json", options->json, "summary for machines, with the state at the end");
  add_files(*command, *options);
  add_ensemble(*command, options->ensemble);
  add_build(*command, options->build);
}

}  // namespace kanec::cli
