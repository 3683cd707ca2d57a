// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/inertias.hpp"

#include <utility>

#include "generator/symbolic/derivation.hpp"
#include "generator/symbolic/factor.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

// What moves to the lower link, in its axes, about its origin.
struct Moved {
  ex mass, moment, inertia;
};

class Regrouping {
 public:
  explicit Regrouping(Derivation& derivation)
      : derivation_(derivation), came_(static_cast<std::size_t>(derivation.size()) + 1), links_(came_.size()) {}

  void all() {
    std::vector<Inertia> result(came_.size());
    for (int k = derivation_.size(); k >= 1; --k) result[static_cast<std::size_t>(k)] = of(k);
    derivation_.inertias = std::move(result);
  }

 private:
  Inertia of(int k) {
    const auto at = static_cast<std::size_t>(k);
    const Letters& link = derivation_.letters(k);
    Inertia own{link.mass, link.mass * link.r, link.inertia - link.mass * (skew(link.r) * skew(link.r)), link.r};
    if (!link.mass.is_zero()) ++links_[at];
    const Reductions& reductions = derivation_.way.reductions;
    const bool gives = reductions.regroup && is_hinged(k) && links_[at] < reductions.group;
    if (!gives && !came(k)) return own;
    own.mass += came_[at].mass;
    own.moment += came_[at].moment;
    own.inertia += came_[at].inertia;
    const auto define = [&](const char* name, const char* latex, const ex& value, const char* meaning, bool symmetric) {
      return derivation_.define(name, latex, k, Pass::outward, value, meaning, symmetric);
    };
    own.mass =
        define("m_all_", "m_{\\mathrm{all}\\,#}", own.mass, "mass, with what links above leave to it [kg]", false);
    own.moment = define("h_all_", "h_{\\mathrm{all}\\,#}", sum(expanded(own.moment)),
                        "first moment, likewise, link axes [kg m]", false);
    own.inertia = define("J_all_", "J_{\\mathrm{all}\\,#}", own.inertia,
                         "inertia about the origin, likewise, link axes [kg m^2]", true);
    if (gives) give(k, own);
    own.reference = 0;
    own.regrouped = true;
    own.moment = define("h_own_", "h_{\\mathrm{own}\\,#}", own.moment,
                        "first moment that the joint feels, link axes [kg m]", false);
    own.inertia = define("J_own_", "J_{\\mathrm{own}\\,#}", own.inertia,
                         "inertia that the joint feels, link axes [kg m^2]", true);
    return own;
  }

  bool came(int k) const {
    const Moved& moved = came_[static_cast<std::size_t>(k)];
    return !moved.mass.is_zero() || !moved.inertia.is_zero();
  }

  // A joint whose centre, or axis, is at rest in the lower link.
  bool is_hinged(int k) const {
    const Link& link = derivation_.mechanism().link(k);
    if (!derivation_.letters(k).s.is_zero()) return false;
    return link.turning == Link::Turning::ball || link.turning == Link::Turning::turn;
  }

  void give(int k, Inertia& own) {
    const Letters& link = derivation_.letters(k);
    const ex& d = link.offset;
    Moved moved{own.mass, own.mass * d, -own.mass * (skew(d) * skew(d))};
    own.mass = 0;
    if (link.turns_with_lower) give_line(k, own, moved);
    const auto below = static_cast<std::size_t>(derivation_.lower(k));
    links_[below] += links_[static_cast<std::size_t>(k)];
    Moved& lower = came_[below];
    lower.mass += moved.mass;
    lower.moment += moved.moment;
    lower.inertia += moved.inertia;
  }

  // A line of mass along the axis b: its first moment λ = b·h, and the inertia μ = c·J c of a rod, c normal to b.
  void give_line(int k, Inertia& own, Moved& moved) {
    const Letters& link = derivation_.letters(k);
    const int along = coordinate_axis(link.coordinates.front().freedom.axis);
    if (along < 0) return;
    const ex& d = link.offset;
    const ex b = link.coordinates.front().axis;
    const ex below = derivation_.equations.table.add_numbers("b_lower_", "b'", suffix(k),
                                                             numbers(derivation_.mechanism().link(k).freedoms[0].axis));
    const ex lambda = define_scalar("lambda", "\\lambda", k, own.moment.is_zero() ? ex(0) : dot(b, own.moment));
    const ex c = unit("c", k, (along + 1) % 3);
    const ex mu = define_scalar("mu", "\\mu", k, own.inertia.is_zero() ? ex(0) : dot(c, own.inertia * c));
    own.moment -= lambda * b;
    own.inertia += mu * (skew(b) * skew(b));
    moved.moment += lambda * below;
    moved.inertia -= lambda * (skew(d) * skew(below) + skew(below) * skew(d)) + mu * (skew(below) * skew(below));
  }

  static std::vector<scene::Number> numbers(const scene::Axis& a) {
    return {scene::Number::constant(a[0]), scene::Number::constant(a[1]), scene::Number::constant(a[2])};
  }

  const std::string& suffix(int k) const { return derivation_.mechanism().link(k).suffix; }

  ex unit(const std::string& name, int k, int i) {
    scene::Axis axis{};
    axis[static_cast<std::size_t>(i)] = 1;
    return derivation_.equations.table.add_numbers(name, name, suffix(k), numbers(axis));
  }

  ex define_scalar(const char* name, const char* latex, int k, const ex& value) {
    return derivation_.define(name, latex, k, Pass::outward, value, "of the line of mass along the axis");
  }

  Derivation& derivation_;
  std::vector<Moved> came_;  // from links above, by link
  std::vector<int> links_;   // whose masses a link holds
};

}  // namespace

void derive_inertias(Derivation& derivation) { Regrouping(derivation).all(); }

}  // namespace kanec::symbolic
