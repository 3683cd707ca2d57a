// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/result_layout.hpp"

#include <map>

#include "generator/scene/entry_names.hpp"
#include "runtime/base/error.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/model/state_layout.hpp"

namespace kanec {
namespace {

using scene::Scene;
using Names = std::vector<std::string>;

Names x_names(const Scene& scene) { return in_words(scene, scene::coordinate_names(scene)); }
Names y_names(const Scene& scene) { return in_words(scene, scene::speed_names(scene)); }
Names ydot_names(const Scene& scene) { return in_words(scene, scene::speed_rate_names(scene)); }

Names input_names(const Scene& scene) {
  Names names;
  for (const scene::Named& input : scene.inputs) names.push_back(input.name);
  return names;
}

// "epsdot_1_2"
Names xdot_names(const Scene& scene) {
  Names names = x_names(scene);
  for (std::string& name : names) name.insert(name.find('_'), "dot");
  return names;
}

// ξ, then y.
Names tangent_state_names(const Scene& scene) {
  Names names = tangent_names(scene);
  for (const std::string& speed : y_names(scene)) names.push_back(speed);
  return names;
}

Layout matrix(const std::string& name, const std::string& letter, const Names& rows, const Names& columns,
              const std::string& unit = "") {
  return {name, {{letter, {static_cast<int>(rows.size()), static_cast<int>(columns.size())}, unit}}, rows, columns};
}

Layout mass_matrix(const Scene& scene) {
  return matrix("mass_matrix", "A", y_names(scene), y_names(scene), "kg m^2, kg m, kg");
}

// A matrix of three rows a body, "v_1" or "v_hub".
Layout by_body_and_speed(const Scene& scene, const std::string& name, const std::string& letter) {
  Layout layout{name, {}, {"1", "2", "3"}, y_names(scene)};
  for (const std::string& body : scene::body_words(scene))
    layout.blocks.push_back({letter + "_" + body, {3, n_speeds(scene)}, ""});
  return layout;
}

Layout poses(const Scene& scene) {
  Layout layout{"poses", {}};
  for (const std::string& body : scene::body_words(scene)) {
    layout.blocks.push_back({"R_" + body, {3, 3}, ""});
    layout.blocks.push_back({"p_" + body, {3}, "m"});
  }
  return layout;
}

Layout reactions(const Scene& scene) {
  Layout layout{"reactions", {}};
  for (const std::string& body : scene::body_words(scene)) {
    layout.blocks.push_back({"force_" + body, {3}, "N"});
    layout.blocks.push_back({"moment_" + body, {3}, "N m"});
  }
  return layout;
}

// The force and moment of [[body]] have no name: "body hub" cannot be a load's.
Layout load_powers(const Scene& scene) {
  Layout layout{"load_powers", {}};
  for (const scene::Body& body : scene.bodies)
    if (!is_zero(body.force) || !is_zero(body.moment)) layout.blocks.push_back({"body " + body.name, {}, "W"});
  for (const scene::Load& load : scene.loads) layout.blocks.push_back({load.name, {}, "W"});
  return layout;
}

Layout events(const Scene& scene) {
  Layout layout{"events", {}};
  for (const scene::Event& event : scene.events) layout.blocks.push_back({event.name, {}, ""});
  return layout;
}

using Builder = Layout (*)(const Scene&);

const std::map<std::string, Builder>& builders() {
  static const std::map<std::string, Builder> table = {
      {"kinematics", coordinate_rates_layout},
      {"mass_matrix", mass_matrix},
      {"forcing", [](const Scene& s) { return along_speeds_layout(s, "f"); }},
      {"residual", [](const Scene& s) { return along_speeds_layout(s, "r"); }},
      {"accelerations", speed_rates_layout},
      {"partial_velocities", [](const Scene& s) { return by_body_and_speed(s, "v_y", "v"); }},
      {"partial_velocity_rates", [](const Scene& s) { return by_body_and_speed(s, "v_y_dot", "v"); }},
      {"partial_angular_velocities", [](const Scene& s) { return by_body_and_speed(s, "omega_y", "omega"); }},
      {"partial_angular_velocity_rates", [](const Scene& s) { return by_body_and_speed(s, "omega_y_dot", "omega"); }},
      {"energy",
       [](const Scene&) {
         return Layout{"energy", {{"kinetic", {}, "J"}, {"potential", {}, "J"}}};
       }},
      {"momentum",
       [](const Scene&) {
         return Layout{"momentum", {{"linear", {3}, "kg m/s"}, {"angular", {3}, "kg m^2/s"}}};
       }},
      {"poses", poses},
      {"power",
       [](const Scene&) {
         return Layout{"power", {{"applied", {}, "W"}}};
       }},
      {"load_powers", load_powers},
      {"events", events},
      {"driving_loads", driving_loads_layout},
      {"reactions", reactions},
      {"residual_x", [](const Scene& s) { return matrix("residual_x", "r_x", y_names(s), x_names(s)); }},
      {"residual_y", [](const Scene& s) { return matrix("residual_y", "r_y", y_names(s), y_names(s)); }},
      {"residual_ydot", [](const Scene& s) { return matrix("residual_ydot", "r_ydot", y_names(s), ydot_names(s)); }},
      {"residual_xi", [](const Scene& s) { return matrix("residual_xi", "r_xi", y_names(s), tangent_names(s)); }},
      {"accelerations_x",
       [](const Scene& s) { return matrix("accelerations_x", "ydot_x", ydot_names(s), x_names(s)); }},
      {"accelerations_y",
       [](const Scene& s) { return matrix("accelerations_y", "ydot_y", ydot_names(s), y_names(s)); }},
      {"accelerations_u",
       [](const Scene& s) { return matrix("accelerations_u", "ydot_u", ydot_names(s), input_names(s)); }},
      {"accelerations_xi",
       [](const Scene& s) { return matrix("accelerations_xi", "ydot_xi", ydot_names(s), tangent_names(s)); }},
      {"kinematics_x", [](const Scene& s) { return matrix("kinematics_x", "xdot_x", xdot_names(s), x_names(s)); }},
      {"kinematics_y", [](const Scene& s) { return matrix("kinematics_y", "xdot_y", xdot_names(s), y_names(s)); }},
      {"power_x", [](const Scene& s) { return matrix("power_x", "power_by_x", {"power"}, x_names(s)); }},
      {"power_y", [](const Scene& s) { return matrix("power_y", "power_by_y", {"power"}, y_names(s)); }},
      {"state_matrix",
       [](const Scene& s) { return matrix("state_matrix", "S", tangent_state_names(s), tangent_state_names(s)); }},
      {"input_matrix",
       [](const Scene& s) { return matrix("input_matrix", "B", tangent_state_names(s), input_names(s)); }}};
  return table;
}

Layout of_point(const Scene& scene, const std::string& name, const std::string& what) {
  if (what == "_jacobian") {
    const Names rows = {"1", "2", "3"};
    return matrix(name, "v_y", rows, y_names(scene));
  }
  if (what == "_position") return {name, {{"P", {3}, "m"}}};
  if (what == "_velocity") return {name, {{"v", {3}, "m/s"}}};
  return {name, {{"a", {3}, "m/s^2"}}};
}

Layout layout_of(const Scene& scene, const std::string& name) {
  if (const auto known = builders().find(name); known != builders().end()) return known->second(scene);
  for (const scene::Point& point : scene.points)
    for (const char* what : {"_position", "_velocity", "_acceleration", "_jacobian"})
      if (name == point.name + what) return of_point(scene, name, what);
  throw InternalError("no layout of function " + name);
}

}  // namespace

std::vector<Layout> result_layouts(const Scene& scene, const std::string& request) {
  std::vector<Layout> list;
  for (const std::string& part : parts_of(request)) list.push_back(layout_of(scene, part));
  return list;
}

}  // namespace kanec
