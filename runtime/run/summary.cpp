// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/run/summary.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "runtime/base/text.hpp"
#include "runtime/run/watched_events.hpp"

namespace kanec {
namespace {

class Lines {
 public:
  void add(const std::string& label, const std::string& text) { text_ += fmt::format("  {:<30} {}\n", label, text); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string relative(const Deviation& deviation) { return brief(deviation.relative()) + " relative"; }

std::string method_text(const integrate::Options& options) {
  const std::string name = integrate::name_of(options.method);
  if (has_fixed_step(options.method)) return name + ", steps of at most " + shortest(options.step) + " s";
  const std::string jacobian = has_jacobian(options.method) ? ", Jacobian " + integrate::name_of(options.jacobian) : "";
  return fmt::format("{}{}, tolerances {} relative, {} absolute", name, jacobian, shortest(options.relative_tolerance),
                     shortest(options.absolute_tolerance));
}

void add_evaluations(Lines& lines, const Summary& summary, const integrate::Options& options) {
  std::string text = fmt::format("{} of xdot and ydot", summary.evaluations);
  if (options.method == integrate::Method::ida)
    text = fmt::format("{} of the residual or the rates", summary.evaluations);
  if (summary.jacobians > 0)
    text += fmt::format(", {} of their derivatives", summary.jacobians);
  else if (has_jacobian(options.method))
    text += ", those for difference quotients included";
  lines.add("evaluations", text);
}

void add_steps(Lines& lines, const Summary& summary, const integrate::Options& options) {
  std::string steps = fmt::format("{} accepted, {} rejected", summary.steps, summary.failed);
  if (summary.restarts > 0) steps += fmt::format(", {} restarts for the norm of eps", summary.restarts);
  lines.add("steps", steps);
  add_evaluations(lines, summary, options);
  lines.add("rows", std::to_string(summary.rows));
  lines.add("wall time", fmt::format("{:.3g} s", summary.wall_seconds));
}

void add_energy(Lines& lines, const EnergyBalance& energy, bool driven) {
  const auto parts = [](const Energy& e) {
    return fmt::format("{:.10g} J = {:.10g} kinetic {:+.10g} potential", e.total(), e.kinetic, e.potential);
  };
  lines.add("energy at the start", parts(energy.start));
  lines.add("energy at the end", parts(energy.end));
  lines.add("energy change", fmt::format("{:.10g} J", energy.change()));
  lines.add("work of applied loads", fmt::format("{:.10g} J", energy.work));
  if (driven) {
    lines.add("work of prescribed motions",
              fmt::format("{:.10g} J: what the applied loads leave over, so not checked here", energy.at_end.value));
    return;
  }
  lines.add("energy change minus work",
            fmt::format("{} J at the end, {}; at worst {} J, {}", brief(energy.at_end.value), relative(energy.at_end),
                        brief(energy.worst.value), relative(energy.worst)));
}

void add_momentum(Lines& lines, const std::string& label, const std::string& unit, const MomentumChange& change) {
  lines.add(label, fmt::format("{} {} at the end, {}; at worst {} {}, {}", brief(change.at_end.value), unit,
                               relative(change.at_end), brief(change.worst.value), unit, relative(change.worst)));
}

Json deviation_json(const Deviation& deviation) {
  return {{"value", deviation.value}, {"relative", deviation.relative()}};
}

Json energy_json(const Energy& energy) {
  return {{"kinetic", energy.kinetic}, {"potential", energy.potential}, {"total", energy.total()}};
}

Json balance_json(const EnergyBalance& energy) {
  return {{"start", energy_json(energy.start)},
          {"end", energy_json(energy.end)},
          {"change", energy.change()},
          {"work", energy.work},
          {"change_minus_work", deviation_json(energy.at_end)},
          {"worst", deviation_json(energy.worst)}};
}

Json momentum_json(const MomentumChange& change) {
  return {{"start", change.start},
          {"end", change.end},
          {"change", deviation_json(change.at_end)},
          {"worst", deviation_json(change.worst)}};
}

}  // namespace

std::string summary_text(const Summary& summary, const integrate::Options& options, const Conservation& conservation) {
  Lines lines;
  lines.add("integrator", method_text(options));
  lines.add("time", fmt::format("{} to {} s, a row every {} s", shortest(options.start), shortest(summary.t),
                                shortest(options.output_step)));
  add_steps(lines, summary, options);
  std::string label = "events";
  for (const std::string& line : event_lines(summary, options.events, 20)) lines.add(std::exchange(label, ""), line);
  if (summary.energy) add_energy(lines, *summary.energy, conservation.driven);
  if (summary.linear_momentum) add_momentum(lines, "linear momentum changed by", "kg m/s", *summary.linear_momentum);
  if (summary.angular_momentum)
    add_momentum(lines, "angular momentum changed by", "kg m^2/s", *summary.angular_momentum);
  if (summary.linear_momentum && !conservation.isolated)
    lines.add("", "(gravity, loads or joints act from outside: the momenta are not kept)");
  if (conservation.attitudes)
    lines.add("worst | |eps| - 1 |",
              fmt::format("{} at the ends of steps, {} in the rows", brief(summary.worst_norm_error_before),
                          brief(summary.worst_norm_error_after)));
  return lines.text();
}

Json summary_json(const Summary& summary, const integrate::Options& options, const Conservation& conservation) {
  Json json = {{"integrator", integrate::name_of(options.method)},
               {"duration", options.duration},
               {"output_step", options.output_step},
               {"step", options.step},
               {"relative_tolerance", options.relative_tolerance},
               {"absolute_tolerance", options.absolute_tolerance},
               {"rows", summary.rows},
               {"steps", summary.steps},
               {"failed_steps", summary.failed},
               {"restarts", summary.restarts},
               {"evaluations", summary.evaluations},
               {"jacobian_evaluations", summary.jacobians},
               {"wall_seconds", summary.wall_seconds}};
  if (options.start != 0.0) json["start"] = options.start;
  if (!options.events.empty()) {
    json["events"] = events_json(summary, options.events);
    json["stopped_by_event"] = summary.stopped;
    json["end"] = summary.t;
  }
  if (summary.energy) json["energy"] = balance_json(*summary.energy);
  if (summary.energy) json["energy"]["balanced"] = !conservation.driven;
  if (summary.linear_momentum) json["linear_momentum"] = momentum_json(*summary.linear_momentum);
  if (summary.angular_momentum) json["angular_momentum"] = momentum_json(*summary.angular_momentum);
  json["norm_error"] = {{"before_projection", summary.worst_norm_error_before},
                        {"in_rows", summary.worst_norm_error_after}};
  return json;
}

}  // namespace kanec
