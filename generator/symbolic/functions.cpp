// The functions that the solver of a scene can have, with their signatures; empty until derived.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/functions.hpp"

namespace kanec::symbolic {
namespace {

int n_load_powers(const scene::Scene& scene) {
  int n = static_cast<int>(scene.loads.size());
  for (const scene::Body& body : scene.bodies) n += !scene::is_zero(body.force) || !scene::is_zero(body.moment);
  return n;
}

// Coordinates that are locked or prescribed; an attitude counts three.
int n_driving_loads(const scene::Scene& scene) {
  int n = 0;
  const auto count = [&n](const std::vector<scene::Coordinate>& list) {
    for (const scene::Coordinate& c : list) n += c.motion != scene::Coordinate::Motion::free;
  };
  for (const scene::Body& body : scene.bodies) {
    if (body.joint.ball && body.joint.held) n += 3;
    if (!body.joint.ball) count(body.joint.turns);
    count(body.joint.slides);
  }
  return n;
}

class List {
 public:
  explicit List(const scene::Scene& scene) : scene_(scene), layout_(scene) {}

  std::vector<Function> all() {
    const int n = size(scene_), nx = layout_.nx, ny = layout_.ny;
    add("kinematics", "xdot, the kinematical equations", nx,
        {true, true, false, false, "xdot", "rates of x (nx) [1/s], [rad/s], [m/s]"});
    add("poses", "attitude R and mass centre p of each body", 12 * n,
        {true, false, false, false, "pose", "R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)"});
    add("energy", "kinetic and potential energy [J]", 2,
        {true, true, false, false, "energy", "kinetic, potential (2) [J]"});
    add("momentum", "linear and angular momentum, inertial axes, about the inertial origin", 6,
        {true, true, false, false, "momentum", "linear (3) [kg m/s], angular (3) [kg m^2/s]"});
    if (has_loads(scene_))
      add("power", "power of the applied loads, without gravity and springs that keep their energy [W]", 1,
          {true, true, false, true, "out", "power (1) [W]"});
    add("accelerations", "ydot from A ydot = f", ny,
        {true, true, false, true, "ydot", "rates of y (ny) [rad/s^2], [m/s^2]"});
    add("residual", "r = A ydot - f", ny, {true, true, true, true, "r", "r (ny) [N m], [N]"});
    add("forcing", "f of A ydot = f", ny, {true, true, false, true, "f", "f (ny) [N m], [N]"});
    add("mass_matrix", "A, symmetric positive definite", ny * ny,
        {true, false, false, false, "A", "A (ny x ny) [kg m^2], [kg m], [kg]", ny});
    add("partial_velocities", "partial velocities v_y of the mass centres: v = v_y y", 3 * n * ny,
        {true, false, false, false, "v_y", "v_y of body 1, of body 2, ... (n_bodies x 3 x ny)"});
    add("partial_velocity_rates", "time derivatives of the partial velocities", 3 * n * ny,
        {true, true, false, false, "v_y_dot", "v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)"});
    usual_ = false;
    add_on_request();
    return std::move(functions_);
  }

 private:
  void add(const std::string& name, const std::string& meaning, int n_out, const program::Signature& signature) {
    Function function{name, meaning, {}, n_out, false, signature, usual_};
    functions_.push_back(function);
  }

  void add_on_request() {
    const int n = size(scene_), ny = layout_.ny;
    add("partial_angular_velocities", "partial angular velocities omega_y, body axes: omega = omega_y y", 3 * n * ny,
        {true, false, false, false, "omega_y", "omega_y of body 1, of body 2, ... (n_bodies x 3 x ny)"});
    add("partial_angular_velocity_rates", "time derivatives of the partial angular velocities, body axes", 3 * n * ny,
        {true, true, false, false, "omega_y_dot", "omega_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)"});
    if (has_loads(scene_))
      add("load_powers", "power of each load [W]", n_load_powers(scene_),
          {true, true, false, true, "power", "one a load (" + std::to_string(n_load_powers(scene_)) + ") [W]"});
    if (const int driven = n_driving_loads(scene_); driven > 0)
      add("driving_loads", "what must act along locked and prescribed coordinates besides the joint's loads", driven,
          {true, true, true, true, "drive", "one a coordinate (" + std::to_string(driven) + ") [N m], [N]"});
    add("reactions", "force and moment on each body through its joint, about its origin, body axes", 6 * n,
        {true, true, true, true, "reaction",
         "force (3) [N] and moment (3) [N m] of body 1, of body 2, ... (n_bodies * 6)"});
    if (const int events = static_cast<int>(scene_.events.size()); events > 0) {
      program::Signature signature{true, true, false, true, "g", "one an event (" + std::to_string(events) + ")"};
      signature.by_inputs = true;  // events set inputs by their numbers in the scene
      add("events", "expressions of the events, each zero where its event happens", events, signature);
    }
    for (const scene::Point& point : scene_.points) add_point(point.name);
  }

  void add_point(const std::string& point) {
    add(point + "_position", "position of " + point + ", inertial axes", 3,
        {true, false, false, false, "position", "(3) [m]"});
    add(point + "_velocity", "velocity of " + point + ", inertial axes", 3,
        {true, true, false, false, "velocity", "(3) [m/s]"});
    add(point + "_acceleration", "acceleration of " + point + ", inertial axes", 3,
        {true, true, true, false, "acceleration", "(3) [m/s^2]"});
    add(point + "_jacobian", "partial velocities of " + point + ", inertial axes", 3 * layout_.ny,
        {true, false, false, false, "jacobian", "(3 x ny)"});
  }

  const scene::Scene& scene_;
  scene::Layout layout_;
  bool usual_ = true;
  std::vector<Function> functions_;
};

}  // namespace

bool has_loads(const scene::Scene& scene) {
  for (const scene::Body& body : scene.bodies)
    if (!scene::is_zero(body.force) || !scene::is_zero(body.moment)) return true;
  return !scene.loads.empty();
}

std::vector<Function> functions(const scene::Scene& scene) { return List(scene).all(); }

std::vector<Function> derivative_parts(const scene::Scene& scene) {
  const int ny = n_speeds(scene);
  const program::Signature signature{true, true, true, true, "r", ""};
  return {{"inertia_xi",
           "derivative of A ydot - f without applied loads by the tangent of x",
           {},
           ny * ny,
           false,
           signature,
           false},
          {"inertia_y", "the same by y", {}, ny * ny, false, signature, false},
          {"applied", "the part of r = A ydot - f that applied loads make", {}, ny, false, signature, false}};
}

}  // namespace kanec::symbolic
