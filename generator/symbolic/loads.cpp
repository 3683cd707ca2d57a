// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/loads.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "generator/symbolic/notation.hpp"
#include "runtime/base/fit.hpp"

namespace kanec::symbolic {

using GiNaC::ex;
using scene::Load;
using scene::Number;

namespace {

// Below this distance (squared) two points have no direction between them: [m²], and a normal number in float as well.
const GiNaC::numeric& least_square() {
  static const GiNaC::numeric value = GiNaC::numeric(10).power(-36);
  return value;
}

// A point of a link: from its origin, link axes.
struct Place {
  int link = 0;
  ex at = 0;
};

// A force at a place, or a moment; written in the axes of `frame`.
struct Action {
  Place place;
  ex force = 0, moment = 0;
  Frame frame = 0;
};

bool is_fixed(const Number& number) {
  return number.kind == Number::Kind::constant || number.kind == Number::Kind::parameter;
}

class Loads {
 public:
  explicit Loads(Derivation& derivation) : derivation_(derivation), scene_(derivation.equations.scene) {}

  // What the loads of a body's own keys, or one of the scene's loads, do to the links.
  std::vector<Action> of_body(int k) {
    const scene::Body& body = scene_.bodies[static_cast<std::size_t>(k - 1)];
    const BodyFrame& frame = derivation_.body(k);
    const std::string suffix = std::to_string(k);
    std::vector<Action> actions;
    if (!scene::is_zero(body.force)) actions.push_back({centre_of(k), letter("F", suffix, body.force), 0, 0});
    if (!scene::is_zero(body.moment))
      actions.push_back({{frame.link, 0}, 0, frame.orientation * letter("M", suffix, body.moment), frame.link});
    return actions;
  }

  std::vector<Action> of(const Load& load) {
    if (load.kind == Load::Kind::joint) return along_translation(load);
    if (load.kind == Load::Kind::spring) return spring(load);
    const bool is_force = load.kind == Load::Kind::force;
    if (scene::is_zero(load.vector)) return {};
    const auto [value, frame] = in_its_axes(load);
    const Place at = place(load.point, load.name);
    std::vector<Action> actions = {{at, is_force ? value : ex(0), is_force ? ex(0) : value, frame}};
    if (load.reaction > 0) {
      const int other = derivation_.body(load.reaction).link;
      actions.push_back(
          {is_force ? same_place(at, other) : Place{other, 0}, -actions[0].force, -actions[0].moment, frame});
    }
    return actions;
  }

  // Effort along a scalar coordinate; without its spring where that is conservative and not wanted. By name: GiNaC may
  // turn the sign of a sum that stands in a product, and not in every run the same way.
  ex effort(const Load& load, const ex& value, const ex& speed, bool with_spring) {
    ex result = scalar("tau", load, load.effort) - scalar("c", load, load.damping) * speed;
    const bool has_spring = with_spring || !is_conservative(load);
    if (has_spring) result -= scalar("k", load, load.stiffness) * stretch(load, value);
    return define(has_spring ? "effort" : "damping", load, result, "along the coordinate [N m], [N]");
  }

  // The coordinate that a joint load acts along, in letters; of a constant one the value alone.
  struct Along {
    int link = 0;
    std::size_t coordinate = 0;
    ex value = 0, speed = 0;
    ex direction = 1;  // of a translation by three: the unit vector
  };
  Along along(const Load& load) {
    const scene::Joint& joint = scene_.bodies[static_cast<std::size_t>(load.point.body - 1)].joint;
    for (int j = 1; j <= derivation_.size(); ++j) {
      if (derivation_.mechanism().link(j).body != load.point.body) continue;
      const std::vector<Coordinate>& coordinates = derivation_.letters(j).coordinates;
      for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const Coordinate& c = coordinates[i];
        if (c.freedom.kind == Freedom::Kind::translation && !load.turn) return along_component(j, i, c, load);
        const bool fits = c.freedom.kind == (load.turn ? Freedom::Kind::turn : Freedom::Kind::slide);
        if (fits && c.freedom.coordinate == load.coordinate) return {j, i, c.value, c.speed, 1};
      }
    }
    const auto at = static_cast<std::size_t>(load.coordinate);
    const scene::Coordinate& locked = load.turn ? joint.turns[at] : joint.slides[at];
    return {0, 0, constant("x", load, locked.value), 0, 1};
  }

