// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/states/state_source.hpp"

#include "generator/scene/place.hpp"
#include "runtime/base/error.hpp"

namespace kanec {

TableFormat table_format_of(const std::string& name) {
  if (name == "csv") return TableFormat::csv;
  if (name == "jsonl") return TableFormat::json_lines;
  if (name == "npy") return TableFormat::npy;
  throw InputError("format: found " + scene::in_quotes(name) +
                   "; allowed: " + scene::one_of({"csv", "jsonl", "npy"}, name));
}

TableFormat table_format_of_file(const std::string& path) {
  if (path.ends_with(".npy")) return TableFormat::npy;
  if (path.ends_with(".jsonl") || path.ends_with(".ndjson") || path.ends_with(".json")) return TableFormat::json_lines;
  return TableFormat::csv;
}

std::unique_ptr<StateSource> open_states(const std::string& path, TableFormat format, const scene::Scene& scene,
                                         const Needs& needs) {
  switch (format) {
    case TableFormat::npy:
      return open_npy_states(path, scene, needs);
    case TableFormat::json_lines:
      return open_json_states(path, scene, needs);
    case TableFormat::csv:
      break;
  }
  return open_csv_states(path, scene, needs);
}

}  // namespace kanec
