// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/joint_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

#include "generator/read/joint_kind.hpp"
#include "generator/scene/rotation.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/base/text.hpp"

namespace kanec {
namespace {

using scene::Axis;
using scene::Coordinate;
using Coordinates = std::vector<Coordinate>;

// Reading makes a direction one of unit length, rounded anew. Of the multiples of this one, the first that comes back
// as it was.
Axis exact_multiple(const Axis& axis) {
  constexpr int most = 64;
  for (int i = 0; i < most; ++i) {
    const double factor = 1.0 + static_cast<double>(i) / most;
    const Axis longer = {factor * axis[0], factor * axis[1], factor * axis[2]};
    const scene::Direction unit = scene::unit({longer[0], longer[1], longer[2]});
    if (Axis{static_cast<double>(unit[0]), static_cast<double>(unit[1]), static_cast<double>(unit[2])} == axis)
      return longer;
  }
  return axis;
}

std::string direction(const Axis& axis) { return toml_list(exact_multiple(axis)); }

std::string directions(const Coordinates& coordinates) {
  std::vector<std::string> words;
  for (const Coordinate& coordinate : coordinates) words.push_back(direction(coordinate.axis));
  return fmt::format("[{}]", fmt::join(words, ", "));
}

// All axes are written in the lower body's axes, so the frame there is no other; but for a free joint, whose
// translations have no other key.
std::string frame_of_slides(const Coordinates& slides) {
  if (slides[0].axis == Axis{1, 0, 0} && slides[2].axis == Axis{0, 0, 1}) return "";
  return fmt::format("frame_on_lower = {{ x = {}, z = {} }}\n", toml_list(slides[0].axis), toml_list(slides[2].axis));
}

// zero takes components in the body to components below: its rows are the joint frame's axes in the body.
std::string frame_on_body(const scene::Rotation& zero) {
  if (zero == scene::no_rotation) return "";
  return fmt::format("frame_on_body = {{ x = {}, z = {} }}\n", toml_list(zero[0]), toml_list(zero[2]));
}

// "key = 0.5" of one, "key = [0.5, 0.0]" of several.
std::string numbers(const char* key, const Coordinates& coordinates, double Coordinate::*member) {
  if (coordinates.empty()) return "";
  std::vector<double> values;
  for (const Coordinate& coordinate : coordinates)
    values.push_back(coordinate.motion == Coordinate::Motion::free ? coordinate.*member : 0.0);
  return fmt::format("{} = {}\n", key, values.size() == 1 ? toml_real(values[0]) : toml_list(values));
}

std::string motion(const scene::Scene& scene, const Coordinate& coordinate) {
  switch (coordinate.motion) {
    case Coordinate::Motion::free:
      return "\"free\"";
    case Coordinate::Motion::locked:
      return toml_real(coordinate.value);
    case Coordinate::Motion::prescribed:
      return fit::toml(scene.expressions[static_cast<std::size_t>(coordinate.expression)].text);
  }
  return "";
}

std::string motions(const scene::Scene& scene, const char* key, const Coordinates& coordinates) {
  if (std::all_of(coordinates.begin(), coordinates.end(),
                  [](const Coordinate& c) { return c.motion == Coordinate::Motion::free; }))
    return "";
  std::vector<std::string> words;
  for (const Coordinate& coordinate : coordinates) words.push_back(motion(scene, coordinate));
  return words.size() == 1 ? fmt::format("{} = {}\n", key, words[0])
                           : fmt::format("{} = [{}]\n", key, fmt::join(words, ", "));
}

std::string initial_keys(const scene::Body& body) {
  std::string text;
  if (body.joint.ball)
    text = fmt::format("eps = {}\nomega = {}\n", toml_list(body.initial.eps), toml_list(body.initial.omega));
  else
    text = numbers("theta", body.joint.turns, &Coordinate::value) +
           numbers("thetadot", body.joint.turns, &Coordinate::rate);
  return text + numbers("s", body.joint.slides, &Coordinate::value) +
         numbers("sdot", body.joint.slides, &Coordinate::rate);
}

}  // namespace

std::string toml_real(double value) {
  const std::string text = shortest(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string toml_list(std::span<const double> values) {
  std::vector<std::string> words;
  for (const double value : values) words.push_back(toml_real(value));
  return fmt::format("[{}]", fmt::join(words, ", "));
}

std::string joint_text(const scene::Joint& joint) {
  const scene::JointKind& kind = scene::joint_kind(joint.kind);
  const Coordinates& slides = joint.slides;
  std::string text = fmt::format("joint = \"{}\"\n", joint.kind);
  if (kind.takes("axes"))
    text += "axes = " + directions(slides.empty() ? joint.turns : slides) + "\n";
  else if (kind.takes("axis"))
    text += "axis = " + direction(joint.turns.empty() ? slides[0].axis : joint.turns[0].axis) + "\n";
  else if (kind.ball && slides.size() == 3)
    text += frame_of_slides(slides);
  if (kind.takes("pitch")) text += "pitch = " + toml_real(joint.pitch) + "\n";
  return joint.ball ? text : text + frame_on_body(joint.zero);
}

std::string motion_text(const scene::Scene& scene, const scene::Body& body) {
  const std::string begins = initial_keys(body);
  const std::string goes = (body.joint.held ? "eps = \"hold\"\n" : "") + motions(scene, "theta", body.joint.turns) +
                           motions(scene, "s", body.joint.slides);
  return (begins.empty() ? "" : "[body.initial]\n" + begins) + (goes.empty() ? "" : "[body.motion]\n" + goes);
}

}  // namespace kanec
