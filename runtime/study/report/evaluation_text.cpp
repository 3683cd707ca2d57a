// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/evaluation_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "runtime/base/fit.hpp"
#include "runtime/model/dump.hpp"
#include "runtime/text/table.hpp"

namespace kanec {
namespace {

// Three digits are more than medians of some tens of states have.
std::string ulps_text(double ulps) {
  if (!std::isfinite(ulps)) return "inf";
  return ulps < 100 ? fmt::format("{:.1f}", ulps) : fmt::format("{:.2g}", ulps);
}

std::string name_of(const WayErrors& way) {
  return way.description.empty() ? way.name : way.name + ": " + way.description;
}

const TextRow headings = {"function", "way",           "operations", "double: median", "largest",     "hard",
                          "expected", "float: median", "largest",    "hard",           "from generic"};

TextRow row_of(const std::string& function, const WayErrors& way) {
  return {function,
          name_of(way),
          std::to_string(way.cost.operations()),
          ulps_text(way.in_double.median),
          ulps_text(way.in_double.largest),
          ulps_text(way.in_double.hard),
          ulps_text(way.expected),
          ulps_text(way.in_float.median),
          ulps_text(way.in_float.largest),
          ulps_text(way.in_float.hard),
          ulps_text(way.from_generic.largest)};
}

TextRow generic_row(const FunctionErrors& function) {
  return {function.function,
          "generic path",
          "",
          ulps_text(function.generic.median),
          ulps_text(function.generic.largest),
          ulps_text(function.generic.hard),
          "",
          "",
          "",
          "",
          ""};
}

std::vector<TextRow> rows_of(const FunctionErrors& function) {
  std::vector<TextRow> rows;
  for (const WayErrors& way : function.ways) rows.push_back(row_of(function.function, way));
  rows.push_back(generic_row(function));
  return rows;
}

const TextRow variant_headings = {"function", "compiled", "ns", "ulps: median", "largest", "hard", "of"};

TextRow variant_row(const VariantErrors& variant) {
  return {variant.function,
          variant.name,
          fmt::format("{:.4g}", variant.nanoseconds),
          ulps_text(variant.ulps.median),
          ulps_text(variant.ulps.largest),
          ulps_text(variant.ulps.hard),
          variant.is_float ? "float" : "double"};
}

std::vector<TextRow> variant_rows(const SceneErrors& scene) {
  std::vector<TextRow> rows;
  for (const VariantErrors& variant : scene.variants) rows.push_back(variant_row(variant));
  return rows;
}

std::string variants_text(const SceneErrors& scene) {
  if (scene.variants.empty()) return "";
  std::vector<TextRow> rows = variant_rows(scene);
  rows.insert(rows.begin(), variant_headings);
  return "\ncompiled: time of one evaluation, errors in ulps from the generic path in 50 digits\n\n" +
         text_table(rows, "llr");
}

std::string condition_of(const SceneErrors& scene) {
  return fmt::format("condition of A {:.2g}, at worst {:.2g}", scene.condition, scene.worst_condition);
}

std::string markdown_table(const FunctionErrors& function) {
  const auto without_function = [](const TextRow& row) { return TextRow(row.begin() + 1, row.end()); };
  std::string text = markdown_row(without_function(headings)) + "|---|";
  for (std::size_t i = 2; i < headings.size(); ++i) text += "--:|";
  text += '\n';
  for (const TextRow& row : rows_of(function)) text += markdown_row(without_function(row));
  return text;
}

std::string variants_markdown(const SceneErrors& scene) {
  if (scene.variants.empty()) return "";
  std::string text = "\nAs compiled, time of one evaluation and errors from the generic path in 50 digits:\n\n" +
                     markdown_row(variant_headings) + "|---|---|--:|--:|--:|--:|---|\n";
  for (const TextRow& row : variant_rows(scene)) text += markdown_row(row);
  return text;
}

// Accelerations of all scenes as they are kept, beside the generic path.
std::string overview(const std::vector<SceneErrors>& scenes) {
  std::string text =
      "\n## Accelerations by scene\n\n| scene | condition of A | operations | double: median | largest | float: median "
      "| generic path: median | largest | way |\n|---|--:|--:|--:|--:|--:|--:|--:|---|\n";
  for (const SceneErrors& scene : scenes)
    for (const FunctionErrors& function : scene.functions) {
      const WayErrors& kept = function.ways.front();
      if (function.function != "accelerations") continue;
      text += markdown_row({scene.model, fmt::format("{:.2g}", scene.condition), std::to_string(kept.cost.operations()),
                            ulps_text(kept.in_double.median), ulps_text(kept.in_double.largest),
                            ulps_text(kept.in_float.median), ulps_text(function.generic.median),
                            ulps_text(function.generic.largest), kept.description});
    }
  return text;
}

Json errors_json(const UlpErrors& errors) {
  return {{"median_ulps", errors.median}, {"largest_ulps", errors.largest}, {"hard_ulps", errors.hard}};
}

Json way_json(const WayErrors& way) {
  Json json = {{"name", way.name}};
  if (!way.description.empty()) json["description"] = way.description;
  json.update(ledger_json(way.cost));
  json["double"] = errors_json(way.in_double);
  json["float"] = errors_json(way.in_float);
  json["from_generic"] = errors_json(way.from_generic);
  json["expected_ulps"] = way.expected;
  return json;
}

Json variants_json(const SceneErrors& scene) {
  Json list = Json::array();
  for (const VariantErrors& variant : scene.variants)
    list.push_back({{"function", variant.function},
                    {"variant", variant.name},
                    {"scalar", variant.is_float ? "float" : "double"},
                    {"nanoseconds", variant.nanoseconds},
                    {"from_generic", errors_json(variant.ulps)}});
  return list;
}

constexpr auto page_head =
    R"(Each table is one function: first the way in which the generator computes it, then ways that differ from that in one
thing, operations counted and errors beside them: what regrouping of masses, moved origins, axes, the algorithm and the
passes cost in digits. How to read the columns:

- *double*, *float*: the same program in that arithmetic against 50 digits, in ulps (2^-52, 2^-23 of the binade) of the
  result's largest component, or of the median of that over the states where it cancels to less. Median and largest over
  {} random states (`kanec check` has the same ones), and the largest over the hard ones: speeds a thousand times as high,
  all angles zero, all multiples of a right angle, angles of ten thousand radians.
- *expected*: the median that independent errors of all operations would make, to first order; by this the generator
  chooses, as it is the same on all machines.
- *from generic*: the largest difference in double from the generic path in 50 digits, which knows nothing of the
  generator, so that no mistake in algebra hides. The last line is that path's own error in double.
- The condition of A, rows and columns scaled to ones on its diagonal, says what the problem itself does: so many times
  may it enlarge a rounding of A's entries. A way that never forms A can do better.

Sines and cosines are those of the machine's library, so that the last digit shown may differ elsewhere.
)";

}  // namespace

