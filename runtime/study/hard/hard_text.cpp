// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/hard/hard_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "runtime/base/fit.hpp"
#include "runtime/study/report/methods.hpp"
#include "runtime/text/table.hpp"

namespace kanec::hard {
namespace {

// Two digits are more than rounding errors have; whole numbers as far as they go.
std::string shown(double value) { return fmt::format("{:.2g}", value); }

std::string shown(const Kept& kept) {
  return fmt::format("{} {}{}{} ({}){}", kept.what, shown(kept.found), kept.unit.empty() ? "" : " ", kept.unit,
                     shown(kept.most), kept.holds() ? "" : " NOT KEPT");
}

std::string kept_text(const Outcome& one) {
  if (!one.failure.empty()) return fit::line(one.failure);
  std::string text;
  for (const Kept& kept : one.kept) text += (text.empty() ? "" : ", ") + shown(kept);
  return text;
}

// "1.2 (generic path 3.4)"
std::string rounding_text(const Rounding& r) {
  return fmt::format("{} (generic {}){}", shown(r.emitted), shown(r.generic), r.holds() ? "" : " WORSE");
}

TextRow row(const HardCase& hard, const Outcome& one) {
  const std::string length = fmt::format("{} s", shown(one.options.duration));
  if (!one.failure.empty())
    return {fit::line(hard.name), method_text(one.options), length, "", "", "", "", kept_text(one)};
  return {fit::line(hard.name),
          method_text(one.options),
          length,
          std::to_string(one.summary.steps),
          shown(one.summary.wall_seconds),
          rounding_text(one.accelerations),
          fmt::format("{}{}", shown(one.accelerations.single), one.accelerations.suffices_single() ? "" : " no"),
          kept_text(one)};
}

const TextRow head = {
    "case", "integrator", "length", "steps", "time [s]", "ulps of accelerations", "float", "kept, at worst (allowed)"};

}  // namespace

std::string report_text(const std::vector<CaseReport>& cases) {
  std::vector<TextRow> rows = {head};
  for (const CaseReport& one : cases)
    for (const Outcome& outcome : one.outcomes) rows.push_back(row(one.hard, outcome));
  return text_table(rows, "lllrrrrl");
}

std::string report_markdown(const std::vector<CaseReport>& cases, const std::string& command,
                            const std::filesystem::path& place) {
  std::string text = "# Hard cases\n\nWritten by " + fit::code(command) + R"(.

Each is a folder with a scene, its known answer and source. Of every run stands what it kept at its worst, and in
brackets what it is allowed: energy, momenta and invariants relative, attitudes in rad, positions relative or in m as
the answer has them. *time* is of the run with its answer beside it, which takes longer where that is a run in higher
precision itself (answers `reference` and `precise`). *ulps*: the median error of the accelerations over states of the
run, from the generic path in long double, beside that of the generic path in double. *float*: the same of the program
in single precision, relative; "no" where it leaves fewer than three digits.

)";
  const auto line = [&text](const TextRow& cells) {
    for (const std::string& cell : cells) text += "| " + cell + " ";
    text += "|\n";
  };
  line(head);
  text += "|---|---|--:|--:|--:|--:|--:|---|\n";
  for (const CaseReport& one : cases) {
    const std::string link = std::filesystem::relative(one.folder, place).generic_string();
    for (const Outcome& outcome : one.outcomes) {
      TextRow cells = row(one.hard, outcome);
      cells[0] =
          fmt::format("[{}]({}): {}", fit::markdown(one.hard.name), fit::link(link), fit::markdown(one.hard.title));
      cells.back() = fit::markdown(cells.back());
      line(cells);
    }
  }
  return text;
}

Json report_json(const std::vector<CaseReport>& cases) {
  const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
  // of a run that failed nothing was measured
  const auto measured = [](const Outcome& outcome, const Json& value) {
    return outcome.failure.empty() ? value : Json(nullptr);
  };
  Json list = Json::array();
  for (const CaseReport& one : cases) {
    Json runs = Json::array();
    for (const Outcome& outcome : one.outcomes) {
      Json kept = Json::array();
      for (const Kept& k : outcome.kept)
        kept.push_back(
            {{"what", k.what}, {"unit", k.unit}, {"found", number(k.found)}, {"most", k.most}, {"holds", k.holds()}});
      runs.push_back({{"integrator", integrate::name_of(outcome.options.method)},
                      {"duration", outcome.options.duration},
                      {"steps", measured(outcome, outcome.summary.steps)},
                      {"evaluations", measured(outcome, outcome.summary.evaluations)},
                      {"wall_seconds", measured(outcome, outcome.summary.wall_seconds)},
                      {"failure", outcome.failure},
                      {"kept", kept},
                      {"emitted_ulps", measured(outcome, number(outcome.accelerations.emitted))},
                      {"generic_ulps", measured(outcome, number(outcome.accelerations.generic))},
                      {"float_error", measured(outcome, number(outcome.accelerations.single))},
                      {"holds", outcome.holds() && outcome.accelerations.holds()}});
    }
    list.push_back({{"case", one.hard.name}, {"title", one.hard.title}, {"source", one.hard.source}, {"runs", runs}});
  }
  return list;
}

}  // namespace kanec::hard
