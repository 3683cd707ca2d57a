// Operations grow as the number of bodies does, on chains, stars and random trees of up to 500. Oracle: the law itself,
// on counts, which are exact; no time is measured.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "generator/choice/candidates.hpp"
#include "generator/program/ledger.hpp"
#include "generator/read/read.hpp"
#include "tests/lower/sample.hpp"

namespace kanec::test {
namespace {

// L(K) of each tree.
int before(Random&, int k) { return k - 1; }
int hub(Random&, int k) { return k == 1 ? 0 : 1; }
int any(Random& random, int k) { return k == 1 ? 0 : 1 + static_cast<int>(random.uniform(0, k - 1)); }

std::string body(int k) {
  const std::string m = std::to_string(1.0 + 0.1 * k);
  const std::string axis(1, "xyz"[k % 3]);
  return "[[body]]\njoint = \"revolute\"\naxis = \"" + axis + "\"\nmass = " + m +
         "\ninertia = [[0.2, 0.005, 0.003], [0.005, 0.24, -0.004], [0.003, -0.004, 0.16]]\nr = [0.1, 0.2, 0.05]\n" +
         (k > 1 ? "q = [0.3, " + std::to_string(0.05 * (1 + k % 64)) + ", 0.1]\n" : "");
}

scene::Scene hinges(int n, int (*lower)(Random&, int)) {
  Random random(31);
  std::string connection, bodies;
  for (int k = 1; k <= n; ++k) {
    connection += (k == 1 ? "" : ", ") + std::to_string(lower(random, k));
    bodies += body(k);
  }
  return scene::parse("name = \"hinges\"\nconnection = [" + connection + "]\ngravity = [0.0, 0.0, -9.81]\n" + bodies,
                      "hinges");
}

// Joint by joint: L D Lᵀ, where it is cheaper, grows with the depth of the tree as well.
int operations(int n, int (*lower)(Random&, int), const std::string& function) {
  const program::Program program = cheapest_program(hinges(n, lower), {function}, symbolic::Algorithm::articulated);
  return program::ledger(program, program.functions[0]).operations();
}

struct Tree {
  const char* name;
  int (*lower)(Random&, int);
};

TEST(Growth, of_operations_is_that_of_the_number_of_bodies) {
  for (const Tree& tree : {Tree{"chain", before}, {"star", hub}, {"random", any}})
    for (const auto& [function, most] : {std::pair("residual", 131), {"accelerations", 310}}) {
      SCOPED_TRACE(std::string(tree.name) + " " + function);
      const int few = operations(8, tree.lower, function), some = operations(64, tree.lower, function),
                many = operations(500, tree.lower, function);
      const double first = (some - few) / 56.0, later = (many - some) / 436.0;  // a body
      EXPECT_LT(later, 1.04 * first);  // random trees differ in how many bodies carry none, by 4 in a hundred
      EXPECT_LT(later, most);
    }
}

}  // namespace
}  // namespace kanec::test
