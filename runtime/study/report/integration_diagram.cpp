// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/integration_diagram.hpp"

#include <fmt/format.h>

#include "runtime/bench/contest_text.hpp"
#include "runtime/picture/svg.hpp"
#include "runtime/study/report/choice.hpp"
#include "runtime/study/report/diagram.hpp"
#include "runtime/study/report/integration_text.hpp"

namespace kanec {
namespace {

std::string error_tick(double value) { return fmt::format("{:.0e}", value); }

std::string label_of(const IntegrationRun& run) {
  return fmt::format("{}: {}, worst error {:.1e}, {} evaluations", title_of(run), duration_text(run.wall_seconds),
                     run.worst_error, run.evaluations);
}

// A line a method, in the order of the runs.
std::vector<DiagramLine> run_lines(const SceneRuns& scene) {
  std::vector<DiagramLine> lines;
  for (const IntegrationRun& run : scene.runs) {
    if (lines.empty() || lines.back().name != run.method) lines.push_back({run.method, {}});
    if (run.ok()) lines.back().points.push_back({run.worst_error, run.wall_seconds, label_of(run), run.is_on_front});
  }
  return lines;
}

}  // namespace

std::string integration_svg(const SceneRuns& scene) {
  return diagram_svg({fmt::format("{}: wall time against error of integration, {}", scene.model, stretch_text(scene)),
                      {reference_text(scene), scales_text(scene), processor_name()},
                      {"error [-], worst over the rows", error_tick},
                      {"wall time of a run [s]", duration_text},
                      run_lines(scene),
                      scene.reference_error,
                      "below the reference's own error"});
}

}  // namespace kanec
