// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/bench/timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <string>

#include "runtime/base/error.hpp"
#include "runtime/terminal/progress.hpp"

namespace kanec {
namespace {

constexpr int repetitions = 5;

// Keeps the time of every part, by the benchmark's name.
class Times : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration) times_[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
  }
  Time of(const std::string& name) {
    std::vector<double>& list = times_[name];
    if (list.empty()) throw InternalError("no time was taken of loop " + name);
    std::sort(list.begin(), list.end());
    return {list[list.size() / 2], list.front()};
  }

 private:
  std::map<std::string, std::vector<double>> times_;
};

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

// What of all parts is done, as a bar.
class Course {
 public:
  Course(std::size_t n_loops, double min_time)
      : total_(static_cast<double>(n_loops) * repetitions), part_(min_time / repetitions) {}

  // Google Benchmark tries a few turns first, which take less time than a part.
  void run(const Loop& loop, benchmark::State& state) {
    const auto start = std::chrono::steady_clock::now();
    loop.run(state);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (seconds.count() > 0.5 * part_) done_ += 1.0;
    bar_.show(std::min(done_ / total_, 1.0));
  }

 private:
  double total_, part_, done_ = 0.0;
  ProgressBar bar_{"timing"};
};

}  // namespace

std::vector<Time> timed(const std::vector<Loop>& loops, double min_time) {
  initialise(min_time);
  Course course(loops.size(), min_time);
  for (std::size_t i = 0; i < loops.size(); ++i)
    benchmark::RegisterBenchmark(std::to_string(i).c_str(),
                                 [&course, &loop = loops[i]](benchmark::State& state) { course.run(loop, state); });
  Times times;
  if (!loops.empty()) benchmark::RunSpecifiedBenchmarks(&times);
  benchmark::ClearRegisteredBenchmarks();
  std::vector<Time> list;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Time time = times.of(std::to_string(i));
    list.push_back({time.median / loops[i].evaluations, time.least / loops[i].evaluations});
  }
  return list;
}

}  // namespace kanec
