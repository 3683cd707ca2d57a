// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/scene_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <vector>

#include "runtime/base/text.hpp"

namespace kanec::cli {
namespace {

// TOML floats have a point or an exponent.
std::string real(double value) {
  const std::string text = shortest(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string list(std::span<const double> values) {
  std::vector<std::string> words;
  for (const double value : values) words.push_back(real(value));
  return fmt::format("[{}]", fmt::join(words, ", "));
}

class Writer {
 public:
  explicit Writer(const scene::Scene& scene) : scene_(scene) {}

  std::string text() {
    text_ = fmt::format("name = \"{}\"\nconnection = [{}]\n", scene_.name, fmt::join(scene_.lower, ", "));
    vector("gravity", scene_.gravity);
    named("parameters", scene_.parameters);
    named("inputs", scene_.inputs);
    for (const scene::Body& body : scene_.bodies) write(body);
    write(scene_.simulation);
    return text_;
  }

 private:
  std::string number(const scene::Number& n) const {
    const auto index = static_cast<std::size_t>(n.index);
    if (n.kind == scene::Number::Kind::parameter) return '"' + scene_.parameters[index].name + '"';
    if (n.kind == scene::Number::Kind::input) return '"' + scene_.inputs[index].name + '"';
    return real(n.value);
  }

  std::string row(const scene::Number& a, const scene::Number& b, const scene::Number& c) const {
    return fmt::format("[{}, {}, {}]", number(a), number(b), number(c));
  }

  void vector(const char* key, const scene::Vector& v) {
    if (std::all_of(v.begin(), v.end(), [](const scene::Number& n) { return n.is_zero(); })) return;
    text_ += fmt::format("{} = {}\n", key, row(v[0], v[1], v[2]));
  }

  void named(const char* key, const std::vector<scene::Named>& list) {
    if (list.empty()) return;
    text_ += fmt::format("\n[{}]\n", key);
    for (const scene::Named& entry : list) text_ += fmt::format("{} = {}\n", entry.name, real(entry.value));
  }

  void write(const scene::Body& body) {
    const scene::Symmetric& I = body.inertia;
    text_ += fmt::format("\n[[body]]\nname = \"{}\"\nmass = {}\n", body.name, number(body.mass));
    text_ +=
        fmt::format("inertia = [{}, {}, {}]\n", row(I.xx, I.xy, I.xz), row(I.xy, I.yy, I.yz), row(I.xz, I.yz, I.zz));
    vector("r", body.r);
    vector("q", body.q);
    vector("force", body.force);
    vector("moment", body.moment);
    const scene::BallState& state = body.initial;
    std::vector<double> s, sdot;
    for (const scene::Coordinate& slide : body.joint.slides) {
      s.push_back(slide.value);
      sdot.push_back(slide.rate);
    }
    text_ += fmt::format("[body.initial]\neps = {}\nomega = {}\ns = {}\nsdot = {}\n", list(state.eps),
                         list(state.omega), list(s), list(sdot));
  }

  void write(const scene::Simulation& run) {
    text_ += fmt::format("\n[simulate]\nduration = {}\noutput_step = {}\nintegrator = \"{}\"\nstep = {}\n",
                         real(run.duration), real(run.output_step), run.integrator, real(run.step));
    text_ += fmt::format("relative_tolerance = {}\nabsolute_tolerance = {}\n", real(run.relative_tolerance),
                         real(run.absolute_tolerance));
  }

  const scene::Scene& scene_;
  std::string text_;
};

}  // namespace

std::string scene_text(const scene::Scene& scene) { return Writer(scene).text(); }

}  // namespace kanec::cli
