// What one watches besides the motion: kinematical equations, poses, energy, momentum, power of the applied loads.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/derivation.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

// Kinematical equations: ė = ½ (ε4 ω + e × ω), ε̇4 = −½ e·ω, ds/dt = ṡ.
void derive_kinematics(Derivation& derivation) {
  const scene::Layout layout(derivation.equations.scene);
  Function function{"kinematics", "xdot, the kinematical equations", {}, layout.nx, false,
                    {true, true, false, false, "xdot", "rates of x (nx) [1/s], [rad/s], [m/s]"}};
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& body = derivation.letters(k);
    const scene::BodyLayout& at = layout.bodies[static_cast<std::size_t>(k - 1)];
    const ex half = derivation.define("w", "w", k, Pass::outward, body.omega / 2, "half the angular velocity [rad/s]");
    const ex edot = derivation.define("edot", "\\dot e", k, Pass::outward, body.eps4 * half + skew(body.e) * half,
                                      "rates of eps_1, eps_2, eps_3 [1/s]");
    const ex eps4dot = derivation.define("eps4dot", "\\dot\\varepsilon_{4}", k, Pass::outward, -dot(body.e, half),
                                         "rate of eps_4 [1/s]");
    function.outputs.push_back({edot, at.eps, 1, false});
    function.outputs.push_back({eps4dot, at.eps + 3, 1, false});
    function.outputs.push_back({body.sdot, at.s[0], 1, false});
  }
  derivation.equations.functions.push_back(function);
}

void derive_poses(Derivation& derivation) {
  Function function{"poses", "attitude R and mass centre p of each body", {}, 12 * derivation.size(), false,
                    {true, false, false, false, "pose", "R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)"}};
  for (int k = 1; k <= derivation.size(); ++k) {
    function.outputs.push_back({derivation.letters(k).to_body, 12 * (k - 1), 3, false});
    function.outputs.push_back({derivation.centres[static_cast<std::size_t>(k)], 12 * (k - 1) + 9, 1, false});
  }
  derivation.equations.functions.push_back(function);
}

void derive_energy(Derivation& derivation) {
  ex kinetic = 0;
  ex moment = 0;
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& body = derivation.letters(k);
    const ex& v = derivation.velocities[static_cast<std::size_t>(k)];
    kinetic += derivation.define("T", "T", k, Pass::outward,
                                 body.mass * dot(v, v) / 2 + dot(body.omega, body.inertia * body.omega) / 2,
                                 "kinetic energy [J]");
    moment += body.mass * derivation.centres[static_cast<std::size_t>(k)];
  }
  kinetic = derivation.define("kinetic", "T", 0, Pass::inward, kinetic, "kinetic energy of the system [J]");
  ex potential = 0;
  if (!derivation.equations.gravity.is_zero()) {
    const ex h = derivation.define("mp", "mp", 0, Pass::inward, moment, "first moment of mass, inertial axes [kg m]");
    potential = derivation.define("potential", "V", 0, Pass::inward, -dot(derivation.equations.gravity, h),
                                  "potential energy of gravity [J]");
  }
  derivation.equations.functions.push_back(
      {"energy", "kinetic and potential energy [J]", {{kinetic, 0, 1, false}, {potential, 1, 1, false}}, 2, false,
       {true, true, false, false, "energy", "kinetic, potential (2) [J]"}});
}

void derive_momentum(Derivation& derivation) {
  ex linear = 0;
  ex angular = 0;
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& body = derivation.letters(k);
    const auto at = static_cast<std::size_t>(k);
    const ex l = derivation.define("l", "l", k, Pass::outward, body.mass * derivation.velocities[at],
                                   "linear momentum, inertial axes [kg m/s]");
    linear += l;
    angular += derivation.define("H", "H", k, Pass::outward,
                                 skew(derivation.centres[at]) * l + body.to_inertial * (body.inertia * body.omega),
                                 "angular momentum about the inertial origin, inertial axes [kg m^2/s]");
  }
  linear = derivation.define("linear", "l", 0, Pass::inward, linear, "linear momentum of the system [kg m/s]");
  angular = derivation.define("angular", "H", 0, Pass::inward, angular,
                              "angular momentum of the system about the inertial origin [kg m^2/s]");
  derivation.equations.functions.push_back({"momentum",
                                            "linear and angular momentum, inertial axes, about the inertial origin",
                                            {{linear, 0, 1, false}, {angular, 3, 1, false}},
                                            6,
                                            false,
                                            {true, true, false, false, "momentum", "linear (3) [kg m/s], angular (3) [kg m^2/s]"}});
}

// Only where the scene has applied loads.
void derive_power(Derivation& derivation) {
  ex power = 0;
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& body = derivation.letters(k);
    if (!body.force.is_zero()) power += dot(body.force, derivation.velocities[static_cast<std::size_t>(k)]);
    if (!body.moment.is_zero()) power += dot(body.moment, body.omega);
  }
  if (power.is_zero()) return;
  power = derivation.define("power", "W", 0, Pass::inward, power, "power of the applied loads [W]");
  derivation.equations.functions.push_back({"power", "power of the applied loads, without gravity [W]", {{power, 0, 1, false}}, 1, false,
                                            {true, true, false, true, "out", "power (1) [W]"}});
}

}  // namespace

void derive_measures(Derivation& derivation) {
  derive_kinematics(derivation);
  derive_poses(derivation);
  derive_energy(derivation);
  derive_momentum(derivation);
  derive_power(derivation);
}

}  // namespace kanec::symbolic
