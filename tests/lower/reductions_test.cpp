// What is taken out of a scene before its equations are written changes no number. Oracle: the same scene with that
// left in: welds unmerged, locks kept as coordinates, constants as parameters, and a gravity of zero that is a
// parameter.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "generator/choice/requests.hpp"
#include "generator/program/passes.hpp"
#include "tests/lower/trees.hpp"

namespace kanec::test {
namespace {

using scene::Number;
using symbolic::Reductions;

// Numbers become parameters with their values as defaults.
class Unfolded {
 public:
  explicit Unfolded(Sample s) : s_(std::move(s)) {}

  Unfolded& geometry_and_inertia() {
    for (scene::Body& body : s_.scene.bodies) {
      for (Number* number : {&body.mass, &body.inertia.xx, &body.inertia.yy, &body.inertia.zz, &body.inertia.xy,
                             &body.inertia.xz, &body.inertia.yz})
        turn(*number);
      turn(body.r);
      turn(body.q);
    }
    for (scene::Load& load : s_.scene.loads) {
      turn(load.point.r);
      turn(load.other.r);
      for (Number* number : {&load.stiffness, &load.damping, &load.rest}) turn(*number);
    }
    for (scene::Point& point : s_.scene.points) turn(point.r);
    return *this;
  }
  Unfolded& gravity() {
    turn(s_.scene.gravity);
    return *this;
  }
  Sample sample() const { return s_; }

 private:
  void turn(Number& number) {
    if (number.kind != Number::Kind::constant) return;
    const auto index = static_cast<int>(s_.scene.parameters.size());
    s_.scene.parameters.push_back({"unfolded_" + std::to_string(index), number.value});
    s_.parameters.push_back(number.value);
    number = Number::parameter(index);
  }
  void turn(scene::Vector& vector) {
    for (Number& number : vector) turn(number);
  }
  Sample s_;
};

// Many welds and locks, and gravity in every second scene.
Sample tree(int seed) {
  Random random(static_cast<std::uint64_t>(5000 + seed));
  RandomSceneOptions options = everything();
  options.locked_share = 0.4;
  options.gravity = seed % 2 == 0;
  options.joints.insert(options.joints.end(), 4, "weld");
  return sample_of(random_scene(random, 1 + seed % 8, options), random);
}

struct LeftIn {
  const char* name;
  Reductions reductions;
  Sample (*changed)(const Sample&);
  friend void PrintTo(const LeftIn& one, std::ostream* out) { *out << one.name; }
};

Sample unchanged(const Sample& s) { return s; }

Reductions without(bool Reductions::*reduction) {
  Reductions reductions;
  reductions.*reduction = false;
  return reductions;
}

Reductions in_groups_of(int links) {
  Reductions reductions;
  reductions.group = links;
  return reductions;
}

const LeftIn cases[] = {
    {"welds", without(&Reductions::merge_welds), unchanged},
    {"locks", without(&Reductions::drop_locks), unchanged},
    {"origins", without(&Reductions::place_origins), unchanged},
    {"masses", without(&Reductions::regroup), unchanged},
    {"axes", without(&Reductions::turn_axes), unchanged},
    {"masses_of_two_together", in_groups_of(2), unchanged},
    {"constants", {}, [](const Sample& s) { return Unfolded(s).geometry_and_inertia().sample(); }},
    {"gravity", {}, [](const Sample& s) { return Unfolded(s).gravity().sample(); }},
};

class Reduction : public testing::TestWithParam<LeftIn> {};

INSTANTIATE_TEST_SUITE_P(Of, Reduction, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

// In long double, where what is left are folded constants, rounded to double once: 1e-16 each in sums that cancel.
// Measured: 1.2e-13 for welds and locks, 3e-16 for constants and gravity.
TEST_P(Reduction, changes_no_number) {
  for (int seed = 0; seed < 24; ++seed) {
    const Sample s = tree(seed), left_in = GetParam().changed(s);
    const std::vector<std::string> names =
        scene::size(s.scene) <= 3 ? every_function(s.scene) : without_derivatives(s.scene);
    const program::Program reduced = program::optimized(kanec::program_of(s.scene, names));
    const program::Program whole = program::optimized(kanec::program_of(left_in.scene, names, {GetParam().reductions}));
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto few = comparable(s, names[i], evaluate(reduced, reduced.functions[i], arguments<long double>(s)));
      const auto many = comparable(s, names[i], evaluate(whole, whole.functions[i], arguments<long double>(left_in)));
      const double error = relative_difference(few, many, least_size);
      EXPECT_LT(error, 1e-12) << names[i] << " of seed " << seed;
    }
  }
}

}  // namespace
}  // namespace kanec::test
