// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/signature.hpp"

#include <map>

#include "runtime/base/error.hpp"

namespace kanec::emit {

const Signature& signature(const std::string& function) {
  static const std::map<std::string, Signature> known = {
      {"kinematics", {true, true, false, false, "xdot", "rates of x (nx) [1/s], [m/s]"}},
      {"poses", {true, false, false, false, "pose", "R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)"}},
      {"energy", {true, true, false, false, "energy", "kinetic, potential (2) [J]"}},
      {"momentum", {true, true, false, false, "momentum", "linear (3) [kg m/s], angular (3) [kg m^2/s]"}},
      {"power", {true, true, false, true, "out", "power (1) [W]"}},
      {"accelerations", {true, true, false, true, "ydot", "rates of y (ny) [rad/s^2], [m/s^2]"}},
      {"residual", {true, true, true, true, "r", "r (ny) [N m], [N]"}},
      {"forcing", {true, true, false, true, "f", "f (ny) [N m], [N]"}},
      {"mass_matrix", {true, false, false, false, "A", "A (ny x ny) [kg m^2], [kg m], [kg]"}},
      {"partial_velocities", {true, false, false, false, "v_y", "v_y of body 1, of body 2, ... (n_bodies x 3 x ny)"}},
      {"partial_velocity_rates",
       {true, true, false, false, "v_y_dot", "v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)"}},
  };
  const auto found = known.find(function);
  if (found == known.end()) throw InternalError("emit: no signature of function " + function);
  return found->second;
}

std::string parameter_list(const Signature& signature, const Reads& reads) {
  std::string list;
  const auto append = [&list](bool wanted, bool read, const std::string& parameter) {
    if (wanted) list += (read ? "" : "[[maybe_unused]] ") + parameter + ", ";
  };
  append(true, reads.prepared, "const Prepared<T>& c");
  append(signature.x, reads.x, "const T* x");
  append(signature.y, reads.y, "const T* y");
  append(signature.ydot, reads.ydot, "const T* ydot");
  append(signature.inputs, reads.inputs, "const Inputs<T>& u");
  return list + "T* " + signature.out;
}

std::string argument_list(const Signature& signature, const std::string& prepared, const std::string& inputs,
                          const std::string& out) {
  std::string list = prepared;
  if (signature.x) list += ", x";
  if (signature.y) list += ", y";
  if (signature.ydot) list += ", ydot";
  if (signature.inputs) list += ", " + inputs;
  return list + ", " + out;
}

}  // namespace kanec::emit
