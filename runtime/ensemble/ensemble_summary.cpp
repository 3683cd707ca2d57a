// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/ensemble/ensemble_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/scene/entry_names.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/base/text.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/run/conservation.hpp"
#include "runtime/text/table.hpp"

namespace kanec {
namespace {

constexpr std::size_t shown_names = 24;

std::string line(const std::string& label, const std::string& text) {
  return fmt::format("  {:<30} {}\n", label, text);
}

std::string method_text(const integrate::Options& run, int lanes) {
  const std::string name = integrate::name_of(run.method);
  if (lanes > 0)
    return fmt::format("{}, steps of at most {} s, {} scenarios side by side", name, shortest(run.step), lanes);
  return name + ", one scenario at a time" +
         (run.method == integrate::Method::rk4
              ? ""
              : fmt::format(", tolerances {} relative, {} absolute", shortest(run.relative_tolerance),
                            shortest(run.absolute_tolerance)));
}

Json spread_json(const Spread& spread) {
  return {{"mean", spread.mean()},
          {"deviation", spread.deviation()},
          {"least", spread.least()},
          {"largest", spread.largest()}};
}

}  // namespace

// Welford's recurrence: no cancellation of large squares.
void Spread::add(double value) {
  least_ = count_ == 0 ? value : std::min(least_, value);
  largest_ = count_ == 0 ? value : std::max(largest_, value);
  ++count_;
  const double before = value - mean_;
  mean_ += before / static_cast<double>(count_);
  squares_ += before * (value - mean_);
}

double Spread::deviation() const { return count_ < 2 ? 0.0 : std::sqrt(squares_ / static_cast<double>(count_ - 1)); }

EnsembleSummary::EnsembleSummary(const scene::Scene& scene, integrate::Options run)
    : names_(in_words(scene, coordinate_names(scene))),
      driven_(has_drives(scene)),
      has_attitudes_(has_attitudes(scene)),
      run_(run) {
  for (const std::string& name : in_words(scene, speed_names(scene))) names_.push_back(name);
  ends_.resize(names_.size());
}

void EnsembleSummary::add(const Outcome& outcome, const std::string& place) {
  steps += outcome.steps;
  evaluations += outcome.evaluations;
  if (!outcome.stopped.empty()) {
    if (stopped++ == 0) first_stop_ = place + ": " + outcome.stopped;
    return;
  }
  ++finished;
  norm_error_ = integrate::worse(norm_error_, outcome.worst_norm_error);
  if (outcome.energy) energy_error_.add(outcome.energy->worst.relative());
  const KeptRow& end = outcome.end();
  std::size_t i = 0;
  for (const std::vector<double>* part : {&end.x, &end.y})
    for (const double value : *part) ends_[i++].add(value);
}

std::string EnsembleSummary::text() const {
  std::string text = line("integrator", method_text(run_, lanes));
  text += line("time", fmt::format("0 to {} s", shortest(run_.duration)));
  text += line("scenarios", fmt::format("{} finished, {} stopped", finished, stopped));
  if (stopped > 0) text += line("the first that stopped", fit::line(first_stop_));
  text += line("steps, evaluations", fmt::format("{}, {} of xdot and ydot", steps, evaluations));
  text += line("wall time", fmt::format("{:.3g} s, {} {}", wall_seconds, threads, threads == 1 ? "thread" : "threads"));
  if (energy_error_.count() > 0 && !driven_)
    text += line("energy change minus work", fmt::format("at worst {} relative, {} on average",
                                                         brief(energy_error_.largest()), brief(energy_error_.mean())));
  if (has_attitudes_) text += line("worst | |eps| - 1 |", brief(norm_error_) + " at the ends of steps");
  if (names_.empty()) return text;
  std::vector<TextRow> rows = {{"  at the end", "mean", "deviation", "least", "largest"}};
  for (std::size_t i = 0; i < std::min(names_.size(), shown_names); ++i)
    rows.push_back({"  " + names_[i], brief(ends_[i].mean()), brief(ends_[i].deviation()), brief(ends_[i].least()),
                    brief(ends_[i].largest())});
  text += "\n" + text_table(rows);
  if (names_.size() > shown_names) text += fmt::format("  and {} more: --json has all\n", names_.size() - shown_names);
  return text;
}

Json EnsembleSummary::json() const {
  Json ends = Json::object();
  for (std::size_t i = 0; i < names_.size(); ++i) ends[names_[i]] = spread_json(ends_[i]);
  Json json = {{"integrator", integrate::name_of(run_.method)},
               {"lanes", lanes},
               {"threads", threads},
               {"duration", run_.duration},
               {"finished", finished},
               {"stopped", stopped},
               {"steps", steps},
               {"evaluations", evaluations},
               {"wall_seconds", wall_seconds},
               {"worst_norm_error_before_projection", norm_error_}};
  if (stopped > 0) json["first_stop"] = first_stop_;
  if (energy_error_.count() > 0 && !driven_) json["worst_relative_energy_error"] = spread_json(energy_error_);
  json["end"] = ends;
  return json;
}

}  // namespace kanec
