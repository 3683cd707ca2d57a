// What one watches besides the motion: kinematical equations, poses, energy, momentum, power of the applied loads,
// points, events.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/acceleration_chain.hpp"
#include "generator/symbolic/factor.hpp"
#include "generator/symbolic/loads.hpp"
#include "generator/symbolic/notation.hpp"
#include "generator/symbolic/partials.hpp"
#include "generator/symbolic/stages.hpp"
#include "runtime/base/error.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

// Kinematical equations: ė = ½ (ε4 ω + e × ω), ε̇4 = −½ e·ω; of all others the rate is the speed.
void derive_kinematics(Derivation& derivation) {
  Function& function = derivation.function("kinematics");
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& link = derivation.letters(k);
    for (const Coordinate& c : link.coordinates) {
      if (c.row < 0) continue;
      if (c.freedom.kind != Freedom::Kind::attitude) {
        function.outputs.push_back({c.speed, derivation.equations.table.of(c.value).at, 1, false});
        continue;
      }
      const int at = derivation.equations.table.of(link.e).at;
      const ex half =
          derivation.define("w", "w", k, Pass::outward, link.omega / 2, "half the angular velocity [rad/s]");
      const ex edot = derivation.define("edot", "\\dot e", k, Pass::outward, link.eps4 * half + skew(link.e) * half,
                                        "rates of eps_1, eps_2, eps_3 [1/s]");
      const ex eps4dot = derivation.define("eps4dot", "\\dot\\varepsilon_{4}^{(#)}", k, Pass::outward,
                                           -dot(link.e, half), "rate of eps_4 [1/s]");
      function.outputs.push_back({edot, at, 1, false});
      function.outputs.push_back({eps4dot, at + 3, 1, false});
    }
  }
}

namespace {

// Position of a point given in link axes; p where it is the link's mass centre.
ex position(const Derivation& derivation, int link, const ex& place) {
  if (link > 0 && place.is_equal(derivation.letters(link).r)) return derivation.centres[static_cast<std::size_t>(link)];
  return derivation.origins[static_cast<std::size_t>(link)] + derivation.in_axes(place, link, 0);
}

ex mass_centre(const BodyFrame& body) { return sum(expanded(body.offset + body.orientation * body.r)); }

}  // namespace

void derive_poses(Derivation& derivation) {
  Function& function = derivation.function("poses");
  for (int k = 1; k <= derivation.n_bodies(); ++k) {
    const BodyFrame& body = derivation.body(k);
    const ex R = body.orientation_transposed * derivation.letters(body.link).to_body;
    function.outputs.push_back({R, 12 * (k - 1), 3, false, true});
    function.outputs.push_back({position(derivation, body.link, mass_centre(body)), 12 * (k - 1) + 9, 1, false});
  }
}

// Bodies that do not move have no kinetic energy, but their weight.
void derive_energy(Derivation& derivation) {
  ex kinetic = 0;
  ex moment = 0;
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& link = derivation.letters(k);
    const ex& v = derivation.velocities[static_cast<std::size_t>(k)];
    ex value = 0;
    if (!v.is_zero()) value += link.mass * dot(v, v) / 2;
    if (!link.omega.is_zero() && !link.inertia.is_zero()) value += dot(link.omega, link.inertia * link.omega) / 2;
    kinetic += derivation.define("T", "T", k, Pass::outward, value, "kinetic energy [J]");
    moment += link.mass * derivation.centres[static_cast<std::size_t>(k)];
  }
  for (const int k : derivation.mechanism().carried(0))
    moment += derivation.body(k).mass * mass_centre(derivation.body(k));
  kinetic = derivation.define("kinetic", "T", 0, Pass::inward, kinetic, "kinetic energy of the system [J]");
  ex potential = spring_energy(derivation);
  if (!derivation.equations.gravity.is_zero()) {
    const ex h = derivation.define("mp", "mp", 0, Pass::inward, moment, "first moment of mass, inertial axes [kg m]");
    if (!h.is_zero()) potential -= dot(derivation.equations.gravity, h);
  }
  potential =
      derivation.define("potential", "V", 0, Pass::inward, potential, "potential energy of gravity and springs [J]");
  Function& function = derivation.function("energy");
  function.outputs = {{kinetic, 0, 1, false}, {potential, 1, 1, false}};
}

