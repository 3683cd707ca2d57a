// What the two sources behind the ABI have in common: names, sizes and operations as tables. Not: their calls.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/emit/model.hpp"
#include "generator/emit/used.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

// "{values[0], values[1]}" for the fields of a struct; with `close` behind each.
std::string spread(const std::string& array, std::size_t count, const std::string& close = "");

// The file's first lines, up to the anonymous namespace in which `model` is the header's; `what`: "in double".
std::string begin(const scene::Scene& scene, const std::string& what, const std::string& includes);

// Bodies whose Euler parameters are in the state, and their places as an array with one entry more.
std::vector<scene::BodyLayout> attitudes(const scene::Scene& scene);
std::string attitude_list(const scene::Scene& scene);

// The kanec_model `description` with its tables; unless callable without functions, for which null stands.
std::string described(const Model& model, const program::Program& program, const Used& read, bool callable);

// The exported function that returns a pointer.
std::string entry(const std::string& type, const std::string& name, const std::string& value);

}  // namespace kanec::emit
