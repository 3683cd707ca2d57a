// Numbers as options have them: what is finite, and what an option allows. Not: numbers of files.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace kanec::cli {

// Checks of an option, which refuse with "found nan; allowed: ..." behind its name. None lets through what is not
// finite.
CLI::Validator positive();
CLI::Validator not_negative();
CLI::Validator within(double least, double most);

}  // namespace kanec::cli
