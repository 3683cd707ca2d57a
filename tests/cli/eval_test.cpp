// Oracles: the three paths against each other; r = A ydot - f; symmetry of A.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

class Eval : public Program {
 protected:
  json template_of(const std::string& scene, const std::string& function) const {
    return json_of({"eval", model(scene), function, "--template"});
  }
  json result(const std::string& scene, const std::string& function, const std::string& path, const json& state) const {
    return json_of({"eval", model(scene), function, "--path", path, "--json", "--input", "-"}, state.dump())
        .at("result");
  }
};

// Largest difference of two results of the same shape, relative to their largest number.
double distance(const json& a, const json& b) {
  const json flat_a = a.flatten(), flat_b = b.flatten();
  double difference = 0.0, largest = 0.0;
  for (const auto& [name, value] : flat_a.items()) {
    if (!value.is_number()) continue;
    difference = std::max(difference, std::fabs(value.get<double>() - flat_b.at(name).get<double>()));
    largest = std::max(largest, std::fabs(value.get<double>()));
  }
  return difference / largest;
}

TEST_F(Eval, three_paths_agree) {
  const json state = template_of("six_body", "accelerations");
  const json emitted = result("six_body", "accelerations", "emitted", state);
  // some hundred roundings behind each component
  EXPECT_LT(distance(emitted, result("six_body", "accelerations", "generic", state)), 1e-14);
  EXPECT_LT(distance(emitted, result("six_body", "accelerations", "precise", state)), 1e-14);
}

TEST_F(Eval, every_function_tells_its_result_by_name) {
  const std::vector<std::tuple<std::string, std::string, std::vector<std::string>>> expected = {
      {"kinematics", "xdot", {"epsdot_handle", "sdot_handle"}},
      {"forcing", "f", {"omega_handle", "sdot_handle"}},
      {"residual", "r", {"omega_handle", "sdot_handle"}},
      {"accelerations", "ydot", {"omegadot_handle", "sddot_handle"}},
      {"energy", "energy", {"kinetic", "potential"}},
      {"momentum", "momentum", {"linear", "angular"}},
      {"poses", "poses", {"R_handle", "p_handle"}}};
  for (const auto& [function, name, fields] : expected) {
    SCOPED_TRACE(function);
    const json state = template_of("free_body", function);
    const json precise = result("free_body", function, "precise", state).at(name);
    EXPECT_EQ(precise.size(), fields.size());
    for (const std::string& field : fields) EXPECT_TRUE(precise.contains(field)) << field;
    // a handful of roundings
    EXPECT_LE(distance(precise, result("free_body", function, "generic", state).at(name)), 1e-15);
  }
}

