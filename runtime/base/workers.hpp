// A few threads that take numbered pieces of work in turn. Not: what a piece is; pieces must not depend on each other,
// so that results are the same whatever the number of threads.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace kanec {

class Workers {
 public:
  // As many in all, the caller of run() among them; 0: one a processor. The threads wait between runs.
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int size() const { return static_cast<int>(threads_.size()) + 1; }

  // work(piece, worker) once for every piece 0 .. pieces - 1, worker 0 .. size() - 1. Returns when all are done. Throws
  // what the first piece, by number, of those that threw did throw; after a throw no further pieces are begun.
  void run(std::int64_t pieces, const std::function<void(std::int64_t piece, int worker)>& work);

 private:
  void wait_for_work(int worker);
  void take_pieces(int worker);

  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable begin_, end_;
  const std::function<void(std::int64_t, int)>* work_ = nullptr;
  std::int64_t next_ = 0, pieces_ = 0;
  std::uint64_t run_ = 0;  // number of the present run
  int busy_ = 0;
  bool stop_ = false;
  std::exception_ptr error_;
  std::int64_t failed_ = 0;  // the piece that threw it
};

}  // namespace kanec
