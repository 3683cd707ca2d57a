// Numbers as options have them: what is finite, and what an option allows. Not: numbers of files.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace kanec::cli {

// The number that the whole text is; none where it is no number, or no finite one.
std::optional<double> finite_number(const std::string& text);

// Checks of an option, which refuse with "found nan; allowed: ..." behind its name. None lets through what is not
// finite.
CLI::Validator positive();
CLI::Validator not_negative();
CLI::Validator within(double least, double most);

}  // namespace kanec::cli
