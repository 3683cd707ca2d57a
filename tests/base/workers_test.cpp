// Threads that share numbered work. Oracle: the numbers.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/workers.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>

namespace kanec::test {
namespace {

TEST(Workers, every_piece_is_done_once_by_a_worker_that_there_is) {
  for (const int threads : {1, 2, 7}) {
    Workers workers(threads);
    EXPECT_EQ(workers.size(), threads);
    for (const std::int64_t pieces : {0, 1, 3, 1000}) {
      std::vector<std::atomic<int>> done(static_cast<std::size_t>(pieces));
      workers.run(pieces, [&](std::int64_t piece, int worker) {
        EXPECT_TRUE(worker >= 0 && worker < threads);
        ++done[static_cast<std::size_t>(piece)];
      });
      for (const std::atomic<int>& count : done) EXPECT_EQ(count, 1);
    }
  }
}

TEST(Workers, are_as_many_as_processors_where_nobody_says) { EXPECT_GE(Workers(0).size(), 1); }

TEST(Workers, first_failure_by_number_is_thrown_and_later_runs_are_whole) {
  for (const int threads : {1, 4}) {
    Workers workers(threads);
    for (int repetition = 0; repetition < 50; ++repetition) {
      std::string thrown;
      try {
        workers.run(100, [](std::int64_t piece, int) {
          if (piece >= 17) throw std::runtime_error(std::to_string(piece));
        });
      } catch (const std::runtime_error& error) {
        thrown = error.what();
      }
      EXPECT_EQ(thrown, "17");
    }
    std::atomic<int> done = 0;
    workers.run(10, [&](std::int64_t, int) { ++done; });
    EXPECT_EQ(done, 10);
  }
}

}  // namespace
}  // namespace kanec::test
