// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/bench/contest_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>

#include "runtime/base/fit.hpp"
#include "runtime/model/dump.hpp"
#include "runtime/text/table.hpp"

namespace kanec {
namespace {

// "1.2e-13", "equal", or nothing.
std::string difference_text(const std::optional<double>& difference) {
  if (!difference) return "";
  return *difference == 0.0 ? "0" : fmt::format("{:.1e}", *difference);
}

std::string ratio_text(const Entry& entry, const Entry& first) {
  return entry.time && first.time ? fmt::format("{:.2f}", entry.time->median / first.time->median) : "";
}

// Why there is no time, or what the operations are where the first entry has others.
std::string remarks(const Entry& entry, const Entry& first) {
  if (!entry.time) return fit::line(entry.note);
  const bool is_told = &entry != &first && entry.cost == first.cost;
  return entry.cost && !is_told ? program::text(*entry.cost) : "";
}

TextRow entry_row(const Entry& entry, const Entry& first) {
  return {&entry == &first ? entry.function : "",
          entry.name,
          entry.time ? fmt::format("{:.1f} ns", entry.time->median) : "-",
          ratio_text(entry, first),
          entry.cost ? std::to_string(entry.cost->operations()) : "",
          entry.code_bytes ? std::to_string(*entry.code_bytes) : "",
          entry.compile_seconds ? fmt::format("{:.2f} s", *entry.compile_seconds) : "",
          difference_text(entry.difference),
          remarks(entry, first)};
}

Json optional_json(const auto& value) { return value ? Json(*value) : Json(nullptr); }

Json json(const Entry& entry, const Entry& first) {
  Json json = {{"function", entry.function}, {"path", entry.name}};
  json["ns"] = entry.time ? Json(entry.time->median) : Json(nullptr);
  json["least_ns"] = entry.time ? Json(entry.time->least) : Json(nullptr);
  json["ratio"] = entry.time && first.time ? Json(entry.time->median / first.time->median) : Json(nullptr);
  if (entry.cost) {
    json["operations"] = entry.cost->operations();
    json["ledger"] = ledger_json(*entry.cost);
    json["code_bytes"] = optional_json(entry.code_bytes);
    json["compile_s"] = optional_json(entry.compile_seconds);
  }
  json["difference"] = optional_json(entry.difference);
  if (!entry.note.empty()) json["note"] = entry.note;
  return json;
}

}  // namespace

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0 && line.find(": ") != line.npos) return line.substr(line.find(": ") + 2);
  return "";
}

std::string footnotes(const std::vector<Contest>& contests) {
  std::vector<std::string> lines;
  for (const Contest& contest : contests)
    for (const Entry& entry : contest.entries)
      if (entry.time && !entry.note.empty()) lines.push_back(entry.name + ": " + fit::line(entry.note) + "\n");
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return fmt::format("{}", fmt::join(lines, ""));
}

std::string text(const Contest& contest) {
  std::vector<TextRow> rows = {
      {"function", "path", "time", "ratio", "operations", "code bytes", "compiled in", "difference", ""}};
  for (const Entry& entry : contest.entries) rows.push_back(entry_row(entry, contest.first(entry.function)));
  return contest.model + "\n" + text_table(rows, "llrrrrrrl");
}

Json json(const Contest& contest) {
  Json entries = Json::array();
  for (const Entry& entry : contest.entries) entries.push_back(json(entry, contest.first(entry.function)));
  return {{"model", contest.model}, {"hash", contest.hash}, {"entries", entries}};
}

}  // namespace kanec
