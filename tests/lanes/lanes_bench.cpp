// Time of accelerations for each state of a batch: one state at a time, lanes of double and float, both layouts, in one
// run. A benchmark, no test: lanes_bench [models/bench_cr7 ...].
// SPDX-License-Identifier: GPL-2.0-or-later
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <deque>
#include <map>
#include <memory>

#include "generator/read/read.hpp"
#include "runtime/model/model.hpp"
#include "tests/lanes/compiled.hpp"

namespace kanec::test {
namespace {

constexpr int n_states = 256;
constexpr int repetitions = 7;
constexpr char function[] = "accelerations";

struct Model {
  scene::Scene scene;
  CompiledModel scalar;
  std::vector<Sample> samples;
};

// The least processor time of the repetitions, by name [ns].
class Least : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const auto [at, is_new] = times.try_emplace(run.run_name.function_name, run.GetAdjustedCPUTime());
      if (!is_new) at->second = std::min(at->second, run.GetAdjustedCPUTime());
    }
  }
  std::map<std::string, double> times;
};

void time_scalar(benchmark::State& loop, const Model& model) {
  Solver solver(model.scalar.library.abi());
  const kanec_function& entry = *solver.find(function);
  std::vector<double> out(static_cast<std::size_t>(entry.n_out));
  for (auto _ : loop)
    for (const Sample& s : model.samples) {
      solver.evaluate(entry, s.t, s.state.x.data(), s.state.y.data(), s.state.ydot.data(), out.data());
      benchmark::ClobberMemory();
    }
}

template <class Real>
struct Aligned {
  explicit Aligned(const std::vector<Real>& from) : store(from.size() + 64 / sizeof(Real)) {
    const auto address = reinterpret_cast<std::uintptr_t>(store.data());
    at = store.data() + (64 - address % 64) % 64 / sizeof(Real);
    std::copy(from.begin(), from.end(), at);
  }
  std::vector<Real> store;
  Real* at;
};

template <class Real>
void time_lanes(benchmark::State& loop, const Model& model, const kanec_batch& batch, bool blocked) {
  BatchSolver<Real> solver(batch);
  const SampleBatch<Real> data(model.samples, solver.model(), blocked ? batch.lanes : 0);
  const int number = *solver.find(function);
  Aligned<Real> x(data.x), y(data.y), ydot(data.ydot), out(std::vector<Real>(data.size(solver.n_out(number))));
  BatchStates<Real> states = data.states();
  states.x = x.at;
  states.y = y.at;
  states.ydot = ydot.at;
  states.u = nullptr;
  for (auto _ : loop) {
    solver.evaluate(number, states, out.at);
    benchmark::ClobberMemory();
  }
}

Model model_of(const std::string& path) {
  const scene::Scene scene = scene::read(path + "/scene.toml");
  Model model{scene, build(scene, {function}, {}), {}};
  Random random(1);
  while (model.samples.size() < n_states) model.samples.push_back(sample_of(scene, random));
  return model;
}

struct Variant {
  const char* scalar;
  int lanes;
};
constexpr Variant variants[] = {{"double", 4}, {"double", 8}, {"float", 8}, {"float", 16}};

int run(const std::vector<std::string>& scenes) {
  std::array<std::string, 4> words = {"lanes_bench", "--benchmark_min_time=0.02",
                                      "--benchmark_repetitions=" + std::to_string(repetitions),
                                      "--benchmark_enable_random_interleaving=true"};
  std::array<char*, words.size() + 1> arguments{};
  std::transform(words.begin(), words.end(), arguments.begin(), [](std::string& word) { return word.data(); });
  int count = static_cast<int>(words.size());
  benchmark::Initialize(&count, arguments.data());
  std::deque<Model> models;
  std::deque<CompiledModel> batches;
  for (const std::string& path : scenes) {
    const Model& model = models.emplace_back(model_of(path));
    const std::string name = model.scene.name;
    benchmark::RegisterBenchmark((name + ", one").c_str(), [&](benchmark::State& loop) { time_scalar(loop, model); });
    for (const Variant& variant : variants) {
      batches.push_back(build_batch(model.scene, {function}, {}, {variant.scalar, variant.lanes}));
      const kanec_batch& batch = batches.back().library.batch();
      for (const bool blocked : {false, true}) {
        const std::string full =
            name + ", " + std::to_string(variant.lanes) + " " + variant.scalar + (blocked ? ", blocks" : ", arrays");
        const bool is_double = batch.scalar_size == sizeof(double);
        benchmark::RegisterBenchmark(full.c_str(), [&model, &batch, blocked, is_double](benchmark::State& loop) {
          is_double ? time_lanes<double>(loop, model, batch, blocked) : time_lanes<float>(loop, model, batch, blocked);
        });
      }
    }
  }
  Least least;
  benchmark::RunSpecifiedBenchmarks(&least);
  for (const auto& [name, time] : least.times) {
    const double one = least.times.at(name.substr(0, name.find(',')) + ", one");
    std::printf("%-32s %8.2f ns a state  %6.2f times as fast\n", name.c_str(), time / n_states, one / time);
  }
  return 0;
}

}  // namespace
}  // namespace kanec::test

int main(int argc, char** argv) {
  std::vector<std::string> scenes(argv + 1, argv + argc);
  if (scenes.empty())
    for (const char* name : {"bench_cr7", "bench_s6b", "bench_s6f"})
      scenes.push_back(std::string(KANEC_SOURCE_DIR "/models/") + name);
  return kanec::test::run(scenes);
}