TEST_F(Eval, matrices_come_with_the_names_of_their_rows_and_columns) {
  const json state = template_of("six_body", "mass_matrix");
  const json A = result("six_body", "mass_matrix", "precise", state).at("mass_matrix");
  ASSERT_EQ(A.at("rows").size(), 36u);
  EXPECT_EQ(A.at("rows"), A.at("columns"));
  EXPECT_EQ(A.at("columns").at(18), "sdot_hub_1");
  for (std::size_t i = 0; i < 36; ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_EQ(A.at("A").at(i).at(j), A.at("A").at(j).at(i));
  const json v_y = result("six_body", "partial_velocities", "precise", state).at("v_y");
  EXPECT_EQ(v_y.at("columns"), A.at("columns"));
  // the hub's own translation
  EXPECT_EQ(v_y.at("v_hub").at(0).at(18), 1.0);
  EXPECT_EQ(v_y.at("v_tool").at(0).size(), 36u);
}

// d/dv of -|v| v is -2 |v|, and of its components -|v| - v v'/|v|: zero at rest, by every path.
TEST_F(Eval, rates_of_lengths_that_are_zero_are_zero) {
  const std::string head = "name = 'drag'\nconnection = [0]\n[[body]]\nname = 'm'\nmass = 2\ninertia = [1, 1, 1]\n";
  const std::string slide = head + "joint = 'prismatic'\naxis = 'x'\neffort = ";
  const std::string length = "-sqrt(sdot_m_1^2 + sdot_m_2^2 + sdot_m_3^2)";
  const std::string three = head + "joint = 'cartesian'\nforce = ['" + length + "*sdot_m_1', '" + length +
                            "*sdot_m_2', '" + length + "*sdot_m_3']\n";
  for (const std::string& scene : {slide + "'-sqrt(sdot_m^2)*sdot_m'", slide + "'-(sdot_m^2)^0.5*sdot_m'", three}) {
    write("drag.toml", scene);
    for (const char* path : {"emitted", "generic", "precise"}) {
      const json state = json_of({"eval", "drag.toml", "accelerations_y", "--template"});
      const json result =
          json_of({"eval", "drag.toml", "accelerations_y", "--input", "-", "--path", path, "--json"}, state.dump());
      for (const json& row : result.at("result").at("accelerations_y").at("ydot_y"))
        for (const json& entry : row) EXPECT_EQ(entry, 0.0) << path << "\n" << scene;
    }
  }
}

TEST_F(Eval, residual_of_the_accelerations_is_zero) {
  json state = template_of("six_body", "residual");
  const json force = result("six_body", "residual", "precise", state).at("r");  // ydot is zero there: r = -f
  state["ydot"] = result("six_body", "accelerations", "precise", state).at("ydot");
  const json r = result("six_body", "residual", "precise", state).at("r");
  // ydot is rounded to double, which A hands on; its entries are below a hundred
  const json flat = r.flatten();
  for (const auto& [name, value] : flat.items()) EXPECT_LT(std::fabs(value.get<double>()), 1e-12) << name;
  EXPECT_GT(std::fabs(force.at("sdot_hub").at(2).get<double>()), 1.0);
}

TEST_F(Eval, text_has_17_digits_and_the_state_that_was_used) {
  const std::string state = template_of("six_body", "energy").dump();
  const Answer answer = kanec({"eval", model("six_body"), "energy", "--input", "-", "--path", "generic"}, state);
  EXPECT_EQ(answer.status, 0);
  for (const char* text : {"energy of six_body, generic", "eps_hub ", "omega_tool [rad/s]", "m_payload = 1.2",
                           "thrust = 2.0", "result: energy", "kinetic [J]"})
    EXPECT_THAT(answer.out, HasSubstr(text));
  EXPECT_THAT(answer.out, testing::ContainsRegex("potential \\[J\\] +[0-9]\\.[0-9]{16}e[+-][0-9]+\n"));
}

TEST_F(Eval, connection_array_takes_the_place_of_the_scene) {
  const Answer answer = kanec({"eval", "--connection", "0,1", "power", "--template"});
  EXPECT_EQ(answer.status, 0);
  EXPECT_TRUE(json::parse(answer.out).at("inputs").contains("F_2_3"));
}

TEST_F(Eval, settings_go_before_the_file_and_the_file_before_the_scene) {
  json state = template_of("six_body", "power");
  state.at("inputs").at("thrust") = 5.0;
  state.at("parameters").erase("m_payload");
  const auto used = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"eval", model("six_body"), "power",   "--input",
                                          "-",    "--path",          "generic", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return json_of(arguments, state.dump()).at("state");
  };
  EXPECT_EQ(used({}).at("inputs").at("thrust"), 5.0);
  EXPECT_EQ(used({}).at("parameters").at("m_payload"), 1.2);
  EXPECT_EQ(used({"--set", "thrust=2"}).at("inputs").at("thrust"), 2.0);
}

TEST_F(Eval, euler_parameters_off_unit_norm_are_normalised) {
  json state = template_of("free_body", "poses");
  state.at("x").at("eps_handle") = {0, 0, 3, 4};
  const std::vector<std::string> arguments = {"eval", model("free_body"), "poses",   "--input",
                                              "-",    "--path",           "generic", "--json"};
  const Answer answer = kanec(arguments, state.dump());
  EXPECT_THAT(answer.err, HasSubstr("kanec: note: standard input: x.eps_handle: normalised; its norm was 5"));
  EXPECT_EQ(json::parse(answer.out).at("state").at("x").at("eps_handle"), json({0.0, 0.0, 0.6, 0.8}));
  const double off = 0.6 + 1e-16;  // a rounding: taken as it stands
  state.at("x").at("eps_handle") = {0, 0, off, 0.8};
  const Answer near = kanec(arguments, state.dump());
  EXPECT_THAT(near.err, IsEmpty());
  EXPECT_EQ(json::parse(near.out).at("state").at("x").at("eps_handle").at(2), off);
}

