// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/timing.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "runtime/abi/solver.hpp"
#include "runtime/base/error.hpp"
#include "runtime/cli/functions.hpp"
#include "runtime/cli/samples.hpp"
#include "runtime/generic/evaluate.hpp"

namespace kanec::cli {
namespace {

constexpr int pool_size = 256;
constexpr int repetitions = 5;
constexpr std::uint64_t seed = 1;

// Keeps the time of every part, by the benchmark's name.
class Times : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration) times_[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
  }
  double median(const std::string& name) {
    std::vector<double>& list = times_[name];
    if (list.empty()) throw InternalError("no time was taken of " + name);
    const auto middle = list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2);
    std::nth_element(list.begin(), middle, list.end());
    return *middle;
  }

 private:
  std::map<std::string, std::vector<double>> times_;
};

class Pool {
 public:
  explicit Pool(const scene::Scene& scene) : states_(samples(scene, pool_size, seed)) {}
  const State& next() { return states_[at_++ % pool_size]; }

 private:
  std::vector<State> states_;
  std::size_t at_ = 0;
};

void time_emitted(benchmark::State& loop, const Solver& solver, const kanec_function& function, Pool& pool) {
  std::vector<double> out(static_cast<std::size_t>(function.n_out));
  for (auto _ : loop) {
    const State& state = pool.next();
    solver.evaluate(function, state.t, state.x.data(), state.y.data(), state.ydot.data(), out.data());
    benchmark::ClobberMemory();
  }
}

void time_generic(benchmark::State& loop, const generic::System<double>& system, const std::vector<std::string>& parts,
                  const std::vector<double>& inputs, Pool& pool) {
  for (auto _ : loop) {
    const State& state = pool.next();
    const generic::Arguments<double> arguments{state.t, state.x, state.y, state.ydot, inputs};
    for (const std::string& part : parts) benchmark::DoNotOptimize(generic::evaluate(system, part, arguments).data());
  }
}

// Google Benchmark takes its settings as a command line.
void initialise(double min_time) {
  std::array<std::string, 4> words = {"kanec", fmt::format("--benchmark_min_time={}", min_time / repetitions),
                                      fmt::format("--benchmark_repetitions={}", repetitions),
                                      "--benchmark_enable_random_interleaving=true"};
  std::array<char*, words.size() + 1> arguments{};
  std::transform(words.begin(), words.end(), arguments.begin(), [](std::string& word) { return word.data(); });
  int count = static_cast<int>(words.size());
  benchmark::Initialize(&count, arguments.data());
}

}  // namespace

std::vector<Timing> timings(const scene::Scene& scene, const CompiledModel& model, double min_time) {
  const Solver solver(model.library.abi());
  const std::vector<double> inputs = default_inputs(scene);
  const generic::System<double> system(scene, default_parameters(scene));
  Pool pool(scene);
  initialise(min_time);
  std::vector<Timing> list;
  for (const program::Function& function : model.generated.program.functions) {
    const std::string& name = function.name;
    const kanec_function& entry = *solver.find(name);
    benchmark::RegisterBenchmark((name + ":emitted").c_str(),
                                 [&](benchmark::State& loop) { time_emitted(loop, solver, entry, pool); });
    const std::vector<std::string> parts = parts_of_emitted(name, model.requests);
    benchmark::RegisterBenchmark((name + ":generic").c_str(), [&, parts](benchmark::State& loop) {
      time_generic(loop, system, parts, inputs, pool);
    });
    list.push_back({name});
  }
  Times times;
  benchmark::RunSpecifiedBenchmarks(&times);
  benchmark::ClearRegisteredBenchmarks();
  for (Timing& timing : list) {
    timing.emitted = times.median(timing.function + ":emitted");
    timing.generic = times.median(timing.function + ":generic");
  }
  return list;
}

}  // namespace kanec::cli
