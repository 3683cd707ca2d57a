// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/states/file_reader.hpp"
#include "runtime/states/state_source.hpp"
#include "runtime/text/csv.hpp"

namespace kanec {
namespace {

class JsonStates : public StateSource {
 public:
  JsonStates(const std::string& path, const scene::Scene& scene, const Needs& needs)
      : file_(path), scene_(scene), needs_(needs) {}

  bool next(State& state) override {
    std::string_view text;
    do {
      ++line_;
      if (!file_.line(text)) return false;
      text = trimmed(text);
    } while (text.empty());
    state = read_state(text, place(), scene_, needs_).state;
    return true;
  }

  bool has_values() const override { return !scene_.parameters.empty() || !scene_.inputs.empty(); }
  std::string place() const override { return file_.name() + ":" + std::to_string(line_); }
  double share() const override { return file_.share(); }

 private:
  FileReader file_;
  const scene::Scene& scene_;
  Needs needs_;
  std::size_t line_ = 0;
};

}  // namespace

std::unique_ptr<StateSource> open_json_states(const std::string& path, const scene::Scene& scene, const Needs& needs) {
  return std::make_unique<JsonStates>(path, scene, needs);
}

}  // namespace kanec
