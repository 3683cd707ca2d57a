// A model integrated from an initial state: its motion, and what was kept. Not: which scene it is of (scene.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kanec/model.hpp"

namespace kanec {

// A zero of an entry of the model's function `events`, and what happens there.
struct WatchedEvent {
  struct Setting {
    int input = 0;  // into the model's inputs
    double value = 0.0;
  };
  std::string name;
  int direction = 0;  // 1: upwards, -1: downwards, 0: both
  bool stops = false, has_row = false;
  std::vector<Setting> settings = {};
};

// As [simulate] of a scene, and `kanec simulate --help`, have them.
struct Run {
  double duration = 10.0;     // [s]
  double output_step = 0.01;  // between rows [s]
  std::string integrator = "dop853";
  double step = 1e-3;         // of those with fixed steps, the longest [s]
  double longest_step = 0.0;  // of those with error control [s]; 0: as long as the error allows
  double relative_tolerance = 1e-9;
  double absolute_tolerance = 1e-12;
  int order = 0;  // 0: by itself
  std::string jacobian = "auto";
  bool has_kinks = false;  // rates that are not smooth everywhere
  std::vector<WatchedEvent> events = {};
};

struct Happening {
  double t = 0.0;  // [s]
  int event = 0;   // into Run::events
  bool up = false;
};

// Rows of a run, the first at t = 0.
struct Motion {
  int nx = 0, ny = 0;
  std::vector<double> t;     // [s] (rows)
  std::vector<double> x, y;  // (rows × nx), (rows × ny), row by row
  std::vector<double> work;  // of the applied loads since t = 0 [J] (rows); 0 where the model has no `power`
  std::vector<double> kinetic, potential;  // [J] (rows); empty where the model has no `energy`
  std::vector<double> inputs;              // at the end
  std::vector<Happening> happenings;
  bool stopped = false;  // by an event, before the duration
  std::int64_t steps = 0, failed_steps = 0, evaluations = 0;
  double wall_seconds = 0.0;
  std::optional<double> energy_error;  // worst change of energy less work, beside the energies' own size
  double norm_error = 0.0;             // worst | |ε| - 1 | of a step's end before it is projected

  std::size_t rows() const { return t.size(); }
  std::span<const double> x_at(std::size_t row) const {
    return {x.data() + row * static_cast<std::size_t>(nx), static_cast<std::size_t>(nx)};
  }
  std::span<const double> y_at(std::size_t row) const {
    return {y.data() + row * static_cast<std::size_t>(ny), static_cast<std::size_t>(ny)};
  }
};

// The functions that a run calls, to be compiled for it: "kinematics+accelerations+power" and what the method needs.
// has_power: the model has loads.
KANEC_API std::vector<std::string> functions_to_simulate(const Run& run, bool has_power, int nx);
// Whether the model has to be compiled with its Taylor series.
KANEC_API bool needs_taylor(const Run& run);
// "dop853", "taylor", and so on.
KANEC_API std::vector<std::string> integrators();

// Called after every step with the share that is done; what it throws ends the run.
using Progress = std::function<void(double fraction)>;

// With the evaluator's parameters and inputs, from x and y at t = 0. Throws InputError (settings, the state, a model
// without the functions that are needed), IntegrationError (time and cause).
KANEC_API Motion simulate(const Evaluator& evaluator, std::span<const double> x, std::span<const double> y,
                          const Run& run, const Progress& progress = {});

}  // namespace kanec