  // Along one of three translations: a force on the link at its origin, and the opposite on the lower link.
  std::vector<Action> along_translation(const Load& load) {
    const Along at = along(load);
    if (at.link == 0 || shape_of(at.direction) == Shape::scalar) return {};
    const int below = derivation_.lower(at.link);
    const ex force = effort(load, at.value, at.speed, true) * at.direction;
    return {{{at.link, 0}, force, 0, below},
            {{below, derivation_.joint_offsets[static_cast<std::size_t>(at.link)]}, -force, 0, below}};
  }

  // One of the three components of a translation.
  Along along_component(int link, std::size_t at, const Coordinate& c, const Load& load) {
    scene::Vector unit;
    unit[static_cast<std::size_t>(load.coordinate)] = Number::constant(1);
    const ex direction = vector("u", load.name, unit);
    return {link, at, dot(direction, c.value), dot(direction, c.speed), direction};
  }

  ex power(const Load& load, bool conservative) {
    if (load.kind == Load::Kind::joint) {
      const Along at = along(load);
      return effort(load, at.value, at.speed, conservative) * at.speed;
    }
    if (load.kind == Load::Kind::spring) return spring_power(load, conservative);
    return power(of(load));
  }

  ex power(const std::vector<Action>& actions) {
    ex result = 0;
    for (const Action& action : actions) {
      const int link = action.place.link;
      if (link == 0) continue;
      if (!action.force.is_zero())
        result += dot(derivation_.in_axes(action.force, action.frame, 0), velocity(action.place));
      const ex& omega = derivation_.letters(link).omega;
      if (!action.moment.is_zero() && !omega.is_zero())
        result += dot(derivation_.in_axes(action.moment, action.frame, link), omega);
    }
    return result;
  }

  ex energy(const Load& load) {
    if (!is_conservative(load)) return 0;
    const ex k = scalar("k", load, load.stiffness);
    if (load.kind == Load::Kind::spring && load.rest.is_zero()) return k * square(load) / 2;
    const ex x = stretch(load, load.kind == Load::Kind::joint ? along(load).value : length(load));
    return k * x * x / 2;
  }

 private:
  ex stretch(const Load& load, const ex& value) {
    return define("stretch", load, value - scalar("l", load, load.rest), "stretch of the spring");
  }

  bool is_conservative(const Load& load) const {
    const bool is_spring = load.kind == Load::Kind::joint || load.kind == Load::Kind::spring;
    return is_spring && !load.stiffness.is_zero() && is_fixed(load.stiffness) && is_fixed(load.rest);
  }

  // Of a body's own load.
  ex letter(const std::string& letter, const std::string& suffix, const scene::Vector& v) {
    return remembered(letter + suffix, [&] {
      return derivation_.equations.table.add_numbers(letter, letter, suffix, {v[0], v[1], v[2]});
    });
  }

  ex vector(const std::string& letter, const std::string& name, const scene::Vector& v) {
    return numbers(letter, name, {v[0], v[1], v[2]});
  }

  ex scalar(const std::string& letter, const Load& load, const Number& number) {
    return number.is_zero() ? ex(0) : numbers(letter, load.name, {number});
  }

  ex constant(const std::string& letter, const Load& load, double value) {
    return scalar(letter, load, Number::constant(value));
  }

  ex numbers(const std::string& letter, const std::string& name, std::vector<Number> values) {
    const LoadLetter named = load_letter(letter, name);
    return remembered(named.name, [&] {
      return derivation_.equations.table.add_numbers(named.name, named.latex, "", std::move(values));
    });
  }

