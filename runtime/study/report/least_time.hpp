// A short run made again, so that the least of its times counts. Not: the runs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace kanec {

// After a first run of so many seconds: again() makes another one and returns its seconds.
template <class Again>
void repeat_while_short(double first, Again&& again) {
  constexpr int most_runs = 7;
  constexpr double enough = 0.2;  // [s] of all runs
  double spent = first;
  for (int i = 1; i < most_runs && spent < enough; ++i) spent += again();
}

}  // namespace kanec
