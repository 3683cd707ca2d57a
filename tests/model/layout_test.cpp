// Oracle: scene::Layout and its names, and the shapes that the functions are documented with.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/read/read.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/model/result_layout.hpp"
#include "runtime/model/state_file.hpp"
#include "runtime/model/state_layout.hpp"
#include "runtime/run/conservation.hpp"

namespace kanec::cli {
namespace {

using scene::Coordinate;
using testing::ElementsAre;
using Names = std::vector<std::string>;

// A free body; a hinge; a gimbal whose second angle is locked, with a slide; a held ball; a weld; a planar joint whose
// slides are prescribed.
scene::Scene any_joints() {
  scene::Scene scene = scene::from_connection({0, 1, 2, 3, 1, 5});
  const auto joint = [&](int k) -> scene::Joint& { return scene.bodies[static_cast<std::size_t>(k - 1)].joint; };
  const auto shape = [&](int k, std::size_t turns, std::size_t slides) {
    joint(k).ball = false;
    joint(k).turns.resize(turns);
    joint(k).slides.resize(slides);
  };
  shape(2, 1, 0);
  shape(3, 3, 1);
  joint(3).turns[1].motion = Coordinate::Motion::locked;
  joint(4).held = true;
  joint(4).slides.clear();
  shape(5, 0, 0);
  shape(6, 1, 2);
  for (Coordinate& slide : joint(6).slides) slide.motion = Coordinate::Motion::prescribed;
  return scene;
}

Names block_names(const Layout& layout) {
  Names names;
  for (const Block& block : layout.blocks) names.push_back(block.name);
  return names;
}

// Names of the single numbers of blocks, as scene::Layout names them.
Names entries(const Layout& layout) {
  Names names;
  for (const Block& block : layout.blocks)
    for (std::size_t i = 0; i < block.size(); ++i)
      names.push_back(block.shape.empty() ? block.name : block.name + "_" + std::to_string(i + 1));
  return names;
}

TEST(StateLayout, follows_the_layout_of_the_scene) {
  const scene::Scene scene = any_joints();
  EXPECT_EQ(entries(coordinates_layout(scene)), coordinate_names(scene));
  EXPECT_EQ(entries(speeds_layout(scene)), speed_names(scene));
  EXPECT_EQ(entries(speed_rates_layout(scene)), speed_rate_names(scene));
  EXPECT_EQ(entries(along_speeds_layout(scene, "f")), speed_names(scene));
  EXPECT_EQ(coordinate_rates_layout(scene).size(), static_cast<std::size_t>(n_coordinates(scene)));
}

TEST(StateLayout, has_a_block_a_body_where_all_of_it_is_in_the_state) {
  const scene::Scene scene = any_joints();
  EXPECT_THAT(block_names(coordinates_layout(scene)),
              ElementsAre("eps_1", "theta_2", "theta_3_1", "theta_3_3", "theta_6", "s_1", "s_3"));
  EXPECT_THAT(block_names(driving_loads_layout(scene)), ElementsAre("theta_3_2", "phi_4", "s_6"));
  EXPECT_EQ(driving_loads_layout(scene).size(), 6u);
}

TEST(StateLayout, names_the_tangent) {
  const scene::Scene scene = any_joints();
  EXPECT_THAT(tangent_names(scene), ElementsAre("phi_1_1", "phi_1_2", "phi_1_3", "theta_2", "theta_3_1", "theta_3_3",
                                                "theta_6", "s_1_1", "s_1_2", "s_1_3", "s_3"));
}

TEST(StateLayout, is_told_in_short) {
  EXPECT_EQ(summary_of(coordinates_layout(scene::from_connection({0, 1, 1}))),
            "eps_K (4 numbers), K from 1 to 3; s_K (3 numbers), K from 1 to 3");
  EXPECT_EQ(summary_of(coordinates_layout(any_joints())),
            "eps_1 (4 numbers); theta_K (1 number), K = 2, 3_1, 3_3, 6; s_1 (3 numbers); s_3 (1 number)");
  scene::Scene still = scene::from_connection({0});
  still.bodies[0].joint.ball = false;
  still.bodies[0].joint.slides.clear();
  EXPECT_EQ(summary_of(coordinates_layout(still)), "nothing");
}

TEST(ResultLayout, has_as_many_names_as_the_function_has_results) {
  for (const scene::Scene& scene :
       {scene::from_connection({0, 1}), scene::read(KANEC_SOURCE_DIR "/models/six_body/scene.toml")}) {
    const Functions functions(scene);
    for (const Available& function : functions.all()) {
      const std::vector<Layout> layouts = result_layouts(scene, function.name);
      ASSERT_EQ(layouts.size(), 1u);
      EXPECT_EQ(layouts[0].size(), static_cast<std::size_t>(function.n_out)) << function.name;
    }
  }
}

TEST(ResultLayout, of_derivatives_names_rows_and_columns) {
  const scene::Scene scene = any_joints();
  const auto layout = [&](const std::string& name) { return result_layouts(scene, name).at(0); };
  EXPECT_EQ(layout("residual_x").rows, speed_names(scene));
  EXPECT_EQ(layout("residual_x").columns, coordinate_names(scene));
  EXPECT_EQ(layout("accelerations_xi").rows, speed_rate_names(scene));
  EXPECT_EQ(layout("accelerations_xi").columns, tangent_names(scene));
  EXPECT_EQ(layout("state_matrix").size(), 22u * 22u);
  EXPECT_EQ(layout("state_matrix").rows.back(), "sdot_3");
  EXPECT_EQ(layout("input_matrix").columns.size(), scene.inputs.size());
}

TEST(ResultLayout, of_points_and_loads_has_their_names) {
  scene::Scene scene = any_joints();
  scene.points.push_back({"salt_and_pepper", 2, {}});
  EXPECT_EQ(result_layouts(scene, "salt_and_pepper_position").at(0).blocks.at(0).unit, "m");
  EXPECT_EQ(result_layouts(scene, "salt_and_pepper_jacobian").at(0).size(), 33u);
  scene::Load load;
  load.name = "spring";
  scene.loads.push_back(load);
  for (scene::Body& body : scene.bodies) body.force = body.moment = {};
  scene.bodies[1].force[0] = scene::Number::constant(1.0);
  EXPECT_THAT(block_names(result_layouts(scene, "load_powers").at(0)), ElementsAre("body body_2", "spring"));
}

TEST(ResultLayout, of_combined_functions_is_one_after_another) {
  const scene::Scene scene = any_joints();
  const std::vector<Layout> layouts = result_layouts(scene, "energy+reactions");
  ASSERT_EQ(layouts.size(), 2u);
  EXPECT_EQ(layouts[0].name, "energy");
  EXPECT_EQ(layouts[1].size(), 36u);
}

TEST(Requests, of_several_parts_are_one_function) {
  EXPECT_THAT(parts_of("energy+momentum+poses"), ElementsAre("energy", "momentum", "poses"));
  EXPECT_EQ(emitted_name("energy+momentum"), "energy_and_momentum");
  EXPECT_THAT(parts_of_emitted("energy_and_momentum", {"poses", "energy+momentum"}), ElementsAre("energy", "momentum"));
  EXPECT_THAT(parts_of_emitted("salt_and_pepper_position", {"energy+momentum"}),
              ElementsAre("salt_and_pepper_position"));
}

TEST(StateFile, reads_what_it_writes_for_any_joints) {
  scene::Scene scene = any_joints();
  scene.expressions.push_back({"t", {{scene::ExpressionNode::Kind::time}}});
  State state = initial_state(scene);
  state.t = 0.25;
  for (std::size_t i = 4; i < state.x.size(); ++i) state.x[i] = 0.125 * static_cast<double>(i);
  for (std::size_t i = 0; i < state.y.size(); ++i) state.y[i] = state.ydot[i] = 0.5 * static_cast<double>(i);
  const Json json = state_json(scene, state);
  EXPECT_TRUE(json.at("x").at("theta_2").is_number());
  EXPECT_EQ(json.at("x").at("theta_3_3"), state.x[6]);
  const State read = read_state(json_text(json), "file", scene, {true, true}).state;
  EXPECT_EQ(read.t, state.t);
  EXPECT_EQ(read.x, state.x);
  EXPECT_EQ(read.y, state.y);
  EXPECT_EQ(read.ydot, state.ydot);
}

TEST(Conservation, tells_what_acts_from_outside) {
  scene::Scene free = scene::from_connection({0, 1});
  free.gravity = {};
  for (scene::Body& body : free.bodies) body.force = body.moment = {};
  EXPECT_TRUE(is_isolated(free));
  scene::Load load;
  load.point.body = 2;
  for (const auto kind : {scene::Load::Kind::force, scene::Load::Kind::spring}) {
    scene::Scene loaded = free;
    load.kind = kind;
    loaded.loads = {load};
    EXPECT_FALSE(is_isolated(loaded));
    loaded.loads[0].reaction = loaded.loads[0].other.body = 1;
    EXPECT_TRUE(is_isolated(loaded));
  }
  load.kind = scene::Load::Kind::joint;
  free.loads = {load};
  EXPECT_TRUE(is_isolated(free));  // between bodies 1 and 2
  free.loads[0].point.body = 1;
  EXPECT_FALSE(is_isolated(free));
  free.loads.clear();
  free.bodies[0].joint.slides.pop_back();
  EXPECT_FALSE(is_isolated(free));
}

TEST(Conservation, knows_that_prescribed_coordinates_do_work) {
  EXPECT_TRUE(has_drives(any_joints()));
  EXPECT_FALSE(has_drives(scene::from_connection({0})));
}

}  // namespace
}  // namespace kanec::cli
