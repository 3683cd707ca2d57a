// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/hard/hard_case.hpp"

#include <algorithm>

#include "generator/read/node.hpp"
#include "generator/read/parse_toml.hpp"
#include "generator/read/read.hpp"
#include "generator/read/read_simulation.hpp"
#include "runtime/base/files.hpp"

namespace kanec::hard {
namespace {

namespace fs = std::filesystem;
using scene::Node;
using scene::Table;

std::vector<Bound> read_bounds(const Node& node) {
  std::vector<Bound> bounds;
  for (const Table::Entry& entry : Table(node, "keeps.").entries()) {
    const double most = entry.node.real("a positive number");
    if (most <= 0) entry.node.refuse("a positive number");
    bounds.push_back({entry.key, most});
  }
  return bounds;
}

Length read_length(const Table& table, const Length& usual, const std::string& origin,
                   std::vector<std::string> more_keys) {
  more_keys.push_back("keeps");
  Length length = usual;
  length.settings = scene::read_simulation(table, usual.settings, origin, more_keys);
  if (const auto found = table.find("keeps")) length.keeps = read_bounds(*found);
  return length;
}

Run read_run(const Node& node, const scene::Simulation& usual) {
  const Table table(node, "run.");
  Run run;
  run.full = read_length(table, {usual, {}}, "of scene.toml", {"short"});
  run.brief = run.full;
  if (const auto brief = table.find("short"))
    run.brief = read_length(Table(*brief, "run.short."), run.full, "of the run", {});
  return run;
}

}  // namespace

HardCase read_hard_case(const fs::path& folder) {
  HardCase hard;
  hard.name = (fs::absolute(folder) / "").lexically_normal().parent_path().filename().string();
  hard.scene = scene::read(folder / "scene.toml");
  hard.file = (folder / "hard.toml").string();
  const toml::table table = scene::parse_toml(read_file(hard.file), hard.file);
  const Table root(table, {hard.file}, "");
  root.only({"case", "source", "answer", "run"});
  hard.title = root.at("case", "what is hard, in a line").text("what is hard, in a line");
  hard.source = root.at("source", "where the answer is from").text("where the answer is from");
  if (const auto answer = root.find("answer")) {
    hard.answer = answer->text("the name of a known answer");
    hard.answer_line = answer->place().line;
  }
  for (const Node& run : root.at("run", "[[run]] tables").list("[[run]] tables"))
    hard.runs.push_back(read_run(run, hard.scene.simulation));
  return hard;
}

std::vector<fs::path> hard_cases(const fs::path& folder) {
  std::vector<fs::path> list;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (fs::exists(entry.path() / "hard.toml")) list.push_back(entry.path());
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace kanec::hard
