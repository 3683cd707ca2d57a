// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/read_joint.hpp"

#include <algorithm>
#include <cmath>

#include "generator/read/placement.hpp"

namespace kanec::scene {
namespace {

constexpr long double least_sine = 1e-9L;  // between axes that are told apart

std::string count_of_axes(std::size_t n) { return "a list of " + std::to_string(n) + " axes, each \"x\" or 3 numbers"; }

Direction read_axis(const Table& body) {
  return read_direction(body.at("axis", "the axis in the joint frame: \"x\", \"-y\" and the like, or 3 numbers"));
}

std::vector<Direction> read_axes(const Table& body, std::size_t n) {
  const Node node = body.at("axes", count_of_axes(n));
  std::vector<Direction> out;
  for (const Node& axis : node.list(n, count_of_axes(n))) out.push_back(read_direction(axis));
  return out;
}

bool parallel(const Direction& a, const Direction& b) { return norm(cross(a, b)) < least_sine; }

// Two turns about one axis move nothing apart, at whatever angle.
std::vector<Direction> successive_axes(const Table& body, std::size_t n) {
  std::vector<Direction> axes = read_axes(body, n);
  for (std::size_t i = 1; i < n; ++i)
    if (parallel(axes[i - 1], axes[i]))
      fail(body.at("axes", "").place(),
           "axes " + std::to_string(i) + " and " + std::to_string(i + 1) + " in one direction",
           "successive axes in different directions");
  return axes;
}

std::vector<Direction> cartesian_axes(const Table& body) {
  if (!body.find("axes")) return {no_turn[0], no_turn[1], no_turn[2]};
  std::vector<Direction> axes = read_axes(body, 3);
  if (std::fabs(dot(axes[0], cross(axes[1], axes[2]))) < least_sine)
    fail(body.at("axes", "").place(), "three axes in one plane", "three independent directions");
  return axes;
}

// Of the plane's two directions the first is the coordinate axis that follows the largest component of the normal (x,
// y, z, x, …; of equals the first), made orthogonal to it; the second completes a right-handed triple.
std::vector<Direction> plane_of(const Direction& normal) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::fabs(normal[i]) > std::fabs(normal[largest])) largest = i;
  const Direction& next = no_turn[(largest + 1) % 3];
  const Direction first = unit(sum(next, scaled(-dot(next, normal), normal)));
  return {first, cross(normal, first)};
}

// Axes of rotation and of translation, in the joint frame.
struct JointAxes {
  std::vector<Direction> turns, slides;
};

JointAxes planar_axes(const Table& body) {
  if (!body.find("axes")) {
    const Direction normal = read_axis(body);
    return {{normal}, plane_of(normal)};
  }
  if (const auto axis = body.find("axis"))
    fail(axis->place(), "axis beside axes", "the normal as axis, or two directions of the plane as axes");
  const std::vector<Direction> axes = read_axes(body, 2);
  if (parallel(axes[0], axes[1]))
    fail(body.at("axes", "").place(), "two axes in one direction", "two directions of the plane");
  return {{unit(cross(axes[0], axes[1]))}, axes};
}

JointAxes joint_axes(const Table& body, const JointKind& kind) {
  if (kind.name == "planar") return planar_axes(body);
  if (kind.name == "cartesian") return {{}, cartesian_axes(body)};
  if (kind.turns > 1) return {successive_axes(body, static_cast<std::size_t>(kind.turns)), {}};
  if (kind.name == "free") return {{}, {no_turn[0], no_turn[1], no_turn[2]}};
  if (!kind.takes("axis")) return {};
  const Direction axis = read_axis(body);
  JointAxes out;
  if (kind.turns == 1) out.turns = {axis};
  if (kind.slides == 1) out.slides = {axis};
  return out;
}

Turn orientation(const Table& body, const char* key) {
  const auto node = body.find(key);
  return node ? read_orientation(*node) : no_turn;
}

std::vector<Coordinate> coordinates(const std::vector<Direction>& axes, const Turn& frame, bool& snapped) {
  std::vector<Coordinate> out;
  for (const Direction& axis : axes) {
    const Direction turned = unit(frame * axis);
    Coordinate coordinate;
    for (std::size_t i = 0; i < 3; ++i) coordinate.axis[i] = snap(turned[i], snapped);
    out.push_back(coordinate);
  }
  return out;
}

Rotation rotation(const Turn& turn, bool& snapped) {
  Rotation out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[i][j] = snap(turn[i][j], snapped);
  return out;
}

}  // namespace

const JointKind& read_joint_kind(const Table& body) {
  const auto node = body.find("joint");
  if (!node) return joint_kinds().front();
  std::vector<std::string> names;
  for (const JointKind& kind : joint_kinds()) names.push_back(kind.name);
  const std::string name = node->text(one_of(names, ""));
  if (std::find(names.begin(), names.end(), name) == names.end()) node->refuse(one_of(names, name));
  return joint_kind(name);
}

Joint read_joint(const Table& body, const JointKind& kind, std::vector<std::string>& notes) {
  Joint joint;
  joint.kind = kind.name;
  joint.ball = kind.ball;
  const JointAxes axes = joint_axes(body, kind);
  const Turn on_lower = orientation(body, "frame_on_lower");
  const Turn on_body = orientation(body, "frame_on_body");
  bool snapped = false;
  joint.turns = coordinates(axes.turns, on_lower, snapped);
  joint.slides = coordinates(axes.slides, on_lower, snapped);
  joint.zero = rotation(on_lower * transposed(on_body), snapped);
  if (kind.ball) joint.zero = no_rotation;
  if (kind.takes("pitch")) joint.pitch = body.at("pitch", "a number: advance along the axis [m/rad]").real();
  if (snapped) {
    Place place = body.place();
    if (const auto node = body.find("joint")) place = node->place();
    notes.push_back(remark(place, "entries of its axes and frames within 1e-15 of 0 or ±1 were made exact"));
  }
  return joint;
}

}  // namespace kanec::scene
