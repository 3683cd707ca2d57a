// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/hard/hard_report.hpp"

#include <algorithm>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/model/scene_files.hpp"
#include "runtime/study/hard/hard_text.hpp"
#include "runtime/terminal/interrupt.hpp"
#include "runtime/terminal/progress.hpp"
#include "runtime/text/json.hpp"

namespace kanec::hard {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> folders_of(const HardOptions& options) {
  std::vector<fs::path> list;
  for (const std::string& word : options.folders.empty() ? std::vector<std::string>{"models/hard"} : options.folders) {
    if (!fs::is_directory(word)) throw InputError("--hard: found '" + word + "'; allowed: folders of hard cases");
    if (fs::exists(fs::path(word) / "hard.toml"))
      list.emplace_back(word);
    else
      for (fs::path& path : hard_cases(word)) list.push_back(std::move(path));
  }
  if (list.empty()) throw InputError("--hard: found no hard.toml; allowed: folders of hard cases, as models/hard");
  return list;
}

CaseReport report_of(const fs::path& folder, const HardOptions& options) {
  CaseReport report{folder, read_hard_case(folder), {}};
  const CompiledModel model = compiled(report.hard, options.build);
  const Interrupts interrupts;
  for (const Run& run : report.hard.runs) {
    ProgressBar bar(report.hard.name);
    report.outcomes.push_back(outcome(report.hard, options.brief ? run.brief : run.full, model, [&](double fraction) {
      interrupts.poll();
      bar.show(fraction);
    }));
  }
  return report;
}

bool holds(const CaseReport& report) {
  return std::all_of(report.outcomes.begin(), report.outcomes.end(),
                     [](const Outcome& one) { return one.holds() && one.accelerations.holds(); });
}

std::string command_of(const HardOptions& options) {
  std::string command = "kanec report --hard";
  for (const std::string& folder : options.folders) command += " " + typed(folder);
  return command + (options.brief ? " --short" : "") + " --markdown";
}

// The folder of a page; the working one where it goes to standard output.
fs::path place_of(const std::string& output) {
  return output == "-" || output == "/dev/stdout" ? fs::current_path() : fs::absolute(output).parent_path();
}

}  // namespace

bool report_hard_cases(const HardOptions& options) {
  const std::vector<fs::path> folders = folders_of(options);
  AtomicFile file(options.output);
  std::vector<CaseReport> reports;
  for (const fs::path& folder : folders) reports.push_back(report_of(folder, options));
  file.write(options.json       ? json_text(report_json(reports))
             : options.markdown ? report_markdown(reports, command_of(options), place_of(options.output))
                                : report_text(reports));
  file.commit();
  return std::all_of(reports.begin(), reports.end(), holds);
}

}  // namespace kanec::hard
