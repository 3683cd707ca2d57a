// The command line from its words to an exit status. Not: what the subcommands do (commands.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace kanec::cli {

enum ExitStatus {
  success = 0,
  check_failed = 1,
  refused = 2,        // an error that the caller can mend; told in one message
  unexpected = 3,     // a mistake in kanec, or no memory
  interrupted = 130,  // as shells have it
};

// Never throws.
int run(int argc, char** argv) noexcept;

}  // namespace kanec::cli
