// What may be called from several threads at once. Under ThreadSanitizer (cmake --preset tsan) it tells of races.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <atomic>
#include <thread>

#include "tests/front/bench.hpp"

namespace kanec::test {
namespace {

// Each of a few threads does it; the first exception's message is the failure.
template <class Work>
void in_threads(Work work) {
  std::vector<std::thread> threads;
  std::atomic<int> failures = 0;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&, i] {
      try {
        work(i);
      } catch (const std::exception&) {
        ++failures;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(failures, 0);
}

TEST(Threads, share_a_model_and_an_evaluator) {
  const Scene scene = shipped("cart_pole");
  const Model model = scene.compile({}, shared_cache());
  const Evaluator shared(model);
  const std::vector<double> x = {0.3, 0.1}, y = {0.5, -0.2};
  const std::vector<double> wanted = shared.evaluate("accelerations", {.x = x, .y = y});
  std::atomic<int> wrong = 0;
  in_threads([&](int i) {
    Evaluator own(model);
    own.set_input("push", i);
    for (int n = 0; n < 200; ++n) {
      wrong += shared.evaluate("accelerations", {.x = x, .y = y}) != wanted;
      (void)own.evaluate("accelerations", {.x = x, .y = y});
      const Model copy = model;
      wrong += copy.name() != "cart_pole";
    }
  });
  EXPECT_EQ(wrong, 0);
}

TEST(Threads, derive_generate_compile_and_simulate_side_by_side) {
  const Scene scene = shipped("pendulum");
  const std::string header = scene.generate()[0].text, equations = scene.derive();
  std::atomic<int> wrong = 0;
  in_threads([&](int i) {
    wrong += scene.generate()[0].text != header;
    wrong += scene.derive() != equations;
    const Scene other = shipped(i % 2 == 0 ? "cart_pole" : "pendulum");
    auto run = other.run();
    run.duration = 0.5;
    const Motion motion = other.simulate(run, shared_cache());
    wrong += motion.rows() < 2 || other.functions().empty();
  });
  EXPECT_EQ(wrong, 0);
}

TEST(Threads, have_batches_of_their_own) {
  const Scene scene = shipped("cart_pole");
  in_threads([&](int) {
    Batch batch = scene.compile_batch({}, shared_cache(), 3);
    const std::vector<double> x(2000, 0.1);
    std::vector<double> out(2000);
    batch.evaluate(batch.model().function("accelerations"), {.count = 1000, .x = x, .y = x}, std::span<double>(out));
  });
}

}  // namespace
}  // namespace kanec::test