std::string evaluation_text(const std::vector<SceneErrors>& scenes) {
  std::string text;
  for (const SceneErrors& scene : scenes) {
    if (!scene.failure.empty()) {
      text += fmt::format("{}{}: evaluation failed: {}\n", text.empty() ? "" : "\n", scene.model, scene.failure);
      continue;
    }
    std::vector<TextRow> rows = {headings};
    for (const FunctionErrors& function : scene.functions)
      for (TextRow& row : rows_of(function)) rows.push_back(std::move(row));
    text += fmt::format("{}{}: {}; errors in ulps of the largest component\n\n{}", text.empty() ? "" : "\n",
                        scene.model, condition_of(scene), text_table(rows, "llr")) +
            variants_text(scene);
  }
  return text;
}

Json evaluation_json(const std::vector<SceneErrors>& scenes, const EvaluationOptions& options) {
  Json list = Json::array();
  for (const SceneErrors& scene : scenes) {
    if (!scene.failure.empty()) {
      list.push_back({{"model", scene.model}, {"failure", scene.failure}});
      continue;
    }
    Json functions = Json::array();
    for (const FunctionErrors& function : scene.functions) {
      Json ways = Json::array();
      for (const WayErrors& way : function.ways) ways.push_back(way_json(way));
      functions.push_back(
          {{"name", function.function}, {"generic_double", errors_json(function.generic)}, {"ways", std::move(ways)}});
    }
    list.push_back({{"model", scene.model},
                    {"condition", scene.condition},
                    {"worst_condition", scene.worst_condition},
                    {"functions", std::move(functions)}});
    if (!scene.variants.empty()) list.back()["variants"] = variants_json(scene);
  }
  return {{"states", options.states}, {"seed", options.seed}, {"scenes", std::move(list)}};
}

std::string evaluation_csv(const std::vector<SceneErrors>& scenes) {
  std::string text =
      "model,function,way,operations,condition,double_median,double_largest,double_hard,expected,float_median,"
      "float_largest,float_hard,generic_largest,generic_path_median,generic_path_largest,generic_path_hard\n";
  for (const SceneErrors& scene : scenes)
    for (const FunctionErrors& f : scene.functions)
      for (const WayErrors& w : f.ways)
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", scene.model, f.function, w.name,
                            w.cost.operations(), scene.condition, w.in_double.median, w.in_double.largest,
                            w.in_double.hard, w.expected, w.in_float.median, w.in_float.largest, w.in_float.hard,
                            w.from_generic.largest, f.generic.median, f.generic.largest, f.generic.hard);
  return text;
}

std::string variants_csv(const std::vector<SceneErrors>& scenes) {
  std::string text = "model,function,variant,scalar,time[ns],median[ulps],largest[ulps],hard[ulps]\n";
  for (const SceneErrors& scene : scenes)
    for (const VariantErrors& v : scene.variants)
      text += fmt::format("{},{},{},{},{},{},{},{}\n", scene.model, v.function, v.name, v.is_float ? "float" : "double",
                          v.nanoseconds, v.ulps.median, v.ulps.largest, v.ulps.hard);
  return text;
}

std::string evaluation_markdown(const std::vector<SceneErrors>& scenes, const EvaluationOptions& options,
                                const std::string& command) {
  std::string text =
      "# Accuracy of evaluation\n\nWritten by " + fit::code(command) + ".\n\n" + fmt::format(page_head, options.states);
  text += overview(scenes);
  for (const SceneErrors& scene : scenes) {
    if (!scene.failure.empty()) {
      text += fmt::format("\n## {}\n\nFailed: {}\n", scene.model, fit::markdown(scene.failure));
      continue;
    }
    text += fmt::format("\n## {}\n\n{} bodies, {} speeds; {}.\n", scene.model, scene.bodies, scene.speeds,
                        condition_of(scene));
    for (const FunctionErrors& function : scene.functions)
      text += "\n`" + function.function + "`\n\n" + markdown_table(function);
    text += variants_markdown(scene);
  }
  return text;
}

}  // namespace kanec
