// States one after another, from a file of CSV, JSON lines or NumPy's .npy. Not: what is done with them.
//
// CSV: a header line of names (t, coordinates, speeds, their rates, parameters, inputs; each by the number or the name
// of its body, a unit in brackets behind if one likes), then a line a state. kinetic, potential and work of a
// trajectory are passed over. JSON lines: a state file (runtime/model/state_file.hpp) a line. .npy: a row a state: x,
// then y and ydot where the function reads them; or these behind t.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/model/state_file.hpp"

namespace kanec {

enum class TableFormat { csv, json_lines, npy };

// "csv", "jsonl", "npy"; throws InputError for another one.
TableFormat table_format_of(const std::string& name);
// By the ending of a file's name; csv where it says nothing.
TableFormat table_format_of_file(const std::string& path);

class StateSource {
 public:
  virtual ~StateSource() = default;
  // The next one into `state`, which holds the one before, or the scene's own. False at the end. Throws InputError that
  // names the line, FileError.
  virtual bool next(State& state) = 0;
  // Whether states have parameters or inputs of their own.
  virtual bool has_values() const = 0;
  // "states.csv:12", of the one that next() gave.
  virtual std::string place() const = 0;
  virtual double share() const = 0;                                           // that was read
  virtual std::optional<std::int64_t> count() const { return std::nullopt; }  // of all states, where it is known before
};

std::unique_ptr<StateSource> open_states(const std::string& path, TableFormat format, const scene::Scene& scene,
                                         const Needs& needs);

std::unique_ptr<StateSource> open_csv_states(const std::string& path, const scene::Scene& scene, const Needs& needs);
std::unique_ptr<StateSource> open_json_states(const std::string& path, const scene::Scene& scene, const Needs& needs);
std::unique_ptr<StateSource> open_npy_states(const std::string& path, const scene::Scene& scene, const Needs& needs);

}  // namespace kanec
