// Of two ways, which one pays. Not: what an error or a time is of.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace kanec {

struct Cost {
  double error, time;
};

// Whether a is nowhere worse, and somewhere better.
inline bool beats(const Cost& a, const Cost& b) {
  return a.error <= b.error && a.time <= b.time && (a.error < b.error || a.time < b.time);
}

}  // namespace kanec
