// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/state_file.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "generator/scene/entry_names.hpp"
#include "generator/scene/place.hpp"
#include "generator/scene/states.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/model/state_layout.hpp"
#include "runtime/model/unit_norm.hpp"

namespace kanec {
namespace {

using nlohmann::json;

std::string shown(const json& value) {
  if (value.is_string()) return scene::in_quotes(value.get<std::string>());
  if (value.is_array()) return value.size() == 1 ? "a list of 1" : "a list of " + std::to_string(value.size());
  if (value.is_object()) return "an object";
  return value.dump();
}

// A part of the file: where it is, and what is refused there.
class Field {
 public:
  Field(const json& value, std::string file, std::string name)
      : value_(value), file_(std::move(file)), name_(std::move(name)) {}

  [[noreturn]] void refuse(const std::string& found, const std::string& allowed) const {
    throw InputError(file_ + ": " + (name_.empty() ? "" : name_ + ": ") + "found " + found + "; allowed: " + allowed);
  }

  const json& object(const std::string& allowed) const {
    if (!value_.is_object()) refuse(shown(value_), allowed);
    return value_;
  }

  Field at(const std::string& key) const { return {value_.at(key), file_, name_.empty() ? key : name_ + "." + key}; }
  bool has(const std::string& key) const { return value_.contains(key); }

  // Nothing but these; `allowed` says them in short.
  void only(const std::vector<std::string>& known, const std::string& allowed) const {
    const std::set<std::string> names(known.begin(), known.end());
    for (const auto& [key, ignored] : object(allowed).items())
      if (!names.contains(key)) {
        const std::string near = nearest(key, known);
        refuse("an unknown field " + scene::in_quotes(key),
               allowed + (near.empty() ? "" : " (did you mean " + near + "?)"));
      }
  }

  double number() const {
    if (!value_.is_number() || !std::isfinite(value_.get<double>())) refuse(shown(value_), "a finite number");
    return value_.get<double>();
  }

  void append_numbers(const Block& block, std::vector<double>& numbers) const {
    if (block.shape.empty()) {
      numbers.push_back(number());
      return;
    }
    const std::size_t count = block.size();
    const std::string allowed = "a list of " + std::to_string(count) + " finite numbers";
    if (!value_.is_array() || value_.size() != count) refuse(shown(value_), allowed);
    for (std::size_t i = 0; i < count; ++i)
      numbers.push_back(Field(value_[i], file_, name_ + "[" + std::to_string(i + 1) + "]").number());
  }