  template <class Make>
  ex remembered(const std::string& name, Make make) {
    std::map<std::string, ex>& letters = derivation_.equations.load_letters;
    const auto known = letters.find(name);
    return known != letters.end() ? known->second : letters.emplace(name, make()).first->second;
  }

  ex define(const std::string& name, const Load& load, const ex& value, const std::string& meaning) {
    const int first = std::min(1, derivation_.size());  // 0 where nothing moves
    const int link = std::max({first, derivation_.body(load.point.body).link, derivation_.body(load.other.body).link});
    const std::string full = load_letter(name, load.name).name;
    const std::string latex = name.size() == 1 ? name : "\\mathrm{" + fit::latex(name) + "}";
    return remembered(full, [&] {
      return derivation_.define(full, latex_named(latex, load.name, link > 0 ? ",#" : ""), link, Pass::outward, value,
                                meaning);
    });
  }

  Place centre_of(int k) const {
    const BodyFrame& body = derivation_.body(k);
    return {body.link, sum(expanded(body.offset + body.orientation * body.r))};
  }

  Place place(const scene::Point& point, const std::string& name) {
    const BodyFrame& body = derivation_.body(point.body);
    if (scene::is_zero(point.r)) return {body.link, body.offset};
    const ex r = vector("r", name, point.r);
    return {body.link, sum(expanded(body.offset + body.orientation * r))};
  }

  // The same point in space from another link's origin.
  Place same_place(const Place& at, int link) {
    if (link == 0 || link == at.link) return {link, at.at};
    const ex between =
        derivation_.origins[static_cast<std::size_t>(at.link)] - derivation_.origins[static_cast<std::size_t>(link)];
    return {link,
            derivation_.define("arm", "c_{\\mathrm{arm}\\,#}", link, Pass::outward,
                               derivation_.in_axes(between, 0, link) + derivation_.in_axes(at.at, at.link, link), "")};
  }

  std::pair<ex, Frame> in_its_axes(const Load& load) {
    const ex value = vector(load.kind == Load::Kind::force ? "F" : "M", load.name, load.vector);
    if (load.axes == scene::Axes::inertial) return {value, 0};
    const int k =
        load.axes == scene::Axes::body ? load.point.body : scene_.lower[static_cast<std::size_t>(load.point.body - 1)];
    return {derivation_.body(k).orientation * value, derivation_.body(k).link};
  }

  ex position(const Place& at) const {
    return derivation_.origins[static_cast<std::size_t>(at.link)] + derivation_.in_axes(at.at, at.link, 0);
  }

  ex velocity(const Place& at) const {
    const ex& omega = derivation_.letters(at.link).omega;
    return derivation_.origin_rates[static_cast<std::size_t>(at.link)] +
           derivation_.in_axes(skew(omega) * at.at, at.link, 0);
  }

  // --- springs between points

  ex line(const Load& load) {
    return define("line", load,
                  position(place(load.other, load.name + "_other")) - position(place(load.point, load.name)),
                  "from one end of the spring to the other, inertial axes [m]");
  }
  ex line_rate(const Load& load) {
    return define("line_rate", load,
                  velocity(place(load.other, load.name + "_other")) - velocity(place(load.point, load.name)),
                  "its rate [m/s]");
  }
  ex square(const Load& load) {
    return define("ll", load, dot(line(load), line(load)) + least_square(), "length squared [m^2]");
  }
  ex length(const Load& load) { return define("length", load, GiNaC::sqrt(square(load)), "length [m]"); }

  // Attraction by the length: k (1 - rest / l) + c (d . ddot) / l².
  ex attraction(const Load& load, bool with_spring) {
    const ex k = with_spring ? scalar("k", load, load.stiffness) : ex(0);
    const ex rest = scalar("l", load, load.rest), c = scalar("c", load, load.damping);
    ex value = k;
    if (!rest.is_zero() && !k.is_zero()) value -= k * rest / length(load);
    if (!c.is_zero()) value += c * dot(line(load), line_rate(load)) / square(load);
    return value;
  }

