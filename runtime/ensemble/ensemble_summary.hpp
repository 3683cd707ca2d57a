// The closing figures of an ensemble, for people and for machines. Not: the runs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/text/json.hpp"
#include "runtime/trajectory/batch_ensemble.hpp"

namespace kanec {

// Mean, standard deviation and range of numbers that come one by one.
class Spread {
 public:
  void add(double value);
  std::int64_t count() const { return count_; }
  double mean() const { return mean_; }
  double deviation() const;  // of the sample, by count - 1; 0 for one
  double least() const { return least_; }
  double largest() const { return largest_; }

 private:
  std::int64_t count_ = 0;
  double mean_ = 0.0, squares_ = 0.0, least_ = 0.0, largest_ = 0.0;
};

class EnsembleSummary {
 public:
  EnsembleSummary(const scene::Scene& scene, integrate::Options run);

  // In the order of the scenarios; `place` as messages name it.
  void add(const Outcome& outcome, const std::string& place);

  std::int64_t finished = 0, stopped = 0, steps = 0, evaluations = 0;
  int lanes = 0;  // 0: one scenario at a time
  int threads = 1;
  double wall_seconds = 0.0;

  std::string text() const;
  Json json() const;
  const std::string& first_stop() const { return first_stop_; }

 private:
  std::vector<std::string> names_;
  std::vector<Spread> ends_;  // of coordinates and speeds, finished scenarios
  Spread energy_error_;       // worst relative energy change minus work, of each
  double norm_error_ = 0.0;
  bool driven_, has_attitudes_;
  integrate::Options run_;
  std::string first_stop_;
};

}  // namespace kanec
