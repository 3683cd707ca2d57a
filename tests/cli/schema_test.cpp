// What --json prints, against the schemas of docs/schema. Oracle: the schemas, by the part of JSON Schema that they
// use.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <regex>

#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

json schema(const std::string& name) { return json::parse(read_file(KANEC_SOURCE_DIR "/docs/schema/" + name)); }

bool is_of_type(const json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  return type == "null" && value.is_null();
}

// The first place where the value is not as the schema says; empty where there is none.
std::string fault(const json& value, const json& rule, const std::string& at) {
  static const std::vector<std::string> known = {
      "$schema",    "$id",      "title",   "description", "type",
      "properties", "required", "items",   "enum",        "additionalProperties",
      "$ref",       "anyOf",    "pattern", "minimum",     "minItems",
      "maxItems"};
  for (const auto& [key, ignored] : rule.items())
    if (std::find(known.begin(), known.end(), key) == known.end()) return at + ": the schema says " + key;
  if (rule.contains("$ref")) return fault(value, schema(rule["$ref"]), at);
  if (rule.contains("anyOf")) {
    for (const json& one : rule["anyOf"])
      if (fault(value, one, at).empty()) return "";
    return at + ": none of anyOf";
  }
  if (rule.contains("enum") && std::find(rule["enum"].begin(), rule["enum"].end(), value) == rule["enum"].end())
    return at + ": enum";
  if (rule.contains("type")) {
    const json types = rule["type"].is_array() ? rule["type"] : json::array({rule["type"]});
    if (std::none_of(types.begin(), types.end(), [&](const json& type) { return is_of_type(value, type); }))
      return at + ": type";
  }
  if (rule.contains("pattern") &&
      !std::regex_search(value.get<std::string>(), std::regex(rule["pattern"].get<std::string>())))
    return at + ": pattern";
  if (rule.contains("minimum") && value < rule["minimum"]) return at + ": minimum";
  if (rule.contains("minItems") && value.size() < rule["minItems"]) return at + ": minItems";
  if (rule.contains("maxItems") && value.size() > rule["maxItems"]) return at + ": maxItems";
  for (const json& key : rule.value("required", json::array()))
    if (!value.contains(key)) return at + ": no " + key.get<std::string>();
  if (value.is_array() && rule.contains("items"))
    for (std::size_t i = 0; i < value.size(); ++i)
      if (const std::string found = fault(value[i], rule["items"], at + "[" + std::to_string(i) + "]"); !found.empty())
        return found;
  if (!value.is_object()) return "";
  const json properties = rule.value("properties", json::object());
  for (const auto& [key, part] : value.items()) {
    const json inner = properties.contains(key) ? properties[key] : rule.value("additionalProperties", json(true));
    if (inner == json(false)) return at + "." + key + ": not in the schema";
    if (!inner.is_object()) continue;
    if (const std::string found = fault(part, inner, at + "." + key); !found.empty()) return found;
  }
  return "";
}

class Schema : public Program {
 protected:
  void holds(const std::string& name, const std::vector<std::string>& arguments, const std::string& input = {}) const {
    SCOPED_TRACE(testing::PrintToString(arguments));
    const Answer answer = kanec(arguments, input);
    ASSERT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(fault(json::parse(answer.out), schema(name), name), "");
  }
};

TEST_F(Schema, of_every_command_holds_its_output) {
  for (const char* scene : {"cart_pole", "every_joint", "free_body"}) {
    holds("functions.json", {"functions", model(scene), "--json"});
    holds("derive.json", {"derive", model(scene), "--json"});
    holds("generate.json", {"generate", model(scene), "--functions", "accelerations", "-o", ".", "--json"});
    holds("ledger.json", {"ledger", model(scene), "--json"});
    holds("simulate.json", {"simulate", model(scene), "--duration", "0.05", "--json"});
    holds("check.json", {"check", model(scene), "--functions", "accelerations", "--states", "2", "--json"});
  }
}

TEST_F(Schema, of_states_and_results_holds_them) {
  for (const char* scene : {"cart_pole", "every_joint", "free_body", "six_body"}) {
    holds("state.json", {"eval", model(scene), "residual", "--template"});
    const std::string state = kanec({"eval", model(scene), "residual", "--template"}).out;
    holds("eval.json", {"eval", model(scene), "residual", "--input", "-", "--json"}, state);
    holds("eval.json", {"eval", model(scene), "accelerations_x", "--input", "-", "--json"}, state);
  }
}

TEST_F(Schema, of_a_run_with_events_holds_it) {
  holds("simulate.json", {"simulate", model("slider_crank"), "--duration", "0.1", "--json"});
}

// So that a schema that allows everything is found out.
TEST_F(Schema, refuses_what_it_does_not_say) {
  const json rule = schema("state.json");
  EXPECT_EQ(fault(json::parse(R"({"x": {"theta_1": 1}})"), rule, ""), "");
  EXPECT_EQ(fault(json::parse(R"({"z": {}})"), rule, ""), ".z: not in the schema");
  EXPECT_EQ(fault(json::parse(R"({"t": "0"})"), rule, ""), ".t: type");
  EXPECT_EQ(fault(json::parse(R"({"x": {"theta_1": ["a"]}})"), rule, ""), ".x.theta_1: none of anyOf");
  EXPECT_NE(fault(json::parse(R"({"model": "a"})"), schema("check.json"), ""), "");
}

}  // namespace
}  // namespace kanec::cli::test
