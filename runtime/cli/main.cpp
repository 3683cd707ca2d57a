// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/kanec.hpp"

int main(int argc, char** argv) { return kanec::cli::run(argc, argv); }
