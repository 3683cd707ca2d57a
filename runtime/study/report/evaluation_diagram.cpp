// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/evaluation_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/bench/contest_text.hpp"
#include "runtime/study/report/diagram.hpp"
#include "runtime/study/report/pareto.hpp"

namespace kanec {
namespace {

// A median of no error at all has no place on a logarithmic axis.
constexpr double least_ulps = 0.1;

std::string tick(double value) { return fmt::format("{:g}", value); }

double shown_ulps(const VariantErrors& variant) { return std::max(variant.double_ulps(), least_ulps); }

// Among the variants of its function.
bool is_on_front(const VariantErrors& one, const std::vector<VariantErrors>& all) {
  const auto cost = [](const VariantErrors& variant) { return Cost{shown_ulps(variant), variant.nanoseconds}; };
  return std::none_of(all.begin(), all.end(), [&](const VariantErrors& other) {
    return other.function == one.function && beats(cost(other), cost(one));
  });
}

DiagramPoint point_of(const VariantErrors& variant, const std::vector<VariantErrors>& all) {
  const std::string title =
      fmt::format("{}, {}: {:.4g} ns, median {:.3g} ulps of {}", variant.function, variant.name, variant.nanoseconds,
                  variant.ulps.median, variant.is_float ? "float" : "double");
  return {shown_ulps(variant), variant.nanoseconds, title, is_on_front(variant, all), variant.name};
}

// A line a function.
std::vector<DiagramLine> lines_of(const std::vector<VariantErrors>& variants) {
  std::vector<DiagramLine> lines;
  for (const VariantErrors& variant : variants) {
    if (lines.empty() || lines.back().name != variant.function) lines.push_back({variant.function, {}, false});
    lines.back().points.push_back(point_of(variant, variants));
  }
  return lines;
}

}  // namespace

std::string evaluation_svg(const SceneErrors& scene) {
  Diagram diagram;
  diagram.heading = scene.model + ": time against rounding error of evaluation";
  diagram.notes = {
      fmt::format("condition of A {:.2g}, at worst {:.2g}; errors from the generic path in 50 digits", scene.condition,
                  scene.worst_condition),
      fmt::format("medians over random states; below {:g} ulps drawn there; {}", least_ulps, processor_name())};
  diagram.x = {"median error [ulps of double]", tick};
  diagram.y = {"time of one evaluation [ns]", tick};
  diagram.lines = lines_of(scene.variants);
  diagram.has_common_front = false;
  return diagram_svg(diagram);
}

}  // namespace kanec
