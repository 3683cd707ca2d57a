// Counts allocations of the whole test program, to show that a fixed step makes none.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "runtime/integrate/stepper.hpp"
#include "tests/integrate/closed_form.hpp"
#include "tests/integrate/tree_model.hpp"

static std::atomic<long> allocations = 0;

// not inlined: the compiler would see malloc paired with delete and warn
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace kanec::integrate::test {
namespace {

TEST(FixedSteps, are_taken_without_allocating) {
  for (const Method method : {Method::rk4, Method::lie4, Method::gauss4, Method::gauss6}) {
    Options options;
    options.method = method;
    options.step = 1e-3;
    const Solver solver(six_bodies());
    System system(solver);
    StepBook book(options.max_steps, {});
    const auto stepper =
        make_stepper(system, system.initial_state(six_body_coordinates(), six_body_speeds()), options, book);
    const long before = allocations;
    EXPECT_GT(before, 0);  // the counter is in place
    stepper->advance(1.0);
    const long during = allocations - before;
    EXPECT_EQ(during, 0) << name_of(method);
    EXPECT_EQ(book.steps, 1000) << name_of(method);
  }
}

}  // namespace
}  // namespace kanec::integrate::test
