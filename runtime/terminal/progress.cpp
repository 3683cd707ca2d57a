// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/terminal/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "runtime/base/fit.hpp"

namespace kanec {
namespace {

constexpr int width = 40;

// Nothing depends on whether it arrives.
void draw(const std::string& text) {
  if (::write(STDERR_FILENO, text.data(), text.size()) < 0) return;
}

}  // namespace

ProgressBar::ProgressBar(std::string_view what) : what_(fit::line(what)), terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_) draw("\r\033[K");
}

void ProgressBar::show(double fraction) {
  if (!terminal_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  drawn_ = true;
  const double part = std::clamp(fraction, 0.0, 1.0);
  const int filled = static_cast<int>(part * width);
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  const std::string left = part > 0.0 ? fmt::format(", {:.0f} s left", elapsed * (1.0 - part) / part) : "";
  draw(fmt::format("\r{} [{:=<{}}{: <{}}] {:3.0f} %{}\033[K", what_, "", filled, "", width - filled, 100.0 * part,
                   left));
}

}  // namespace kanec
