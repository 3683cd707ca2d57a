// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/events.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"

namespace kanec::integrate {
namespace {

int sign(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

// g is not over at a, and over at b.
struct Bracket {
  double a, ga, b, gb;
};

// The end of the bracket when both ends are neighbours to rounding. Regula falsi, the value of an end that stays being
// halved (Illinois); a point at least one rounding inside, so that both ends close in, and a bisection where three
// points did not halve the bracket.
double narrow(Bracket at, const std::function<double(double)>& g, const std::function<bool(double)>& is_over) {
  const double least = std::numeric_limits<double>::epsilon() * std::max(std::fabs(at.a), std::fabs(at.b));
  double wanted = (at.b - at.a) / 2;
  int kept = 0;  // end that stayed last: -1 a, 1 b
  for (int count = 1; at.b - at.a > least; ++count) {
    double t = at.b - at.gb * (at.b - at.a) / (at.gb - at.ga);
    if (count % 3 == 0) {
      if (at.b - at.a > wanted) t = at.a + (at.b - at.a) / 2;
      wanted = (at.b - at.a) / 2;
    }
    if (at.b - at.a < 3 * least || !std::isfinite(t)) t = at.a + (at.b - at.a) / 2;
    if (at.b - at.a >= 3 * least) t = std::clamp(t, at.a + least, at.b - least);
    if (!(t > at.a && t < at.b)) break;
    const double value = g(t);
    if (is_over(value)) {
      at.b = t;
      at.gb = value;
      if (kept == -1) at.ga /= 2;
      kept = -1;
    } else {
      at.a = t;
      at.ga = value;
      if (kept == 1) at.gb /= 2;
      kept = 1;
    }
  }
  return at.b;
}

}  // namespace

EventWatch::EventWatch(const Solver& solver, const std::vector<Event>& events)
    : solver_(&solver),
      events_(&events),
      function_(solver.find("events")),
      values_(events.size()),
      last_(events.size()),
      sides_(events.size(), 0) {
  if (!function_ || function_->n_out != static_cast<int>(events.size()))
    throw InputError(std::string("model ") + solver.model().name + " has no function 'events' of " +
                     std::to_string(events.size()) + " events, which this run watches for");
}

void EventWatch::evaluate(double t, std::span<const double> z) {
  solver_->evaluate(*function_, t, z.data(), z.data() + solver_->model().nx, nullptr, values_.data());
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (!std::isfinite(values_[i]))
      throw IntegrationError("integration stopped at t = " + shortest(t) + " s: the expression of event " +
                             (*events_)[i].name + " is not finite");
}

void EventWatch::take_sides() {
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (values_[i] != 0.0) sides_[i] = sign(values_[i]);
  last_ = values_;
}

void EventWatch::begin(double t, std::span<const double> z) {
  evaluate(t, z);
  take_sides();
}

bool EventWatch::is_over(std::size_t event) const { return sign(values_[event]) * sides_[event] < 0; }

bool EventWatch::is_crossing(std::size_t event) const {
  using Direction = Event::Direction;
  const Direction direction = (*events_)[event].direction;
  const bool up = values_[event] > 0.0;
  return is_over(event) && (direction == Direction::both || (direction == Direction::up) == up);
}

double EventWatch::find(std::size_t event, Stepper& stepper, double from, double before, double to, double after) {
  const int side = sides_[event];
  const auto g = [&](double t) {
    evaluate(t, stepper.at(t));
    return values_[event];
  };
  return narrow({from, before, to, after}, g, [side](double value) { return sign(value) * side < 0; });
}

std::optional<double> EventWatch::next(Stepper& stepper, double from, double to) {
  evaluate(to, stepper.at(to));
  const std::vector<double> after = values_;
  std::vector<std::size_t> crossing;
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (is_crossing(i)) crossing.push_back(i);
  if (crossing.empty()) {
    take_sides();
    return std::nullopt;
  }
  double first = to;
  for (const std::size_t i : crossing) first = std::min(first, find(i, stepper, from, last_[i], to, after[i]));
  return first;
}

std::vector<Happening> EventWatch::cross(double t, std::span<const double> z) {
  evaluate(t, z);
  std::vector<Happening> list;
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (is_crossing(i)) list.push_back({t, static_cast<int>(i), values_[i] > 0.0});
  take_sides();
  return list;
}

void EventWatch::inputs_changed(double t, std::span<const double> z) {
  evaluate(t, z);
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (values_[i] != last_[i] && values_[i] != 0.0) sides_[i] = sign(values_[i]);
  last_ = values_;
}

}  // namespace kanec::integrate
