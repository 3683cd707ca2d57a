// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/links.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kanec::symbolic {

using scene::Joint;
using scene::Rotation;

namespace {

// Rounding noise beside ones: cos of a typed pi/2, or what a product of such leaves.
double snapped(long double value) {
  constexpr long double noise = 4e-16L;
  for (const double exact : {0.0, 1.0, -1.0})
    if (std::fabs(value - exact) < noise) return exact;
  return static_cast<double>(value);
}

// Of a rotation that only exchanges axes, and turns them round: which component becomes component i.
std::optional<std::size_t> source_of(const Rotation& a, std::size_t i) {
  std::optional<std::size_t> source;
  for (std::size_t j = 0; j < 3; ++j) {
    if (a[i][j] == 1 || a[i][j] == -1) source = j;
    if (a[i][j] != 0 && a[i][j] != 1 && a[i][j] != -1) return std::nullopt;
  }
  return source;
}

// Takes what is along a coordinate axis out of an offset.
Offset taken_along(const scene::Axis& axis, Offset& offset) {
  Offset along;
  const auto i = static_cast<std::size_t>(coordinate_axis(axis));
  for (OffsetTerm& term : offset) {
    const auto j = source_of(term.orientation, i);
    if (!j || term.numbers[*j].is_zero()) continue;
    OffsetTerm moved{term.orientation, {}};
    std::swap(moved.numbers[*j], term.numbers[*j]);
    along.push_back(moved);
  }
  offset.erase(std::remove_if(offset.begin(), offset.end(), [](const OffsetTerm& t) { return is_zero(t.numbers); }),
               offset.end());
  return along;
}

scene::Vector constants(const scene::Axis& axis, double factor) {
  return {scene::Number::constant(axis[0] * factor), scene::Number::constant(axis[1] * factor),
          scene::Number::constant(axis[2] * factor)};
}

Rotation attitude(const std::array<double, 4>& eps) {
  const long double x = eps[0], y = eps[1], z = eps[2], w = eps[3];
  return {{{snapped(1 - 2 * (y * y + z * z)), snapped(2 * (x * y - z * w)), snapped(2 * (x * z + y * w))},
           {snapped(2 * (x * y + z * w)), snapped(1 - 2 * (x * x + z * z)), snapped(2 * (y * z - x * w))},
           {snapped(2 * (x * z - y * w)), snapped(2 * (y * z + x * w)), snapped(1 - 2 * (x * x + y * y))}}};
}

// Adds the links of one joint after another.
class Builder {
 public:
  Builder(const scene::Scene& scene, const Reductions& reductions) : scene_(scene), reductions_(reductions) {}

  Mechanism result() {
    for (int k = 1; k <= size(scene_); ++k) add(k);
    return std::move(mechanism_);
  }

 private:
  bool moves(const scene::Coordinate& c) const {
    return c.motion != scene::Coordinate::Motion::locked || !reductions_.drop_locks;
  }

  void add(int k) {
    const auto at = static_cast<std::size_t>(k - 1);
    const scene::Body& body = scene_.bodies[at];
    const int l = scene_.lower[at];
    const BodyPlace lower = l == 0 ? BodyPlace{} : mechanism_.bodies[static_cast<std::size_t>(l - 1)];
    Link link;
    link.body = k;
    link.lower = lower.link;
    link.offset = lower.offset;
    add_term(link.offset, lower.orientation, body.q);
    std::vector<Freedom> slides = take_slides(body.joint, lower.orientation, link.offset);
    if (body.joint.ball) {
      add_ball(link, std::move(slides), body);
    } else {
      add_turns(link, std::move(slides), body.joint, lower.orientation);
    }
  }

  // The slides that move; locked ones go to the offset. Three along the lower link's own axes are one vector.
  std::vector<Freedom> take_slides(const Joint& joint, const Rotation& orientation, Offset& offset) const {
    std::vector<Freedom> slides;
    for (std::size_t i = 0; i < joint.slides.size(); ++i) {
      const scene::Coordinate& slide = joint.slides[i];
      if (moves(slide))
        slides.push_back({Freedom::Kind::slide, static_cast<int>(i), turned(orientation, slide.axis)});
      else if (slide.value != 0)
        add_term(offset, orientation, constants(slide.axis, slide.value));
    }
    const auto is_free_along = [&](std::size_t i) {
      return joint.slides[i].motion == scene::Coordinate::Motion::free && slides[i].axis == scene::no_rotation[i];
    };
    if (slides.size() == 3 && is_free_along(0) && is_free_along(1) && is_free_along(2))
      return {{Freedom::Kind::translation, 0, {}}};
    return slides;
  }

  void add_ball(Link link, std::vector<Freedom> slides, const scene::Body& body) {
    link.suffix = std::to_string(link.body);
    link.turning = body.joint.held ? Link::Turning::held : Link::Turning::ball;
    if (body.joint.held) {
      link.zero = attitude(body.initial.eps);
      const bool is_weld = slides.empty() && link.lower == 0;
      if (is_weld && reductions_.merge_welds && reductions_.drop_locks) return merge(link, link.zero);
    }
    if (!body.joint.held || !reductions_.drop_locks) link.freedoms.push_back({Freedom::Kind::attitude, 0, {}});
    link.freedoms.insert(link.freedoms.end(), slides.begin(), slides.end());
    push(link, scene::no_rotation);
  }

