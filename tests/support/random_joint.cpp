// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/random_joint.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/random_expression.hpp"

namespace kanec::test {
namespace {

using Motion = scene::Coordinate::Motion;
using Vector = Eigen::Vector3d;

Vector vector(const scene::Axis& a) { return {a[0], a[1], a[2]}; }
scene::Axis axis(const Vector& a) {
  const Vector unit = a.normalized();
  return {unit[0], unit[1], unit[2]};
}

Eigen::Quaterniond random_quaternion(Random& random) {
  const auto eps = random_eps(random);
  return {eps[3], eps[0], eps[1], eps[2]};
}

// A coordinate axis of either sign, or any direction.
scene::Axis random_axis(Random& random) {
  if (random.chance(0.5)) return axis(random_quaternion(random) * Vector::UnitX());
  const int i = random.below(3);
  return axis((random.chance(0.5) ? 1 : -1) * Vector::Unit(i));
}

// At more than 30 degrees from `other`.
scene::Axis random_axis_across(Random& random, const scene::Axis& other) {
  scene::Axis a;
  do a = random_axis(random);
  while (vector(a).cross(vector(other)).norm() < 0.5);
  return a;
}

// Quarter turns give axes that are nearly but not to the last bit parallel to others, as people's scenes have them.
scene::Rotation random_rotation(Random& random) {
  const int kind = random.below(3);
  if (kind == 0) return scene::no_rotation;
  const Eigen::Matrix3d R = kind == 1 ? random_quaternion(random).toRotationMatrix()
                                      : Eigen::AngleAxisd(std::numbers::pi / 2, Vector::Unit(random.below(3))).matrix();
  scene::Rotation out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[i][j] = R(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  return out;
}

std::vector<scene::Coordinate> along(const std::vector<scene::Axis>& axes) {
  std::vector<scene::Coordinate> out;
  for (const scene::Axis& a : axes) out.push_back({.axis = a});
  return out;
}

std::vector<scene::Coordinate> random_turns(Random& random, int n) {
  std::vector<scene::Axis> axes;
  for (int i = 0; i < n; ++i) axes.push_back(i == 0 ? random_axis(random) : random_axis_across(random, axes.back()));
  return along(axes);
}

std::vector<scene::Coordinate> random_slides(Random& random, int n) {
  std::vector<scene::Axis> axes;
  Eigen::Matrix3d all;
  do {
    axes = {random_axis(random), random_axis(random), random_axis(random)};
    all << vector(axes[0]), vector(axes[1]), vector(axes[2]);
  } while (std::abs(all.determinant()) < 0.4);
  axes.resize(static_cast<std::size_t>(n));
  return along(axes);
}

// Two directions across the axis of the turn.
std::vector<scene::Coordinate> plane_across(const scene::Axis& turn) {
  const Vector first = vector(turn).unitOrthogonal();
  return along({axis(first), axis(vector(turn).cross(first))});
}

struct Shape {
  std::string kind;
  bool ball;
  int turns, slides;
};
const std::vector<Shape> shapes = {{"free", true, 0, 3},       {"ball", true, 0, 0},       {"bearing", true, 0, 1},
                                   {"revolute", false, 1, 0},  {"universal", false, 2, 0}, {"gimbal", false, 3, 0},
                                   {"prismatic", false, 0, 1}, {"cartesian", false, 0, 3}, {"cylindrical", false, 1, 1},
                                   {"planar", false, 1, 2},    {"screw", false, 1, 0},     {"weld", false, 0, 0}};

scene::Joint shaped(Random& random, const Shape& shape) {
  scene::Joint joint;
  joint.kind = shape.kind;
  joint.ball = shape.ball;
  if (shape.kind != "free") joint.slides = random_slides(random, shape.slides);
  joint.turns = random_turns(random, shape.turns);
  if (!shape.ball) joint.zero = random_rotation(random);
  if (shape.kind == "cylindrical") joint.slides[0].axis = joint.turns[0].axis;
  if (shape.kind == "planar") joint.slides = plane_across(joint.turns[0].axis);
  if (shape.kind == "screw") joint.pitch = random.uniform(0.05, 0.3);
  return joint;
}

// How far the axes of three turns are from dependent, 1 at best.
double independence(const scene::Joint& joint) {
  const Vector a = vector(joint.turns[0].axis), b = vector(joint.turns[1].axis), c = vector(joint.turns[2].axis);
  const Vector turned = Eigen::AngleAxisd(joint.turns[1].value, b) * c;
  return std::abs(a.cross(b).dot(turned)) / (a.cross(b).norm() * b.cross(c).norm());
}

void randomise(Random& random, scene::Joint& joint, Motion which) {
  constexpr double pi = std::numbers::pi;
  for (scene::Coordinate& turn : joint.turns)
    if (turn.motion == which) turn.value = random.uniform(-pi, pi);
  if (joint.turns.size() == 3 && joint.turns[1].motion == which)
    while (independence(joint) < 0.6) joint.turns[1].value = random.uniform(-pi, pi);
  for (scene::Coordinate& slide : joint.slides)
    if (slide.motion == which) slide.value = random.uniform(-1, 1);
  if (which == Motion::locked) return;
  for (scene::Coordinate& turn : joint.turns)
    if (turn.motion == which) turn.rate = random.uniform(-3, 3);
  for (scene::Coordinate& slide : joint.slides)
    if (slide.motion == which) slide.rate = random.uniform(-2, 2);
}

// The middle of three turns is never prescribed: its course might bring the others' axes together.
void randomise_motions(Random& random, scene::Scene& scene, scene::Joint& joint, const RandomSceneOptions& options) {
  const auto choose = [&](scene::Coordinate& coordinate, bool may_move) {
    if (random.chance(options.locked_share)) coordinate.motion = Motion::locked;
    if (!random.chance(options.prescribed_share) || !may_move) return;
    coordinate.motion = Motion::prescribed;
    coordinate.expression = static_cast<int>(scene.expressions.size());
    const double middle = random.uniform(-1, 1), amplitude = random.uniform(0.2, 1);
    scene.expressions.push_back(random_course(random, scene, middle, amplitude));
  };
  if (joint.ball) joint.held = random.chance(options.locked_share);
  for (std::size_t i = 0; i < joint.turns.size(); ++i) choose(joint.turns[i], joint.turns.size() < 3 || i != 1);
  for (scene::Coordinate& slide : joint.slides) choose(slide, true);
}

}  // namespace

std::vector<std::string> every_joint() {
  std::vector<std::string> kinds;
  for (const Shape& shape : shapes) kinds.push_back(shape.kind);
  return kinds;
}

scene::Joint random_joint(Random& random, scene::Scene& scene, const std::string& kind,
                          const RandomSceneOptions& options) {
  const auto shape = std::find_if(shapes.begin(), shapes.end(), [&](const Shape& one) { return one.kind == kind; });
  scene::Joint joint = shaped(random, *shape);
  randomise_motions(random, scene, joint, options);
  randomise(random, joint, Motion::locked);
  return joint;
}

void randomise_coordinates(Random& random, scene::Joint& joint) { randomise(random, joint, Motion::free); }

// Each of the two signs of ε, and every rotation, may come.
std::array<double, 4> random_eps(Random& random) {
  std::array<double, 4> eps;
  double square = 0;
  do {
    for (double& entry : eps) entry = random.uniform(-1, 1);
    square = eps[0] * eps[0] + eps[1] * eps[1] + eps[2] * eps[2] + eps[3] * eps[3];
  } while (square > 1 || square < 0.01);
  for (double& entry : eps) entry /= std::sqrt(square);
  return eps;
}

}  // namespace kanec::test
