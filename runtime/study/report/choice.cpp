// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/choice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/base/text.hpp"
#include "runtime/picture/svg.hpp"
#include "runtime/study/report/methods.hpp"
#include "runtime/study/report/pareto.hpp"

namespace kanec {
namespace {

// What the scene's own settings would make of it is typed out.
std::string simulate_command(const SceneRuns& scene, const IntegrationRun& run) {
  const integrate::Options& options = *run.options;
  std::string common = fmt::format("kanec simulate {} --duration {} --output-step {} --integrator {}", scene.path,
                                   shortest(options.duration), shortest(options.output_step), name_of(options.method));
  const std::string jacobian = is_by_differences(options) ? "differences" : "auto";
  if (has_jacobian(options.method) && jacobian != scene.settings.jacobian) common += " --jacobian " + jacobian;
  if (options.order != scene.settings.order) common += fmt::format(" --order {}", options.order);
  if (has_fixed_step(options.method)) return common + " --step " + shortest(options.step);
  return common + fmt::format(" --rtol {:.0e} --atol {:.3g}", options.relative_tolerance, options.absolute_tolerance);
}

constexpr auto nothing_moves = "nothing moves; steps may have gone over a short load (simulate.longest_step)";

bool is_still(const SceneRuns& scene) { return scene.scales.length == 0.0 && scene.scales.rate == 0.0; }

std::string unknown_below(const SceneRuns& scene) {
  return fmt::format("nothing can be said, the reference is known to {:.1e}", scene.reference_error);
}

const IntegrationRun* most_accurate(const std::vector<IntegrationRun>& runs) {
  const IntegrationRun* best = nullptr;
  for (const IntegrationRun& run : runs)
    if (run.ok() && run.options && (!best || run.worst_error < best->worst_error)) best = &run;
  return best;
}

}  // namespace

std::string title_of(const IntegrationRun& run) {
  return run.setting.empty() ? run.method : run.method + ", " + run.setting;
}

void mark_front(std::vector<IntegrationRun>& runs, double least) {
  const auto cost = [least](const IntegrationRun& run) {
    return Cost{std::max(run.worst_error, least), run.wall_seconds};
  };
  for (IntegrationRun& run : runs)
    run.is_on_front = run.ok() && std::none_of(runs.begin(), runs.end(), [&](const IntegrationRun& other) {
                        return other.ok() && beats(cost(other), cost(run));
                      });
}

const IntegrationRun* fastest_within(const SceneRuns& scene, double error) {
  const IntegrationRun* best = nullptr;
  for (const IntegrationRun& run : scene.runs)
    if (run.ok() && run.options && run.worst_error <= error && (!best || run.wall_seconds < best->wall_seconds))
      best = &run;
  return best;
}

std::string comparison(const SceneRuns& scene, double error) {
  const auto fastest = [&](bool own) {
    const IntegrationRun* best = nullptr;
    for (const IntegrationRun& run : scene.runs)
      if (run.ok() && run.options.has_value() == own && run.end_error <= error &&
          (!best || run.wall_seconds < best->wall_seconds))
        best = &run;
    return best;
  };
  const auto text = [](const IntegrationRun& run) {
    return fmt::format("{}, {} ({:.1e})", title_of(run), duration_text(run.wall_seconds), run.end_error);
  };
  const IntegrationRun *ours = fastest(true), *theirs = fastest(false);
  const std::string wanted = fmt::format("for an error of {:.2g} at the end: ", error);
  if (is_still(scene)) return wanted + nothing_moves;
  if (error < scene.reference_error) return wanted + unknown_below(scene);
  if (!ours && !theirs) return wanted + "no run, neither of kanec nor of another engine";
  if (!ours || !theirs) return wanted + (theirs ? "no run of kanec" : "no run of another engine");
  return wanted + fmt::format("{}; {}: {:.3g} times as long", text(*ours), text(*theirs),
                              theirs->wall_seconds / ours->wall_seconds);
}

std::string recommendation(const SceneRuns& scene, double error) {
  const std::string wanted = fmt::format("for an error of {:.2g}: ", error);
  if (is_still(scene)) return wanted + nothing_moves;
  if (error < scene.reference_error) return wanted + unknown_below(scene);
  if (const IntegrationRun* run = fastest_within(scene, error))
    return wanted + fmt::format("{}, in {} (worst error {:.1e}): {}", title_of(*run), duration_text(run->wall_seconds),
                                run->worst_error, simulate_command(scene, *run));
  const IntegrationRun* best = most_accurate(scene.runs);
  if (!best) return wanted + "no run got to the end";
  return wanted +
         fmt::format("none of these; the most accurate is {}, with {:.1e}", title_of(*best), best->worst_error);
}

}  // namespace kanec
