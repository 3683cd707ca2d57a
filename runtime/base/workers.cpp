// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/workers.hpp"

#include <algorithm>
#include <utility>

namespace kanec {

Workers::Workers(int threads) {
  const int wanted = threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  for (int worker = 1; worker < wanted; ++worker) threads_.emplace_back([this, worker] { wait_for_work(worker); });
}

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  begin_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::wait_for_work(int worker) {
  std::uint64_t last = 0;
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      begin_.wait(lock, [&] { return stop_ || run_ != last; });
      if (stop_) return;
      last = run_;
    }
    take_pieces(worker);
    const std::lock_guard lock(mutex_);
    if (--busy_ == 0) end_.notify_one();
  }
}

void Workers::take_pieces(int worker) {
  for (;;) {
    std::int64_t piece = 0;
    {
      const std::lock_guard lock(mutex_);
      if (error_ || next_ == pieces_) return;
      piece = next_++;
    }
    try {
      (*work_)(piece, worker);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_ || piece < failed_) {
        error_ = std::current_exception();
        failed_ = piece;
      }
    }
  }
}

void Workers::run(std::int64_t pieces, const std::function<void(std::int64_t, int)>& work) {
  {
    const std::lock_guard lock(mutex_);
    work_ = &work;
    next_ = 0;
    pieces_ = pieces;
    busy_ = static_cast<int>(threads_.size());
    ++run_;
  }
  begin_.notify_all();
  take_pieces(0);
  std::unique_lock lock(mutex_);
  end_.wait(lock, [this] { return busy_ == 0; });
  work_ = nullptr;
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

}  // namespace kanec
