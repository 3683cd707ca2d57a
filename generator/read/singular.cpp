// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/singular.hpp"

#include <algorithm>
#include <cmath>

#include "generator/scene/component.hpp"

namespace kanec::scene {
namespace {

constexpr long double least_independence = 1e-9L;  // sine, or volume of three unit vectors
// Of a moment to the sum of all, with m r²: below, elimination in 64 bits cannot tell it from zero.
constexpr long double elimination_noise = 1e-18L;
// Of a moment to the sum of the principal ones where a ball leaves it alone: below, double precision has no use for it.
constexpr long double zero_moment_long = 1e-14L;

// Mass, mass centre and inertia of one body, inertial axes at the start.
struct Mass {
  long double m = 0;
  Direction r{};
  Turn inertia{};
  bool is_zero() const { return m == 0 && inertia == Turn{}; }
  long double trace() const { return inertia[0][0] + inertia[1][1] + inertia[2][2]; }
};

long double default_value(const Scene& scene, const Number& number) {
  if (number.kind == Number::Kind::constant) return number.value;
  return scene.parameters[static_cast<std::size_t>(number.index)].value;
}

Mass mass_of(const Scene& scene, const Body& body, const Turn& turn) {
  const auto value = [&scene](const Number& number) { return default_value(scene, number); };
  const Symmetric& I = body.inertia;
  const Turn inertia = {{{value(I.xx), value(I.xy), value(I.xz)},
                         {value(I.xy), value(I.yy), value(I.yz)},
                         {value(I.xz), value(I.yz), value(I.zz)}}};
  const Direction r = {value(body.r[0]), value(body.r[1]), value(body.r[2])};
  return {value(body.mass), turn * r, turn * inertia * transposed(turn)};
}

// One free speed of a joint and what a unit of it gives to its body.
struct Speed {
  Component component;
  bool rotates = false;
  Direction omega{}, v{};  // of the body, of its mass centre
};

// The free speeds of one body's joint: translations first, so that what a rotation adds is seen as the rotation's.
std::vector<Speed> free_speeds(const Scene& scene, int k, const Attitude& attitude, const Direction& r) {
  const Joint& joint = scene.bodies[static_cast<std::size_t>(k - 1)].joint;
  std::vector<Speed> slides, turns;
  for (const Component& component : speed_components(scene)) {
    if (component.body != k) continue;
    const auto i = static_cast<std::size_t>(component.index);
    const Coordinate* coordinate = coordinate_of(scene, component);
    if (coordinate ? coordinate->motion != Coordinate::Motion::free : joint.held) continue;
    if (component.kind == Component::Kind::slide) {
      slides.push_back({component, false, {}, attitude.slide_axes[i]});
      continue;
    }
    const Direction axis = coordinate ? attitude.axes[i] : transposed(attitude.turn)[i];
    const long double advance = coordinate ? static_cast<long double>(joint.pitch) : 0;
    turns.push_back({component, true, axis, sum(cross(axis, r), scaled(advance, axis))});
  }
  slides.insert(slides.end(), turns.begin(), turns.end());
  return slides;
}

class Checker {
 public:
  Checker(const Scene& scene, const std::vector<Attitude>& attitudes, const std::function<Place(int k)>& place_of)
      : scene_(scene),
        attitudes_(attitudes),
        place_of_(place_of),
        loaded_above_(scene.bodies.size()),
        mass_above_(scene.bodies.size()) {
    for (std::size_t k = 0; k < loaded_above_.size(); ++k)
      masses_.push_back(mass_of(scene, scene.bodies[k], attitudes[k].turn));
    for (std::size_t k = loaded_above_.size(); k-- > 0;) {
      const auto lower = static_cast<std::size_t>(scene.lower[k]);
      if (lower == 0) continue;
      loaded_above_[lower - 1] = loaded_above_[lower - 1] || loaded_above_[k] || !masses_[k].is_zero();
      mass_above_[lower - 1] = mass_above_[lower - 1] || mass_above_[k] || masses_[k].m > 0;
    }
  }