  std::vector<Action> spring(const Load& load) {
    const ex value = attraction(load, true);
    if (value.is_zero()) return {};
    const ex factor = define("f", load, value, "attraction by the length [N/m]");
    const ex force = define("F", load, factor * line(load), "on the first end, inertial axes [N]");
    return {{place(load.point, load.name), force, 0, 0}, {place(load.other, load.name + "_other"), -force, 0, 0}};
  }

  ex spring_power(const Load& load, bool conservative) {
    const bool with_spring = conservative || !is_conservative(load);
    const ex value =
        define(with_spring ? "f" : "f_damping", load, attraction(load, with_spring), "attraction by the length [N/m]");
    if (value.is_zero()) return 0;
    return -value * dot(line(load), line_rate(load));
  }

  Derivation& derivation_;
  const scene::Scene& scene_;
};

bool has_own_load(const scene::Body& body) { return !scene::is_zero(body.force) || !scene::is_zero(body.moment); }

void apply(Derivation& derivation, const Action& action, AppliedLoads& sums) {
  const int link = action.place.link;
  if (link == 0) return;
  const auto at = static_cast<std::size_t>(link);
  if (!action.moment.is_zero()) sums.moment[at] += derivation.in_axes(action.moment, action.frame, link);
  if (action.force.is_zero()) return;
  sums.force[at] += derivation.in_axes(action.force, action.frame, derivation.home(link));
  const ex lever = derivation.define("lever", "c", link, Pass::outward,
                                     sum(expanded(action.place.at - derivation.inertia(link).reference)),
                                     "from the reference point to where a force acts, link axes [m]");
  if (!lever.is_zero()) sums.moment[at] += skew(lever) * derivation.in_axes(action.force, action.frame, link);
}

}  // namespace

LoadLetter load_letter(const std::string& letter, const std::string& load) {
  return {letter + "_" + load + "_", latex_named(letter == "tau" ? "\\tau" : letter, load)};
}

AppliedLoads applied_loads(Derivation& derivation) {
  Loads loads(derivation);
  const auto n = static_cast<std::size_t>(derivation.size()) + 1;
  AppliedLoads sums{std::vector<ex>(n), std::vector<ex>(n), {}, std::vector<ex>(n)};
  for (int j = 0; j <= derivation.size(); ++j) sums.effort.emplace_back(derivation.letters(j).coordinates.size());
  const scene::Scene& scene = derivation.equations.scene;
  for (int k = 1; k <= derivation.n_bodies(); ++k)
    for (const Action& action : loads.of_body(k)) apply(derivation, action, sums);
  for (const Load& load : scene.loads) {
    const std::vector<Action> actions = loads.of(load);
    for (const Action& action : actions) apply(derivation, action, sums);
    if (load.kind != Load::Kind::joint) continue;
    const auto at = loads.along(load);
    if (!actions.empty())
      sums.through_joint[static_cast<std::size_t>(at.link)] +=
          derivation.in_axes(actions[0].force, actions[0].frame, derivation.home(at.link));
    if (at.link > 0 && at.direction.is_equal(1))
      sums.effort[static_cast<std::size_t>(at.link)][at.coordinate] += loads.effort(load, at.value, at.speed, true);
  }
  return sums;
}

std::vector<ex> load_powers(Derivation& derivation, bool conservative) {
  Loads loads(derivation);
  const scene::Scene& scene = derivation.equations.scene;
  std::vector<ex> powers;
  for (int k = 1; k <= derivation.n_bodies(); ++k)
    if (has_own_load(scene.bodies[static_cast<std::size_t>(k - 1)])) powers.push_back(loads.power(loads.of_body(k)));
  for (const Load& load : scene.loads) powers.push_back(loads.power(load, conservative));
  return powers;
}

ex spring_energy(Derivation& derivation) {
  Loads loads(derivation);
  ex result = 0;
  for (const Load& load : derivation.equations.scene.loads) result += loads.energy(load);
  return result;
}

}  // namespace kanec::symbolic
