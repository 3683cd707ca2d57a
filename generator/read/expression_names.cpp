// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/expression_names.hpp"

#include "generator/scene/component.hpp"
#include "runtime/base/text.hpp"

namespace kanec::scene {
namespace {

using Kind = ExpressionNode::Kind;

// Why a coordinate or speed that is not in the state cannot be read; empty of one that is.
std::string absence(const Scene& scene, const Component& component, int index) {
  if (index >= 0) return "";
  const Coordinate* coordinate = coordinate_of(scene, component);
  if (!coordinate) return "of an attitude that is held, and no part of the state";
  if (coordinate->motion == Coordinate::Motion::locked)
    return "which is locked at " + shortest(coordinate->value) + ", and no part of the state";
  const auto& text = scene.expressions[static_cast<std::size_t>(coordinate->expression)].text;
  return "which is prescribed as " + in_quotes(text) + ", and no part of the state";
}

// The list, with names that stand for two different things refused.
class List {
 public:
  void add(const std::string& name, const ExpressionNode& node, const std::string& refusal) {
    const auto [at, is_new] = index_.try_emplace(name, names_.size());
    if (is_new)
      names_.push_back({name, node, refusal});
    else
      names_[at->second].refusal = "the name of two components: of one body's only one, and of another's several";
  }
  const std::vector<ExpressionName>& names() const { return names_; }

 private:
  std::vector<ExpressionName> names_;
  std::map<std::string, std::size_t> index_;
};

// By the names of bodies first: these are what a message shows.
void add_components(const Scene& scene, List& list) {
  const Layout layout(scene);
  const auto add = [&](const Component& c, bool speed, bool by_name) {
    const int index = speed ? index_in_y(layout, c) : index_in_x(layout, c);
    const std::string name = speed     ? by_name ? speed_name_by_body(scene, c) : speed_name(c)
                                 : by_name ? coordinate_name_by_body(scene, c)
                                       : coordinate_name(c);
    list.add(name, {.kind = speed ? Kind::speed : Kind::coordinate, .index = index}, absence(scene, c, index));
  };
  for (const bool by_name : {true, false}) {
    for (const Component& c : components(scene)) add(c, false, by_name);
    for (const Component& c : speed_components(scene)) add(c, true, by_name);
  }
}

std::vector<ExpressionName> named(const std::vector<Named>& list, Kind kind, const std::string& refusal = "") {
  std::vector<ExpressionName> out;
  for (std::size_t i = 0; i < list.size(); ++i)
    out.push_back({list[i].name, {.kind = kind, .index = static_cast<int>(i)}, refusal});
  return out;
}

void append(std::vector<ExpressionName>& list, const std::vector<ExpressionName>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

void append_refused(std::vector<ExpressionName>& list, std::vector<ExpressionName> more, const std::string& refusal) {
  for (ExpressionName& name : more) name.refusal = refusal;
  append(list, more);
}

std::vector<ExpressionName> component_names(const Scene& scene) {
  List list;
  add_components(scene, list);
  return list.names();
}

const std::string motion_rule =
    "a prescribed motion is of time and parameters alone, so that its speed and acceleration follow from it";
const std::string constant_rule = "this number is a constant";

}  // namespace

std::vector<ExpressionName> names_for_loads(const Scene& scene) {
  std::vector<ExpressionName> out = {{"t", {.kind = Kind::time}}};
  append(out, named(scene.parameters, Kind::parameter));
  append(out, named(scene.inputs, Kind::input));
  append(out, component_names(scene));
  return out;
}

std::vector<ExpressionName> names_for_motions(const Scene& scene) {
  std::vector<ExpressionName> out = {{"t", {.kind = Kind::time}}};
  append(out, named(scene.parameters, Kind::parameter));
  append(out, named(scene.inputs, Kind::input, "an input, whose rate is unknown: " + motion_rule));
  append_refused(out, component_names(scene), "a coordinate or speed: " + motion_rule);
  return out;
}

std::vector<ExpressionName> names_for_constants(const Scene& scene) {
  std::vector<ExpressionName> out = {{"t", {.kind = Kind::time}, "the time: " + constant_rule}};
  append(out, named(scene.parameters, Kind::parameter, "a parameter: " + constant_rule));
  append(out, named(scene.inputs, Kind::input, "an input: " + constant_rule));
  return out;
}

std::map<std::string, std::string> taken_names(const Scene& scene) {
  std::map<std::string, std::string> out = {{"t", "the time"}, {"pi", "a constant"}, {"free", "a word of body.motion"}};
  for (const std::string& name : call_names()) out[name] = "a function of expressions";
  for (const ExpressionName& name : component_names(scene))
    out[name.name] = name.node.kind == Kind::speed ? "a speed of this scene" : "a coordinate of this scene";
  return out;
}

}  // namespace kanec::scene