  void check(int k) const {
    const auto at = static_cast<std::size_t>(k - 1);
    const Joint& joint = scene_.bodies[at].joint;
    // with all translations free, those of the mass centre serve as well
    const bool any_way = joint.slides.size() == 3 &&
                         std::all_of(joint.slides.begin(), joint.slides.end(),
                                     [](const Coordinate& c) { return c.motion == Coordinate::Motion::free; });
    const std::vector<Speed> speeds = free_speeds(scene_, k, attitudes_[at], any_way ? Direction{} : masses_[at].r);
    if (!joint.ball) check_axes(k, speeds);
    for (const Speed& speed : speeds) check_carried(k, speed);
    if (!loaded_above_[at]) check_block(k, speeds);
  }

 private:
  // Successive turns: the axis that the ones before it span.
  void check_axes(int k, const std::vector<Speed>& speeds) const {
    std::vector<const Speed*> turns;
    for (const Speed& speed : speeds)
      if (speed.rotates) turns.push_back(&speed);
    for (std::size_t i = 1; i < turns.size(); ++i) {
      const Direction pair = cross(turns[0]->omega, turns[1]->omega);
      const long double independence = i == 1 ? norm(pair) : std::fabs(dot(pair, turns[2]->omega));
      if (independence < least_independence)
        fail(place_of_(k),
             coordinate_name(turns[i]->component) + ", whose axis at the start depends on those of the turns before it",
             "other axes or initial angles: here A is singular");
    }
  }

  void check_carried(int k, const Speed& speed) const {
    const auto at = static_cast<std::size_t>(k - 1);
    if (!speed.rotates && masses_[at].m == 0 && !mass_above_[at])
      refuse(k, speed, "which moves no mass", "mass in what it carries");
    if (speed.rotates && masses_[at].is_zero() && !loaded_above_[at])
      refuse(k, speed, "which moves neither mass nor inertia", "mass or inertia in what it carries");
  }

  // Lᵀ D L of the block of A, one pivot a speed.
  void check_block(int k, const std::vector<Speed>& speeds) const {
    const Mass& mass = masses_[static_cast<std::size_t>(k - 1)];
    std::vector<std::vector<long double>> block(speeds.size(), std::vector<long double>(speeds.size()));
    for (std::size_t i = 0; i < speeds.size(); ++i)
      for (std::size_t j = 0; j < speeds.size(); ++j)
        block[i][j] = mass.m * dot(speeds[i].v, speeds[j].v) + dot(speeds[i].omega, mass.inertia * speeds[j].omega);
    for (std::size_t p = 0; p < speeds.size(); ++p) {
      if (block[p][p] <= noise(k, speeds[p]))
        refuse(k, speeds[p], "which nothing resists: the body has no inertia against it at the start",
               "inertia about its axis, or mass beside it");
      for (std::size_t i = p + 1; i < speeds.size(); ++i)
        for (std::size_t j = p + 1; j < speeds.size(); ++j) block[i][j] -= block[i][p] * block[p][j] / block[p][p];
    }
  }

  // What of a pivot is rounding.
  long double noise(int k, const Speed& speed) const {
    const Mass& mass = masses_[static_cast<std::size_t>(k - 1)];
    if (!speed.rotates) return elimination_noise * mass.m;
    const long double pitch = scene_.bodies[static_cast<std::size_t>(k - 1)].joint.pitch;
    const long double all = mass.trace() + mass.m * (dot(mass.r, mass.r) + pitch * pitch);
    return speed.component.kind == Component::Kind::attitude ? zero_moment_long * mass.trace() + elimination_noise * all
                                                             : elimination_noise * all;
  }

  [[noreturn]] void refuse(int k, const Speed& speed, const std::string& reason, const std::string& instead) const {
    const bool attitude = speed.component.kind == Component::Kind::attitude;
    const std::string name = attitude ? speed_name(speed.component) : coordinate_name(speed.component);
    fail(place_of_(k), name + ", " + reason + " (A is singular)", instead + "; or a lock or prescribed motion of it");
  }

  const Scene& scene_;
  const std::vector<Attitude>& attitudes_;
  const std::function<Place(int k)>& place_of_;
  std::vector<Mass> masses_;
  std::vector<bool> loaded_above_;  // whether bodies above this one have mass or inertia
  std::vector<bool> mass_above_;    // whether they have mass
};

}  // namespace

void check_resistance(const Scene& scene, const std::vector<Attitude>& attitudes,
                      const std::function<Place(int k)>& place_of) {
  const Checker checker(scene, attitudes, place_of);
  for (int k = 1; k <= size(scene); ++k) checker.check(k);
}

}  // namespace kanec::scene