  // A constant rotation before a turn is taken behind it: Q Rot(a, θ) = Rot(Q a, θ) Q.
  void add_turns(Link link, std::vector<Freedom> slides, const Joint& joint, const Rotation& orientation) {
    Rotation constant = orientation;
    std::vector<Freedom> turns;
    for (std::size_t i = 0; i < joint.turns.size(); ++i) {
      const scene::Coordinate& turn = joint.turns[i];
      const scene::Axis axis = turned(constant, turn.axis);
      if (moves(turn)) {
        turns.push_back({Freedom::Kind::turn, static_cast<int>(i), axis});
        continue;
      }
      constant = product(constant, rotation_about(turn.axis, turn.value));
      if (i == 0 && joint.pitch != 0)
        add_term(link.offset, scene::no_rotation, constants(axis, joint.pitch * turn.value));
    }
    constant = product(constant, joint.zero);
    const bool is_weld = turns.empty() && slides.empty();
    if (is_weld && reductions_.merge_welds) return merge(link, constant);
    add_chain(link, std::move(slides), turns, joint, constant);
  }

  // The origin of a link may be anywhere on its axis: where its offset has nothing along it. What follows is then that
  // much further along.
  Offset taken_along_axis(Link& link) const {
    if (!reductions_.place_origins || link.freedoms.empty() || link.freedoms[0].kind != Freedom::Kind::turn) return {};
    const bool is_by_three = link.freedoms.back().kind == Freedom::Kind::translation;
    return is_by_three || coordinate_axis(link.freedoms[0].axis) < 0 ? Offset{}
                                                                     : taken_along(link.freedoms[0].axis, link.offset);
  }

  // One link a turn; the first slides. Where its axis is one of the lower link's, a link has axes parallel to these at
  // zero angle: the joint is then a plane rotation, and what is constant turns the numbers of the body once. Else the
  // last link has the body's axes.
  void add_chain(Link link, std::vector<Freedom> slides, const std::vector<Freedom>& turns, const Joint& joint,
                 const Rotation& constant) {
    const std::string suffix = std::to_string(link.body);
    const std::size_t n = turns.size();
    Offset along;
    for (std::size_t i = 0; i < std::max<std::size_t>(n, 1); ++i) {
      const bool is_last = i + 1 >= n;
      link.suffix = is_last ? suffix : suffix + std::string(1, static_cast<char>('a' + i));
      link.turning = n == 0 ? Link::Turning::fixed : Link::Turning::turn;
      link.freedoms.clear();
      if (n > 0) link.freedoms.push_back(turns[i]);
      link.freedoms.insert(link.freedoms.end(), slides.begin(), slides.end());
      link.pitch = n > 0 && turns[i].coordinate == 0 ? joint.pitch : 0.0;
      slides.clear();
      along = taken_along_axis(link);
      if (is_last) continue;
      mechanism_.links.push_back(link);
      link.lower = mechanism_.size();
      link.offset = along;
    }
    push(link, scene::no_rotation);
    mechanism_.bodies.back().offset = along;
    const bool is_plane = link.turning == Link::Turning::fixed || coordinate_axis(link.freedoms.front().axis) >= 0;
    if (!is_plane) mechanism_.links.back().zero = constant;
    mechanism_.bodies.back().orientation = is_plane ? constant : scene::no_rotation;
  }

  void push(const Link& link, const Rotation& orientation) {
    mechanism_.links.push_back(link);
    mechanism_.bodies.push_back({mechanism_.size(), orientation, {}});
  }

  void merge(const Link& link, const Rotation& orientation) {
    mechanism_.bodies.push_back({link.lower, orientation, link.offset});
  }

  static void add_term(Offset& offset, const Rotation& orientation, const scene::Vector& numbers) {
    if (!is_zero(numbers)) offset.push_back({orientation, numbers});
  }

  const scene::Scene& scene_;
  const Reductions& reductions_;
  Mechanism mechanism_;
};

}  // namespace

int coordinate_axis(const scene::Axis& a) {
  if ((a[0] != 0) + (a[1] != 0) + (a[2] != 0) != 1) return -1;
  return a[0] != 0 ? 0 : a[1] != 0 ? 1 : 2;
}

bool is_identity(const Rotation& a) { return a == scene::no_rotation; }

Rotation product(const Rotation& a, const Rotation& b) {
  Rotation result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      long double entry = 0;
      for (std::size_t l = 0; l < 3; ++l) entry += static_cast<long double>(a[i][l]) * b[l][j];
      result[i][j] = snapped(entry);
    }
  return result;
}

scene::Axis turned(const Rotation& a, const scene::Axis& v) {
  scene::Axis result;
  for (std::size_t i = 0; i < 3; ++i) {
    long double entry = 0;
    for (std::size_t l = 0; l < 3; ++l) entry += static_cast<long double>(a[i][l]) * v[l];
    result[i] = snapped(entry);
  }
  return result;
}

