// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <optional>

#include "generator/scene/entry_names.hpp"
#include "generator/scene/place.hpp"
#include "runtime/base/error.hpp"
#include "runtime/states/file_reader.hpp"
#include "runtime/states/state_source.hpp"
#include "runtime/text/csv.hpp"

namespace kanec {
namespace {

using scene::Entry;
using Among = scene::Entry::Among;

class CsvStates : public StateSource {
 public:
  CsvStates(const std::string& path, const scene::Scene& scene, const Needs& needs)
      : file_(path), names_(scene), scene_(scene.name) {
    read_header(needs);
  }

  bool next(State& state) override {
    std::string_view row;
    do {
      ++line_;
      if (!file_.line(row)) return false;
      row = trimmed(row);
    } while (!is_csv_row(row));
    std::size_t column = 0;
    for (std::size_t begin = 0; begin <= row.size(); ++column) {
      const std::size_t end = std::min(row.find(',', begin), row.size());
      if (column < columns_.size()) set(state, column, trimmed(row.substr(begin, end - begin)));
      begin = end + 1;
    }
    if (column != columns_.size())
      refuse(place(), std::to_string(column) + " numbers",
             std::to_string(columns_.size()) + ", one a column of the header");
    return true;
  }

  bool has_values() const override {
    return std::any_of(columns_.begin(), columns_.end(), [](const Column& column) {
      return column.entry && (column.entry->among == Among::parameters || column.entry->among == Among::inputs);
    });
  }
  std::string place() const override { return file_.name() + ":" + std::to_string(line_); }
  double share() const override { return file_.share(); }

 private:
  struct Column {
    std::string name;
    std::optional<Entry> entry = {};
    bool is_time = false;
  };

  [[noreturn]] static void refuse(const std::string& place, const std::string& found, const std::string& allowed) {
    throw InputError(place + ": found " + found + "; allowed: " + allowed);
  }

  void read_header(const Needs& needs) {
    std::string_view header;
    do {
      ++line_;
      if (!file_.line(header)) refuse(file_.name(), "nothing", "a header line of names and a line a state");
      if (line_ == 1 && header.starts_with("\xef\xbb\xbf")) header.remove_prefix(3);
      header = trimmed(header);
    } while (!is_csv_row(header));
    for (const std::string_view cell : csv_cells(header)) add_column(std::string(without_unit(cell)));
    require(Among::x, true);
    require(Among::y, needs.y);
    require(Among::ydot, needs.ydot);
  }

  void add_column(const std::string& name) {
    const std::string column = place() + ": column " + std::to_string(columns_.size() + 1);
    if (name == "kinetic" || name == "potential" || name == "work") {
      columns_.push_back({name});
      return;
    }
    const std::optional<Entry> entry = names_.find(name);
    if (name != "t" && !entry)
      refuse(
          column, scene::in_quotes(name),
          "t, or of " + scene_ + ": " +
              scene::one_of(names_.known({Among::x, Among::y, Among::ydot, Among::parameters, Among::inputs}), name));
    for (const Column& other : columns_)
      if (name == "t" ? other.is_time
                      : other.entry && other.entry->among == entry->among && other.entry->index == entry->index)
        refuse(column, scene::in_quotes(name) + " twice", "each once");
    columns_.push_back({name, entry, name == "t"});
  }

  void require(Among among, bool needed) const {
    for (std::size_t i = 0; needed && i < names_.printed(among).size(); ++i) {
      const bool is_there = std::any_of(columns_.begin(), columns_.end(), [&](const Column& column) {
        return column.entry && column.entry->among == among && column.entry->index == static_cast<int>(i);
      });
      if (!is_there)
        refuse(place(), "no column " + names_.printed(among)[i], "a column for each that the function reads");
    }
  }

  void set(State& state, std::size_t column, std::string_view cell) const {
    const Column& at = columns_[column];
    if (!at.entry && !at.is_time) return;
    const std::optional<double> value = csv_number(cell);
    if (!value) refuse(place() + ": " + at.name, cell.empty() ? "nothing" : scene::in_quotes(cell), "a finite number");
    if (at.is_time) {
      state.t = *value;
      return;
    }
    std::vector<double>* const lists[] = {&state.x, &state.y, &state.ydot, &state.parameters, &state.inputs};
    (*lists[static_cast<std::size_t>(at.entry->among)])[static_cast<std::size_t>(at.entry->index)] = *value;
  }

  FileReader file_;
  scene::EntryNames names_;
  std::string scene_;
  std::vector<Column> columns_;
  std::size_t line_ = 0;
};

}  // namespace

std::unique_ptr<StateSource> open_csv_states(const std::string& path, const scene::Scene& scene, const Needs& needs) {
  return std::make_unique<CsvStates>(path, scene, needs);
}

}  // namespace kanec