 private:
  const json& value_;
  std::string file_, name_;
};

[[noreturn]] void refuse_text(const std::string& file, const std::string& found) {
  throw InputError(file + ": found " + found + "; allowed: JSON (kanec eval --template shows it)");
}

// A field given twice would silently count once.
json parse(std::string_view text, const std::string& file) {
  std::vector<std::set<std::string>> open;
  const auto watch = [&](int, json::parse_event_t event, json& parsed) {
    if (event == json::parse_event_t::object_start) open.emplace_back();
    if (event == json::parse_event_t::object_end) open.pop_back();
    if (event == json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second)
      refuse_text(file, "the field " + scene::in_quotes(parsed.get<std::string>()) + " twice");
    return true;
  };
  try {
    return json::parse(text, watch);
  } catch (const json::exception& error) {
    const std::string what = error.what();  // "[json.exception.parse_error.101] parse error at line 1, ..."
    const std::size_t bracket = what.find("] ");
    refuse_text(file, bracket == std::string::npos ? what : what.substr(bracket + 2));
  }
}

std::vector<double> read_part(const Field& root, const Layout& layout, bool needed) {
  std::vector<double> numbers;
  const std::string summary = summary_of(layout);
  if (!root.has(layout.name)) {
    if (needed && !layout.blocks.empty()) root.refuse("no field \"" + layout.name + "\"", "an object with " + summary);
    return numbers;
  }
  const Field part = root.at(layout.name);
  std::vector<std::string> known;
  for (const Block& block : layout.blocks) known.insert(known.end(), {block.name, block.numbered});
  part.only(known, summary);
  for (const Block& block : layout.blocks) {
    const bool is_one = block.name == block.numbered, has = part.has(block.name);
    const bool has_number = !is_one && part.has(block.numbered);
    if (has && has_number)
      part.refuse("\"" + block.numbered + "\" and \"" + block.name + "\", which are one", "one of them");
    if (!has && !has_number) part.refuse("no field \"" + block.name + "\"", summary);
    part.at(has ? block.name : block.numbered).append_numbers(block, numbers);
  }
  return numbers;
}

std::vector<double> read_named(const Field& root, const std::string& name, const std::vector<scene::Named>& list) {
  std::vector<std::string> known;
  std::vector<double> values;
  for (const scene::Named& named : list) {
    known.push_back(named.name);
    values.push_back(named.value);
  }
  if (!root.has(name)) return values;
  const Field part = root.at(name);
  part.only(known, known.empty() ? "nothing: the scene has no " + name : "an object with the scene's " + name);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (part.has(known[i])) values[i] = part.at(known[i]).number();
  return values;
}

std::vector<std::string> normalise(const scene::Scene& scene, const std::string& file, std::vector<double>& x) {
  std::vector<std::string> notes;
  const std::vector<std::string> words = scene::body_words(scene);
  const auto field = [&](int body) { return file + ": x.eps_" + words[static_cast<std::size_t>(body - 1)] + ": "; };
  const UnitNorm norm = to_unit_norm(scene::Layout(scene), x);
  if (norm.zero > 0)
    throw InputError(field(norm.zero) + "found norm 0; allowed: Euler parameters, of which one is not zero");
  for (const UnitNorm::Off& off : norm.off)
    notes.push_back(field(off.body) + "normalised; its norm was " + shortest(off.norm));
  return notes;
}

Json named_json(const std::vector<scene::Named>& list, const std::vector<double>& values) {
  Json object = Json::object();
  for (std::size_t i = 0; i < list.size(); ++i) object[list[i].name] = values[i];
  return object;
}

}  // namespace

State initial_state(const scene::Scene& scene) {
  return {0.0,
          initial_coordinates(scene),
          initial_speeds(scene),
          std::vector<double>(static_cast<std::size_t>(n_speeds(scene)), 0.0),
          default_parameters(scene),
          default_inputs(scene)};
}

ReadState read_state(std::string_view text, const std::string& file, const scene::Scene& scene, const Needs& needs) {
  const json parsed = parse(text, file);
  const Field root(parsed, file, "");
  root.only({"t", "x", "y", "ydot", "parameters", "inputs"}, "an object with t, x, y, ydot, parameters, inputs");
  ReadState result;
  State& state = result.state;
  if (root.has("t")) state.t = root.at("t").number();
  state.x = read_part(root, coordinates_layout(scene), true);
  state.y = read_part(root, speeds_layout(scene), needs.y);
  state.ydot = read_part(root, speed_rates_layout(scene), needs.ydot);
  state.parameters = read_named(root, "parameters", scene.parameters);
  state.inputs = read_named(root, "inputs", scene.inputs);
  result.notes = normalise(scene, file, state.x);
  return result;
}

Json state_json(const scene::Scene& scene, const State& state) {
  Json object = Json::object();
  if (reads_time(scene)) object["t"] = state.t;
  object["x"] = coordinates_layout(scene).json(state.x);
  if (!state.y.empty()) object["y"] = speeds_layout(scene).json(state.y);
  if (!state.ydot.empty()) object["ydot"] = speed_rates_layout(scene).json(state.ydot);
  if (!scene.parameters.empty()) object["parameters"] = named_json(scene.parameters, state.parameters);
  if (!scene.inputs.empty()) object["inputs"] = named_json(scene.inputs, state.inputs);
  return object;
}

}  // namespace kanec
