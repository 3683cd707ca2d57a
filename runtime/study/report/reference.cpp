// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "runtime/base/error.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/study/report/methods.hpp"

namespace kanec {
namespace {

using integrate::Method;

// Finer and finer runs of one method.
struct Family {
  Method method;
  int levels;
};

// The best first: each is taken where those before it fail.
constexpr std::array<Family, 5> families = {{{Method::taylor_extended, 3},
                                             {Method::gauss6, 12},
                                             {Method::dop853, 3},
                                             {Method::cvode, 3},
                                             {Method::cvode_bdf, 3}}};

// Of level 0 with error control; each further one is a tenth.
double first_tolerance(Method method) { return method == Method::taylor_extended ? 1e-15 : 1e-12; }

// The finest run of a family that still changed less than the one before it.
struct Limit {
  Trial finest;
  std::string coarser;
  double change = 0.0;
};

integrate::Options at_level(const integrate::Options& base, const Family& family, double step, int level) {
  integrate::Options options = base;
  options.method = family.method;
  if (has_fixed_step(family.method)) {
    options.step = step / std::pow(2.0, level + 1);
  } else {
    options.relative_tolerance = first_tolerance(family.method) * std::pow(10.0, -level);
    options.absolute_tolerance = options.relative_tolerance * (base.absolute_tolerance / base.relative_tolerance);
  }
  return options;
}

// Below this a change that no longer falls is rounding.
constexpr double settled = 1e-6;

// Nothing where fewer than two runs get to the end in time.
std::optional<Limit> limit_of(const Trials& trials, const integrate::Options& base, const Family& family, double step,
                              double limit, std::string& failures) {
  std::optional<Trial> before;
  std::optional<Limit> best;
  bool has_failed = false;  // the first failure of a family is told
  for (int level = 0; level < family.levels; ++level) {
    Trial trial = trials.once(at_level(base, family, step, level), limit);
    if (!trial.ok() && !std::exchange(has_failed, true))
      failures += "\n  " + method_text(trial.options) + ": " + trial.failure;
    if (trial.out_of_time) break;
    if (!trial.ok()) continue;
    if (before && before->rows.size() == trial.rows.size()) {
      const double change = distance(trial.rows, before->rows, scales_of(trial.rows));
      if (best && best->change < settled && !(change < best->change)) break;
      best = Limit{trial, setting_text(before->options), change};
      if (change < rounding_of_double) break;
    }
    before = std::move(trial);
  }
  return best;
}

}  // namespace

double distance(const std::vector<Bodies>& rows, const std::vector<Bodies>& from, const MotionScales& scales) {
  double worst = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    worst = integrate::worse(worst, relative(difference(rows[i], from[i]), scales));
  return worst;
}

Reference reference(const Trials& trials, const integrate::Options& base, double step, double limit) {
  std::optional<Limit> best, check;
  std::string failures;
  for (const Family& family : families) {
    if (check) break;
    (best ? check : best) = limit_of(trials, base, family, step, limit, failures);
  }
  if (!best)
    throw IntegrationError(fmt::format("no reference: no method gets through {} s; a shorter --duration may do{}",
                                       base.duration, failures));
  Reference found{method_text(best->finest.options),
                  best->finest.rows,
                  scales_of(best->finest.rows),
                  std::max(best->change, rounding_of_double),
                  best->coarser,
                  {},
                  0.0,
                  false};
  if (!check || check->finest.rows.size() != found.rows.size()) return found;
  found.check = method_text(check->finest.options);
  found.check_difference = distance(check->finest.rows, found.rows, found.scales);
  // each run's error is about its change from the coarser one, or below
  constexpr double margin = 10.0;
  found.is_disputed = !(found.check_difference <= margin * (found.own_error + check->change + rounding_of_double));
  if (found.is_disputed) found.own_error = found.check_difference;
  return found;
}

}  // namespace kanec
