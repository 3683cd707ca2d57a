// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/bench/contest_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "runtime/base/fit.hpp"
#include "runtime/bench/contest_text.hpp"

namespace kanec {
namespace {

// Everything but the figures.
constexpr auto beginning = R"(# Benchmarks

Written by

    {}

Times differ from machine to machine and by some tens of percent from run to run, ratios less: all paths run in turn in one
process. Operations (additions, multiplications, divisions) are exact and hold anywhere. Without `--markdown` the same
command prints text, with `--json` for machines; `taskset -c 1` before it keeps it on one core.

Processor: {}. Emitted code by {}.

## Times

In brackets: times emitted.
)";

constexpr auto method = R"(
## What is timed

The function of a state in double precision: 256 random states in turn, five repetitions in random order mixed with those
of all other paths, the median of their processor times on one core. Before that every path is compared with the generic
path of kanec (an independent numeric one) in 16 states with loads on all joints; the largest differences stand in the
last table. What differs by more than 1e-9 is not timed.

Each engine goes its shortest way from a state to accelerations; states and loads are put into its own coordinates
beforehand, springs and dampers are forces by then, and bodies that are welded together are one:

- **Bullet**: positions and speeds set link by link, `computeAccelerationsArticulatedBodyAlgorithmMultiDof`; the weight of
  each link is applied once, before. A free root is its moving base, another free joint four links.
- **MuJoCo**: `mj_kinematics`, `mj_comPos`, `mj_crb`, `mj_factorM`, `mj_comVel`, `mj_rne`, `mj_solveM`: nothing for contacts,
  constraints, actuators or sensors. Its principal axes of inertia, which it finds to 1e-8, are overwritten by accurate ones.
- **Simbody**: `realize` to the stage of dynamics, weights as body forces,
  `calcAccelerationIgnoringConstraints`.

The adapters are in [tests/bench/peers](../tests/bench/peers); they are built where the engines' Debian packages
(`libbullet-dev`, `libmujoco-dev`, `libsimbody-dev`) are installed, and kanec finds them beside itself. What limits the emitted code: [profile.md](profile.md).
)";

std::string time_text(const Time& time) {
  if (time.median < 999.5) return fmt::format("{:.0f} ns", time.median);
  return time.median < 999.5e3 ? fmt::format("{:.3g} µs", time.median * 1e-3)
                               : fmt::format("{:.3g} ms", time.median * 1e-6);
}

// In order of first appearance.
std::vector<std::string> paths(const std::vector<Contest>& contests) {
  std::vector<std::string> list;
  for (const Contest& contest : contests)
    for (const Entry& entry : contest.entries)
      if (std::find(list.begin(), list.end(), entry.name) == list.end()) list.push_back(entry.name);
  return list;
}

// In two or three digits.
std::string page_ratio(double ratio) { return fmt::format("{:.{}f}", ratio, ratio < 1.0 ? 2 : ratio < 10.0 ? 1 : 0); }

using Cell = std::string (*)(const Entry& entry, const Entry& first);

std::string time_cell(const Entry& entry, const Entry& first) {
  if (!entry.time) return "–";
  if (&entry == &first || !first.time) return time_text(*entry.time);
  return fmt::format("{} ({})", time_text(*entry.time), page_ratio(entry.time->median / first.time->median));
}

std::string difference_cell(const Entry& entry, const Entry&) {
  return entry.difference ? fmt::format("{:.0e}", *entry.difference) : "";
}

// The cell of every path of one function.
std::string cells(const Contest& contest, const Entry& first, const std::vector<std::string>& paths, Cell cell) {
  std::string text;
  for (const std::string& path : paths) {
    const auto found = std::find_if(contest.entries.begin(), contest.entries.end(), [&](const Entry& entry) {
      return entry.function == first.function && entry.name == path;
    });
    text += fmt::format(" {} |", found == contest.entries.end() ? "" : cell(*found, first));
  }
  return text;
}

std::string headings(const std::string& front, const std::string& rule, const std::vector<std::string>& paths) {
  std::string names = "\n" + front, rules = rule;
  for (const std::string& path : paths) {
    names += fmt::format(" {} |", path);
    rules += "--:|";
  }
  return names + "\n" + rules + "\n";
}

// row(contest, entry) for the first entry of every function.
template <class Row>
std::string rows(const std::vector<Contest>& contests, Row row) {
  std::string text;
  for (const Contest& contest : contests)
    for (const Entry& entry : contest.entries)
      if (&entry == &contest.first(entry.function)) text += row(contest, entry);
  return text;
}

std::string time_table(const std::vector<Contest>& contests) {
  const std::vector<std::string> names = paths(contests);
  return headings("| scene | function | operations | code bytes | compiled in |", "|---|---|--:|--:|--:|", names) +
         rows(contests, [&](const Contest& contest, const Entry& entry) {
           return fmt::format("| {} | {} | {} | {} | {} |{}\n", contest.model, entry.function,
                              entry.cost ? std::to_string(entry.cost->operations()) : "",
                              entry.code_bytes ? std::to_string(*entry.code_bytes) : "",
                              entry.compile_seconds ? fmt::format("{:.2f} s", *entry.compile_seconds) : "",
                              cells(contest, entry, names, time_cell));
         });
}

std::string difference_table(const std::vector<Contest>& contests) {
  std::vector<std::string> names = paths(contests);
  names.erase(std::remove(names.begin(), names.end(), "generic"), names.end());
  return headings("| scene | function |", "|---|---|", names) +
         rows(contests, [&](const Contest& contest, const Entry& entry) {
           return fmt::format("| {} | {} |{}\n", contest.model, entry.function,
                              cells(contest, entry, names, difference_cell));
         });
}

// What was not timed, and what has to be known beside times.
std::string notes(const std::vector<Contest>& contests) {
  std::string text;
  for (const Contest& contest : contests)
    for (const Entry& entry : contest.entries)
      if (!entry.time)
        text +=
            fmt::format("- {}, {}, {}: {}.\n", contest.model, entry.function, entry.name, fit::markdown(entry.note));
  const std::string known = footnotes(contests);
  for (std::size_t at = 0; at < known.size();) {
    const std::size_t end = known.find('\n', at);
    text += "- " + fit::markdown(known.substr(at, end - at)) + ".\n";
    at = end + 1;
  }
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

std::string page(const std::vector<Contest>& contests, const Conditions& conditions, const std::string& command,
                 const std::string& picture) {
  std::string text =
      fmt::format(beginning, command, fit::markdown(conditions.processor), fit::markdown(conditions.compiler));
  text += time_table(contests) + notes(contests);
  if (!picture.empty())
    text += fmt::format("\n![The same on a logarithmic axis]({})\n",
                        fit::link(std::filesystem::path(picture).filename().string()));
  return text + method + "\n## Largest differences from the generic path, relative\n" + difference_table(contests);
}

}  // namespace kanec
