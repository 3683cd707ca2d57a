// Zeros of functions of the state, found within the steps of a run. Not: what follows from them (simulate.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "runtime/integrate/stepper.hpp"

namespace kanec::integrate {

struct Happening {
  double t;   // [s]: the crossing is over, and was not two roundings before (of the time where that step or row ends)
  int event;  // into the list of events
  bool up;
};

// One function a watched event; each is on one side of zero, and crosses where it is found on the other. Looked at are
// the ends of steps and the rows: a crossing there and back between two looks is not seen. A function that begins at
// zero crosses when it comes back from the side that it goes to first.
class EventWatch {
 public:
  // Throws InputError unless the model has the function and as many events. Both must outlive the watch.
  EventWatch(const Solver& solver, const std::vector<Event>& events);

  // The sides as they are in this state.
  void begin(double t, std::span<const double> z);

  // The first crossing of a wanted direction after `from`, until `to`, both within the stepper's last step; with the
  // sides of its end where there is none.
  std::optional<double> next(Stepper& stepper, double from, double to);

  // What crosses at t, in the order of events; the sides are then those there.
  std::vector<Happening> cross(double t, std::span<const double> z);

  // Inputs have changed: a function that jumps to the other side has not crossed.
  void inputs_changed(double t, std::span<const double> z);

 private:
  void evaluate(double t, std::span<const double> z);
  bool is_crossing(std::size_t event) const;  // by values_ and sides_
  bool is_over(std::size_t event) const;      // the same in any direction
  void take_sides();
  double find(std::size_t event, Stepper& stepper, double from, double before, double to, double after);

  const Solver* solver_;
  const std::vector<Event>* events_;
  const kanec_function* function_;
  std::vector<double> values_, last_;  // now; at the end of the last look
  std::vector<int> sides_;             // -1, 1; 0: none yet
};

}  // namespace kanec::integrate
