// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/states/results.hpp"

#include <utility>

#include "runtime/base/files.hpp"
#include "runtime/base/text.hpp"
#include "runtime/states/npy.hpp"

namespace kanec {
namespace {

class CsvResults : public ResultSink {
 public:
  CsvResults(const std::string& path, const std::vector<Layout>& layouts) : file_(path) {
    for (const std::string& name : result_names(layouts)) line_ += (line_.empty() ? "" : ",") + name;
    file_.write(line_ + "\n");
  }
  void add(std::span<const double> values) override {
    line_.clear();
    for (const double value : values) line_ += (line_.empty() ? "" : ",") + shortest(value);
    line_ += '\n';
    file_.write(line_);
  }
  void finish() override { file_.commit(); }

 private:
  AtomicFile file_;
  std::string line_;
};

class JsonResults : public ResultSink {
 public:
  JsonResults(const std::string& path, std::vector<Layout> layouts) : file_(path), layouts_(std::move(layouts)) {}
  void add(std::span<const double> values) override {
    Json object = Json::object();
    for (const Layout& layout : layouts_) {
      object[layout.name] = layout.json(values.first(layout.size()));
      values = values.subspan(layout.size());
    }
    file_.write(object.dump() + "\n");
  }
  void finish() override { file_.commit(); }

 private:
  AtomicFile file_;
  std::vector<Layout> layouts_;
};

// The number of rows stands in front.
class NpyResults : public ResultSink {
 public:
  NpyResults(const std::string& path, std::size_t columns, std::optional<std::int64_t> count)
      : file_(path), columns_(columns), is_streaming_(count.has_value()) {
    if (count) file_.write(npy_header(*count, static_cast<std::int64_t>(columns)));
  }
  void add(std::span<const double> values) override {
    const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    if (is_streaming_)
      file_.write(bytes);
    else
      numbers_ += bytes;
    ++rows_;
  }
  void finish() override {
    if (!is_streaming_) file_.write(npy_header(rows_, static_cast<std::int64_t>(columns_)));
    file_.write(numbers_);
    file_.commit();
  }

 private:
  AtomicFile file_;
  std::size_t columns_;
  bool is_streaming_;
  std::int64_t rows_ = 0;
  std::string numbers_;
};

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() || unit.find(',') != unit.npos ? name : name + "[" + unit + "]";
}

void append_names(std::vector<std::string>& names, const std::string& name, const Block& block) {
  const std::size_t width = block.shape.empty() ? 1 : static_cast<std::size_t>(block.shape.back());
  for (std::size_t i = 0; i < block.size(); ++i) {
    std::string at = name;
    if (block.shape.size() == 2) at += "_" + std::to_string(i / width + 1);
    if (!block.shape.empty()) at += "_" + std::to_string(i % width + 1);
    names.push_back(with_unit(at, block.unit));
  }
}

}  // namespace

std::vector<std::string> result_names(const std::vector<Layout>& layouts) {
  std::vector<std::string> names;
  for (const Layout& layout : layouts)
    for (const Block& block : layout.blocks)
      append_names(names, (layouts.size() > 1 ? layout.name + "." : "") + block.name, block);
  return names;
}

std::unique_ptr<ResultSink> open_results(const std::string& path, TableFormat format, std::vector<Layout> layouts,
                                         std::optional<std::int64_t> count) {
  switch (format) {
    case TableFormat::npy: {
      std::size_t columns = 0;
      for (const Layout& layout : layouts) columns += layout.size();
      return std::make_unique<NpyResults>(path, columns, count);
    }
    case TableFormat::json_lines:
      return std::make_unique<JsonResults>(path, std::move(layouts));
    case TableFormat::csv:
      break;
  }
  return std::make_unique<CsvResults>(path, layouts);
}

}  // namespace kanec
