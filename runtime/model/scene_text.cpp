// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/scene_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "runtime/base/fit.hpp"
#include "runtime/model/joint_text.hpp"

namespace kanec {
namespace {

class Writer {
 public:
  explicit Writer(const scene::Scene& scene) : scene_(scene) {}

  std::string text() {
    text_ = fmt::format("name = \"{}\"\nconnection = [{}]\n", scene_.name, fmt::join(scene_.lower, ", "));
    vector("gravity", scene_.gravity);
    if (!scene_.functions.empty())
      text_ += fmt::format("functions = [\"{}\"]\n", fmt::join(scene_.functions, "\", \""));
    named("parameters", scene_.parameters);
    named("inputs", scene_.inputs);
    for (const scene::Body& body : scene_.bodies) write(body);
    for (const scene::Load& load : scene_.loads) write(load);
    for (const scene::Point& point : scene_.points) write(point);
    for (const scene::Event& event : scene_.events) write(event);
    write(scene_.simulation);
    write(scene_.ensemble);
    return text_;
  }

 private:
  std::string number(const scene::Number& n) const {
    const auto index = static_cast<std::size_t>(n.index);
    if (n.kind == scene::Number::Kind::parameter) return '"' + scene_.parameters[index].name + '"';
    if (n.kind == scene::Number::Kind::input) return '"' + scene_.inputs[index].name + '"';
    if (n.kind == scene::Number::Kind::expression) return fit::toml(scene_.expressions[index].text);
    return toml_real(n.value);
  }

  std::string row(const scene::Number& a, const scene::Number& b, const scene::Number& c) const {
    return fmt::format("[{}, {}, {}]", number(a), number(b), number(c));
  }

  // Where it is not zero.
  void vector(const char* key, const scene::Vector& v) {
    if (!is_zero(v)) text_ += fmt::format("{} = {}\n", key, row(v[0], v[1], v[2]));
  }

  void named(const char* key, const std::vector<scene::Named>& list) {
    if (list.empty()) return;
    text_ += fmt::format("\n[{}]\n", key);
    for (const scene::Named& entry : list) text_ += fmt::format("{} = {}\n", entry.name, toml_real(entry.value));
  }

  void write(const scene::Body& body) {
    const scene::Symmetric& I = body.inertia;
    text_ += fmt::format("\n[[body]]\nname = \"{}\"\nmass = {}\n", body.name, number(body.mass));
    text_ +=
        fmt::format("inertia = [{}, {}, {}]\n", row(I.xx, I.xy, I.xz), row(I.xy, I.yy, I.yz), row(I.xz, I.yz, I.zz));
    text_ += joint_text(body.joint);
    vector("r", body.r);
    vector("q", body.q);
    vector("force", body.force);
    vector("moment", body.moment);
    text_ += motion_text(scene_, body);
  }

  std::string body_name(int k) const { return k == 0 ? "ground" : scene_.bodies[static_cast<std::size_t>(k - 1)].name; }

  void place(const std::string& prefix, const scene::Point& point) {
    text_ += fmt::format("{}body = \"{}\"\n", prefix, body_name(point.body));
    vector((prefix + "r").c_str(), point.r);
  }

  void write(const scene::Point& point) {
    text_ += fmt::format("\n[[point]]\nname = \"{}\"\n", point.name);
    place("", point);
  }

  void write(const scene::Load& load) {
    using Kind = scene::Load::Kind;
    constexpr const char* kinds[] = {"force", "moment", "joint", "spring"};
    text_ += fmt::format("\n[[load]]\nname = \"{}\"\nkind = \"{}\"\n", load.name, kinds[static_cast<int>(load.kind)]);
    if (load.kind == Kind::joint) {
      text_ += fmt::format("coordinate = \"{}\"\n", coordinate_of(load));
    } else {
      place("", load.point);
    }
    if (load.kind == Kind::spring) place("other_", load.other);
    if (load.kind == Kind::joint || load.kind == Kind::spring)
      restoring(load);
    else
      acting(load);
  }

  // By number, which no body's name can be.
  std::string coordinate_of(const scene::Load& load) const {
    const scene::Joint& joint = scene_.bodies[static_cast<std::size_t>(load.point.body - 1)].joint;
    const std::string name = fmt::format("{}_{}", load.turn ? "theta" : "s", load.point.body);
    return (load.turn ? joint.turns : joint.slides).size() == 1 ? name
                                                                : fmt::format("{}_{}", name, load.coordinate + 1);
  }

  void acting(const scene::Load& load) {
    constexpr const char* axes[] = {"inertial", "body", "lower"};
    text_ += fmt::format("vector = {}\naxes = \"{}\"\n", row(load.vector[0], load.vector[1], load.vector[2]),
                         axes[static_cast<int>(load.axes)]);
    if (load.reaction >= 0) text_ += fmt::format("reaction = \"{}\"\n", body_name(load.reaction));
  }

  // Stiffness stands there even where it is zero: every load needs one magnitude, and a rest needs a stiffness.
  void restoring(const scene::Load& load) {
    text_ += fmt::format("stiffness = {}\n", number(load.stiffness));
    const auto unless_zero = [&](const char* key, const scene::Number& n) {
      if (!n.is_zero()) text_ += fmt::format("{} = {}\n", key, number(n));
    };
    unless_zero("effort", load.effort);
    unless_zero("damping", load.damping);
    unless_zero("rest", load.rest);
  }

  void write(const scene::Event& event) {
    constexpr const char* directions[] = {"both", "up", "down"};
    constexpr const char* actions[] = {"record", "stop", "set"};
    text_ += fmt::format("\n[[event]]\nname = \"{}\"\nexpression = {}\ndirection = \"{}\"\naction = \"{}\"\n",
                         event.name, number(event.expression), directions[static_cast<int>(event.direction)],
                         actions[static_cast<int>(event.action)]);
    std::vector<std::string> settings;
    for (const scene::Event::Setting& setting : event.settings)
      settings.push_back(scene_.inputs[static_cast<std::size_t>(setting.input)].name + " = " +
                         toml_real(setting.value));
    if (!settings.empty()) text_ += fmt::format("set = {{{}}}\n", fmt::join(settings, ", "));
    text_ += fmt::format("row = {}\n", event.row);
  }

  void write(const scene::Simulation& run) {
    text_ += fmt::format("\n[simulate]\nduration = {}\noutput_step = {}\nintegrator = \"{}\"\nstep = {}\n",
                         toml_real(run.duration), toml_real(run.output_step), run.integrator, toml_real(run.step));
    text_ += fmt::format("relative_tolerance = {}\nabsolute_tolerance = {}\njacobian = \"{}\"\norder = {}\n",
                         toml_real(run.relative_tolerance), toml_real(run.absolute_tolerance), run.jacobian, run.order);
    if (run.longest_step != 0) text_ += fmt::format("longest_step = {}\n", toml_real(run.longest_step));
  }

  void write(const scene::Ensemble& ensemble) {
    if (ensemble.count == 0) return;
    text_ += fmt::format("\n[ensemble]\ncount = {}\nseed = {}\n", ensemble.count, ensemble.seed);
    for (const scene::Draw& draw : ensemble.draws)
      text_ += fmt::format("{} = {{{} = [{}, {}]}}\n", draw.name,
                           draw.kind == scene::Draw::Kind::uniform ? "uniform" : "normal", toml_real(draw.a),
                           toml_real(draw.b));
  }

  const scene::Scene& scene_;
  std::string text_;
};

}  // namespace

std::string scene_text(const scene::Scene& scene) { return Writer(scene).text(); }

}  // namespace kanec