void derive_momentum(Derivation& derivation) {
  ex linear = 0;
  ex angular = 0;
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& link = derivation.letters(k);
    const auto at = static_cast<std::size_t>(k);
    const ex l = derivation.define("l", "l", k, Pass::outward, link.mass * derivation.velocities[at],
                                   "linear momentum, inertial axes [kg m/s]");
    linear += l;
    angular += derivation.define("H", "H", k, Pass::outward,
                                 skew(derivation.centres[at]) * l + link.to_inertial * (link.inertia * link.omega),
                                 "angular momentum about the inertial origin, inertial axes [kg m^2/s]");
  }
  linear = derivation.define("linear", "l", 0, Pass::inward, linear, "linear momentum of the system [kg m/s]");
  angular = derivation.define("angular", "H", 0, Pass::inward, angular,
                              "angular momentum of the system about the inertial origin [kg m^2/s]");
  derivation.function("momentum").outputs = {{linear, 0, 1, false}, {angular, 3, 1, false}};
}

void derive_power(Derivation& derivation) {
  ex power = 0;
  for (const ex& part : load_powers(derivation, false)) power += part;
  power = derivation.define("power", "W", 0, Pass::inward, power, "power of the applied loads [W]");
  derivation.function("power").outputs = {{power, 0, 1, false}};
}

void derive_load_powers(Derivation& derivation) {
  Function& function = derivation.function("load_powers");
  for (const ex& power : load_powers(derivation, true)) {
    const int at = static_cast<int>(function.outputs.size());
    function.outputs.push_back(
        {derivation.define("W" + std::to_string(at + 1) + "_", "W", 0, Pass::inward, power, ""), at, 1, false});
  }
}

// The expressions as they stand.
void derive_events(Derivation& derivation) {
  Function& function = derivation.function("events");
  for (const scene::Event& event : derivation.equations.scene.events) {
    const int at = static_cast<int>(function.outputs.size());
    const ex value =
        derivation.equations.table.add_numbers("g_" + event.name + "_", "g", event.name, {event.expression});
    function.outputs.push_back({value, at, 1, false});
  }
}

namespace {

ex place_of(Derivation& derivation, const scene::Point& point) {
  const BodyFrame& body = derivation.body(point.body);
  if (scene::is_zero(point.r)) return body.offset;
  const ex r = derivation.equations.table.add_numbers("r_" + point.name + "_", latex_named("r", point.name), "",
                                                      {point.r[0], point.r[1], point.r[2]});
  return sum(expanded(body.offset + body.orientation * r));
}

void derive_point_jacobian(Derivation& derivation, int link, const ex& place, Function& function) {
  derive_partial_velocities(derivation);
  for (const auto& [column, block] : partials_of_point(derivation, link, place)) {
    const Speed& speed = derivation.equations.speeds[static_cast<std::size_t>(column)];
    const bool wide = shape_of(speed.letter) == Shape::vector;
    function.outputs.push_back({factored(block), speed.row, derivation.equations.layout.ny, false, wide});
  }
}

}  // namespace

void derive_point_function(Derivation& derivation, const std::string& name) {
  Function& function = derivation.function(name);
  for (const scene::Point& point : derivation.equations.scene.points) {
    if (name.rfind(point.name + "_", 0) != 0) continue;
    const std::string what = name.substr(point.name.size() + 1);
    const int link = derivation.body(point.body).link;
    const ex place = place_of(derivation, point);
    if (what == "position") {
      function.outputs.push_back({position(derivation, link, place), 0, 1, false});
    } else if (what == "velocity") {
      const ex turning = derivation.in_axes(skew(derivation.letters(link).omega) * place, link, 0);
      function.outputs.push_back({derivation.origin_rates[static_cast<std::size_t>(link)] + turning, 0, 1, false});
    } else if (what == "acceleration" && link > 0) {
      const AccelerationChain chain = derive_acceleration_chain(derivation, derivation.rates);
      const ex value =
          derivation.in_axes(chain.of_point(link, place), derivation.home(link), 0) + derivation.equations.gravity;
      function.outputs.push_back({value, 0, 1, false});
    } else if (what == "jacobian" && link > 0) {
      derive_point_jacobian(derivation, link, place, function);
    }
  }
}

}  // namespace kanec::symbolic
