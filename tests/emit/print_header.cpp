// Prints the header of a scene: the generator in a process of its own.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <iostream>

#include "generator/pipeline.hpp"
#include "generator/read/read.hpp"

int main(int, char** argv) { std::cout << kanec::generate(kanec::scene::read(argv[1])).header; }
