// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/ensemble/ensemble.hpp"

#include <chrono>
#include <memory>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/ensemble/ensemble_summary.hpp"
#include "runtime/ensemble/scenarios.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/run/needed_functions.hpp"
#include "runtime/run/watched_events.hpp"
#include "runtime/terminal/interrupt.hpp"
#include "runtime/terminal/output.hpp"
#include "runtime/terminal/progress.hpp"
#include "runtime/trajectory/simulate.hpp"
#include "runtime/trajectory/trajectory.hpp"

namespace kanec {
namespace {

constexpr auto from_scene = "scene";
constexpr std::size_t pieces_a_thread = 4;  // between two looks at the clock: groups of lanes, or scenarios

ScenarioTable table_of(const EnsembleJob& job) {
  const EnsembleArguments& wish = job.ensemble;
  if (wish.from == from_scene)
    return draw_scenarios(job.scene, wish.count.value_or(job.scene.ensemble.count),
                          static_cast<std::uint64_t>(wish.seed.value_or(job.scene.ensemble.seed)));
  if (wish.count || wish.seed || !wish.drawn.empty())
    throw InputError("--count, --seed, --drawn: found beside scenarios of a file; allowed: with --ensemble scene");
  return read_scenarios(read_file(wish.from == "-" ? "/dev/stdin" : wish.from, most_of_a_table), wish.from, job.scene);
}

// Rows of all scenarios, in their order: the number of the scenario, then the columns of a trajectory.
class EndsFile {
 public:
  EndsFile(const std::string& path, const scene::Scene& scene) {
    if (path.empty()) return;
    file_.emplace(path);
    file_->write("scenario," + csv_header(state_names(scene), true) + "\n");
  }
  void add(std::size_t scenario, const Outcome& outcome) {
    if (!file_) return;
    for (const KeptRow& row : outcome.rows) {
      std::string line = std::to_string(scenario + 1) + ",";
      const Energy energy = row.energy.value_or(Energy{});
      append_csv(line, {row.t, row.x, row.y, row.work, energy, {}});
      file_->write(line + "\n");
    }
  }
  AtomicFile* file() { return file_ ? &*file_ : nullptr; }

 private:
  std::optional<AtomicFile> file_;
};

// What was drawn, on the disk before the run: a full one is known then.
std::unique_ptr<AtomicFile> drawn_file(const EnsembleJob& job, const ScenarioTable& table) {
  if (job.ensemble.drawn.empty()) return nullptr;
  auto file = std::make_unique<AtomicFile>(job.ensemble.drawn);
  file->write(csv_text(table));
  file->flush();
  return file;
}

// A model that is compiled for the method: its lanes, or one state at a time.
class Engine {
 public:
  explicit Engine(const EnsembleJob& job)
      : options_{job.run, job.ensemble.keep_every}, in_lanes_(job.run.method == integrate::Method::rk4) {
    std::vector<std::string> functions = functions_to_integrate(job.scene, options_.run);
    functions.emplace_back("energy");
    if (in_lanes_) {
      model_.emplace(build_batch(job.scene, functions, job.build));
      lanes_.emplace(model_->library.batch(), job.ensemble.threads);
    } else {
      model_.emplace(build(job.scene, functions, job.build, integrate::needs_series(job.run.method)));
      workers_.emplace(job.ensemble.threads);
    }
  }

  const kanec_model& model() const { return model_->library.abi(); }
  std::string hash() const { return model_->hash(); }
  int lanes() const { return in_lanes_ ? lanes_->lanes() : 0; }
  int threads() const { return in_lanes_ ? lanes_->workers().size() : workers_->size(); }
  std::size_t scenarios_a_turn() const {
    return pieces_a_thread * static_cast<std::size_t>(threads() * std::max(lanes(), 1));
  }
  std::vector<Outcome> run(const std::vector<Scenario>& scenarios) {
    return in_lanes_ ? run_in_lanes(*lanes_, scenarios, options_)
                     : run_one_by_one(model(), *workers_, scenarios, options_);
  }

 private:
  EnsembleOptions options_;
  bool in_lanes_;
  std::optional<CompiledModel> model_;
  std::optional<BatchSolver<double>> lanes_;
  std::optional<Workers> workers_;
};

// All scenarios, some at a time, in order.
EnsembleSummary run_all(const EnsembleJob& job, const ScenarioTable& table, const Scenarios& scenarios, Engine& engine,
                        EndsFile& ends, const Interrupts& interrupts) {
  const auto begin = std::chrono::steady_clock::now();
  EnsembleSummary summary(job.scene, job.run);
  ProgressBar bar(job.scene.name);
  for (std::size_t first = 0; first < table.rows();) {
    interrupts.poll();
    bar.show(static_cast<double>(first) / static_cast<double>(table.rows()));
    std::vector<Scenario> turn;
    while (turn.size() < engine.scenarios_a_turn() && first + turn.size() < table.rows())
      turn.push_back(scenarios.at(first + turn.size(), engine.model()));
    for (const Outcome& outcome : engine.run(turn)) {
      ends.add(first, outcome);
      summary.add(outcome, table.place(first));
      ++first;
    }
  }
  summary.lanes = engine.lanes();
  summary.threads = engine.threads();
  summary.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return summary;
}

}  // namespace

void EnsembleArguments::refuse_without_ensemble() const {
  if (count || seed || threads != 0 || keep_every != 0 || !drawn.empty())
    throw InputError("--count, --seed, --threads, --keep-every, --drawn: found without --ensemble; allowed: with it");
}

int simulate_ensemble(const EnsembleJob& job) {
  const Interrupts interrupts;
  const ScenarioTable table = table_of(job);
  const Scenarios scenarios(job.scene, table);
  if (scenarios.normalised() > 0)
    remark("note: Euler parameters of " + std::to_string(scenarios.normalised()) + " scenarios were normalised");
  EndsFile ends(job.csv, job.scene);
  const std::unique_ptr<AtomicFile> drawn = drawn_file(job, table);
  Engine engine(job);
  const EnsembleSummary summary = run_all(job, table, scenarios, engine, ends, interrupts);
  if (summary.finished == 0) throw IntegrationError("every scenario stopped; the first: " + summary.first_stop());
  std::vector<AtomicFile*> files;
  for (AtomicFile* file : {drawn.get(), ends.file()})
    if (file) files.push_back(file);
  commit_all(files);
  if (job.json) {
    Json json = {{"model", job.scene.name}, {"hash", engine.hash()}};
    json.update(summary.json());
    print_json(json);
  } else {
    report(job.scene.name + "\n" + summary.text(), is_standard_output(job.csv));
  }
  return 0;
}

}  // namespace kanec
