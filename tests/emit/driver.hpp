// An emitted header compiled alone in a small program of its own, run, and its results read back. Not: the runtime's
// way of compiling (runtime/compile), nor any expectation.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "generator/emit/used.hpp"
#include "generator/pipeline.hpp"
#include "generator/program/ledger.hpp"
#include "tests/base/folder.hpp"
#include "tests/lower/sample.hpp"

namespace kanec::test {

// What a strict user would ask for.
std::vector<std::string> strict_flags();

// Operations that a function executed in a scalar that counts.
struct Counts {
  int adds = 0, multiplies = 0, divides = 0, negations = 0;
};

// Rates of a sample's arguments, all zero.
program::Arguments<long double> still(const Sample& sample);

class Driver {
 public:
  static constexpr double time = 0.7;  // of the one call

  Driver(const Sample& sample, const Generated& generated);

  // Compiles with g++ or another compiler, `flags` besides the strict ones; scalars: of float, double, long double,
  // counted, dual. Returns the compiler's output, empty when it had nothing to say.
  std::string compile(const std::string& compiler, const std::vector<std::string>& flags,
                      const std::vector<std::string>& scalars);
  // Runs it on the sample's arguments.
  void run();
  // The same; results in `dual` are the rates of results while the arguments have these rates.
  void run(const program::Arguments<long double>& rates);

  // Results by function name, "prepare" among the counts.
  template <class T>
  std::vector<T> results(const std::string& scalar, const std::string& function) const;
  const Counts& counts(const std::string& function) const { return counts_.at(function); }

 private:
  std::string source(const std::vector<std::string>& scalars) const;
  std::string call(const program::Function& function) const;
  std::string input(const program::Arguments<long double>& arguments) const;

  const Sample& sample_;
  const Generated& generated_;
  emit::Used used_;
  Folder folder_;
  std::map<std::string, std::vector<long double>> results_;  // by "double accelerations"
  std::map<std::string, Counts> counts_;
};

inline void expect_counts(const Counts& executed, const program::Ledger& promised) {
  EXPECT_EQ(executed.adds, promised.adds);
  EXPECT_EQ(executed.multiplies, promised.multiplies);
  EXPECT_EQ(executed.divides, promised.divides);
}

// A sample's arguments, at the time of a driver's call.
inline program::Arguments<double> double_arguments(const Sample& sample) {
  const program::Arguments<long double> wide = arguments<long double>(sample);
  const auto narrowed = [](const std::vector<long double>& v) { return std::vector<double>(v.begin(), v.end()); };
  return {narrowed(wide.parameters), narrowed(wide.x),      narrowed(wide.y),
          narrowed(wide.ydot),       narrowed(wide.inputs), Driver::time};
}

}  // namespace kanec::test