// 1 + sin ã + (1 - cos) ã ã.
Rotation rotation_about(const scene::Axis& axis, double angle) {
  const long double s = std::sin(static_cast<long double>(angle));
  const long double half = std::sin(static_cast<long double>(angle) / 2);
  const long double versine = 2 * half * half;
  const long double x = axis[0], y = axis[1], z = axis[2];
  return {
      {{snapped(1 - versine * (y * y + z * z)), snapped(versine * x * y - s * z), snapped(versine * x * z + s * y)},
       {snapped(versine * x * y + s * z), snapped(1 - versine * (x * x + z * z)), snapped(versine * y * z - s * x)},
       {snapped(versine * x * z - s * y), snapped(versine * y * z + s * x), snapped(1 - versine * (x * x + y * y))}}};
}

std::vector<int> Mechanism::children(int at) const {
  std::vector<int> result;
  for (int j = 1; j <= size(); ++j)
    if (link(j).lower == at) result.push_back(j);
  return result;
}

std::vector<int> Mechanism::carried(int at) const {
  std::vector<int> result;
  for (int k = 1; k <= static_cast<int>(bodies.size()); ++k)
    if (body(k).link == at) result.push_back(k);
  return result;
}

bool Mechanism::has_balls() const {
  return std::any_of(links.begin(), links.end(),
                     [](const Link& link) { return link.turning == Link::Turning::ball && link.lower > 0; });
}

namespace {

std::optional<scene::Axis> constants_of(const scene::Vector& numbers) {
  scene::Axis result;
  for (std::size_t i = 0; i < 3; ++i) {
    if (numbers[i].kind != scene::Number::Kind::constant) return std::nullopt;
    result[i] = numbers[i].value;
  }
  return result;
}

void add_scaled(scene::Axis& sum, double factor, const scene::Axis& a) {
  for (std::size_t i = 0; i < 3; ++i) sum[i] += factor * a[i];
}

// The mass centre of a body from its link's origin, link axes, where it is made of constants alone.
std::optional<scene::Axis> centre_of(const scene::Body& body, const BodyPlace& place) {
  const std::optional<scene::Axis> r = constants_of(body.r);
  if (!r || body.mass.kind != scene::Number::Kind::constant) return std::nullopt;
  scene::Axis centre = turned(place.orientation, *r);
  for (const OffsetTerm& term : place.offset) {
    const std::optional<scene::Axis> numbers = constants_of(term.numbers);
    if (!numbers) return std::nullopt;
    add_scaled(centre, 1.0, turned(term.orientation, *numbers));
  }
  return centre;
}

// Of all bodies on a link; nothing where that is not constant.
std::optional<scene::Axis> centre_of(const scene::Scene& scene, const Mechanism& mechanism,
                                     const std::vector<int>& bodies) {
  scene::Axis moment{};
  double mass = 0.0;
  for (const int k : bodies) {
    const scene::Body& body = scene.bodies[static_cast<std::size_t>(k - 1)];
    const std::optional<scene::Axis> centre = centre_of(body, mechanism.body(k));
    if (!centre) return std::nullopt;
    mass += body.mass.value;
    add_scaled(moment, body.mass.value, *centre);
  }
  if (mass == 0.0) return std::nullopt;
  for (double& entry : moment) entry /= mass;
  return moment;
}

// The axes of a link without others on it may be any about that of its joint. Turned by the angle of the mass centre, r
// has a zero for a sum and two products of each sine and cosine.
void turn_axes(const scene::Scene& scene, Mechanism& mechanism, int j) {
  Link& link = mechanism.links[static_cast<std::size_t>(j - 1)];
  const int along = link.turning == Link::Turning::turn ? coordinate_axis(link.freedoms.front().axis) : -1;
  if (along < 0 || !is_identity(link.zero) || !mechanism.children(j).empty()) return;
  const std::vector<int> bodies = mechanism.carried(j);
  std::optional<scene::Axis> centre = centre_of(scene, mechanism, bodies);
  const auto i = static_cast<std::size_t>(along), second = (i + 1) % 3, third = (i + 2) % 3;
  if (!centre || (*centre)[second] == 0 || (*centre)[third] == 0) return;
  const double angle = std::atan2((*centre)[third], (*centre)[second]);
  link.zero = rotation_about(scene::no_rotation[i], angle);
  const Rotation back = rotation_about(scene::no_rotation[i], -angle);
  for (const int k : bodies) {
    BodyPlace& place = mechanism.bodies[static_cast<std::size_t>(k - 1)];
    place.orientation = product(back, place.orientation);
    for (OffsetTerm& term : place.offset) term.orientation = product(back, term.orientation);
  }
  (*centre)[second] = std::hypot((*centre)[second], (*centre)[third]);
  (*centre)[third] = 0;
  link.centre = centre;
}

}  // namespace

Mechanism mechanism(const scene::Scene& scene, const Reductions& reductions) {
  Mechanism result = Builder(scene, reductions).result();
  for (int j = 1; j <= result.size() && reductions.turn_axes; ++j) turn_axes(scene, result, j);
  return result;
}

}  // namespace kanec::symbolic
