// Processor time of many loops in one run, by Google Benchmark. Not: what the loops do, nor what is shown of it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <vector>

namespace kanec {

struct Loop {
  std::function<void(benchmark::State& loop)> run;  // for (auto _ : loop) ...
  double evaluations = 1.0;                         // in each turn
};

// Processor time per evaluation [ns].
struct Time {
  double median = 0.0, least = 0.0;
};

// Each loop runs for `min_time` [s] in five parts; the parts of all loops are mixed in random order, so that what else
// the machine does falls on all alike.
std::vector<Time> timed(const std::vector<Loop>& loops, double min_time);

}  // namespace kanec