TEST_F(Eval, result_that_is_not_finite_is_told) {
  json state = template_of("free_body", "energy");
  state.at("y").at("omega_handle") = {1e200, 0, 0};
  const Answer answer = kanec({"eval", model("free_body"), "energy", "--input", "-", "--json"}, state.dump());
  EXPECT_EQ(answer.status, 0);
  EXPECT_THAT(answer.err, HasSubstr("not finite"));
  EXPECT_TRUE(json::parse(answer.out).at("result").at("energy").at("kinetic").is_null());
}

struct BadInput {
  const char* patch;  // JSON patch of the template of free_body's residual
  const char* message;
};

class EvalInput : public Eval, public testing::WithParamInterface<BadInput> {};

TEST_P(EvalInput, is_refused_by_the_name_of_its_field) {
  const json state = template_of("free_body", "residual").patch(json::parse(GetParam().patch));
  write("state.json", state.dump());
  refuses({"eval", model("free_body"), "residual", "--input", "state.json"}, GetParam().message, {"state.json"});
}

INSTANTIATE_TEST_SUITE_P(
    Patches, EvalInput,
    testing::Values(
        BadInput{
            R"([{"op": "remove", "path": "/x"}])",
            "state.json: found no field \"x\"; allowed: an object with eps_handle (4 numbers); s_handle (3 numbers)"},
        BadInput{R"([{"op": "remove", "path": "/ydot"}])", "state.json: found no field \"ydot\""},
        BadInput{R"([{"op": "remove", "path": "/y/sdot_handle"}])", "state.json: y: found no field \"sdot_handle\""},
        BadInput{R"([{"op": "add", "path": "/z", "value": 1}])",
                 "found an unknown field \"z\"; allowed: an object with t, x, y"},
        BadInput{R"([{"op": "add", "path": "/input", "value": {}}])", "(did you mean inputs?)"},
        BadInput{R"([{"op": "add", "path": "/y/omega1", "value": [1, 2, 3]}])", "y: found an unknown field \"omega1\""},
        BadInput{R"([{"op": "add", "path": "/x/eps_2", "value": [0, 0, 0, 1]}])", "(did you mean eps_1?)"},
        BadInput{R"([{"op": "add", "path": "/parameters", "value": {"m": 1}}])", "the scene has no parameters"},
        BadInput{R"([{"op": "replace", "path": "/x/s_handle", "value": [1, 2]}])",
                 "x.s_handle: found a list of 2; allowed: a list of 3 finite numbers"},
        BadInput{R"([{"op": "replace", "path": "/x/s_handle", "value": 7}])", "x.s_handle: found 7"},
        BadInput{R"([{"op": "replace", "path": "/x/s_handle/1", "value": "a"}])",
                 "x.s_handle[2]: found \"a\"; allowed: a finite number"},
        BadInput{R"([{"op": "replace", "path": "/x/s_handle/1", "value": null}])", "x.s_handle[2]: found null"},
        BadInput{R"([{"op": "replace", "path": "/x/s_handle/1", "value": true}])", "x.s_handle[2]: found true"},
        BadInput{R"([{"op": "replace", "path": "/y", "value": [1]}])", "y: found a list of 1; allowed: omega_handle"},
        BadInput{R"([{"op": "replace", "path": "/x/eps_handle", "value": [0, 0, 0, 0]}])",
                 "x.eps_handle: found norm 0"}));

TEST_F(Eval, what_is_no_json_is_refused) {
  const auto refused = [this](const std::string& text, const std::string& message) {
    refuses({"eval", model("free_body"), "energy", "--input", "-"}, message, {}, text);
  };
  refused("", "standard input: found parse error");
  refused("{\"x\": ", "line 1");
  refused("[1]", "standard input: found a list of 1; allowed: an object");
  refused("{\"x\": {}, \"x\": {}}", "the field \"x\" twice");
  refused("{\"x\": {\"s_handle\": [1e999, 0, 0]}}", "number overflow");
}

TEST_F(Eval, input_and_function_have_to_be_there) {
  refuses({"eval", model("free_body"), "energy"}, "--input is not given");
  refuses({"eval", model("free_body"), "energy", "--input", "nowhere.json"}, "nowhere.json: No such file or directory");
  refuses({"eval", model("free_body"), "energi", "--template"}, "(did you mean energy?)");
  refuses({"eval", model("free_body"), "--template"}, "function: ");
  refuses({"eval", model("free_body"), "energy", "--path", "exact"}, "--path");
}

}  // namespace
}  // namespace kanec::cli::test
