// Oracles: this process, and a child that is stopped and killed.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/process_state.hpp"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace kanec {
namespace {

TEST(ProcessState, of_this_process_is_running_and_the_same_twice) {
  const auto first = state_of_process(::getpid()), second = state_of_process(::getpid());
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->start, second->start);
  EXPECT_FALSE(first->start.empty());
  EXPECT_FALSE(first->is_stopped);
}

TEST(ProcessState, of_a_child_says_when_it_is_stopped_and_is_none_once_it_is_dead) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_NAME, "a) T \x1b[1m");  // neither the end of the name, nor anything for a terminal
    ::raise(SIGSTOP);
    for (;;) ::pause();
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, WUNTRACED), child);
  const auto stopped = state_of_process(child);
  ASSERT_TRUE(stopped);
  EXPECT_TRUE(stopped->is_stopped);
  EXPECT_EQ(stopped->name, "a) T ?[1m");
  ::kill(child, SIGCONT);
  ASSERT_EQ(::waitpid(child, &status, WCONTINUED), child);
  EXPECT_FALSE(state_of_process(child)->is_stopped);
  ::kill(child, SIGKILL);
  siginfo_t information{};
  ::waitid(P_PID, static_cast<id_t>(child), &information, WEXITED | WNOWAIT);
  EXPECT_FALSE(state_of_process(child));  // not yet waited for
  ::waitpid(child, nullptr, 0);
  EXPECT_FALSE(state_of_process(child));
  EXPECT_FALSE(state_of_process(0));
}

}  // namespace
}  // namespace kanec
