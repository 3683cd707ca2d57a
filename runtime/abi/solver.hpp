// A model's functions with its prepared parameters: what integrators, benchmarks and checks call. Not: how the model
// was compiled or loaded (runtime/compile); the model must outlive its solvers.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "runtime/abi/abi.h"

namespace kanec {

// What the emitted functions read and write, all in double, matrices row-major; t and u wherever the scene's prescribed
// motions and loads depend on them:
//   kinematics             x y        -> ẋ (nx)
//   mass_matrix            x          -> A (ny × ny)
//   forcing                x y u      -> f (ny)
//   residual               x y ẏ u    -> r = A ẏ - f (ny)
//   accelerations          x y u      -> ẏ (ny)
//   partial_velocities     x          -> v_{K,y} (N × 3 × ny)
//   partial_velocity_rates x y        -> their time derivatives (N × 3 × ny)
//   energy                 x y        -> kinetic, potential [J]: of gravity and of springs with constant stiffness and rest
//   momentum               x y        -> linear (3) [kg m/s], angular about the inertial origin (3) [kg m²/s], inertial axes
//   poses                  x          -> for each body R_K (3 × 3), p_K (3)
//   power                  x y u      -> power of all other applied loads [W]
// on request:
//   partial_angular_velocities, partial_angular_velocity_rates -> ω_{K,y}, body axes, and its rates there (N × 3 × ny)
//   load_powers            x y u      -> power of each load: Body::force and moment of bodies that have one, then the loads [W]
//   driving_loads          x y ẏ u    -> loads along locked and prescribed coordinates, in the order of the state's
//   events                 x y u      -> the expressions of the events, each zero where its event happens
//   reactions              x y ẏ u    -> for each body force, moment of L(K) on K about K's origin, K's axes (6)
//   P_position, P_velocity, P_acceleration (x y ẏ u) -> of a named point P, inertial axes (3); P_jacobian -> ∂velocity/∂y (3 × ny)
//   residual_x (ny × nx), residual_y, residual_ydot (ny × ny), accelerations_x (ny × nx), accelerations_y (ny × ny),
//   accelerations_u (ny × inputs of the scene, read or not): derivatives of the emitted formulas
//   kinematics_x (nx × nx), kinematics_y (nx × ny), power_x (1 × nx), power_y (1 × ny)
//   residual_xi, accelerations_xi (ny × ny): by the tangent ξ: of a ball its rotation vector in body axes, else δx
//   state_matrix (2ny × 2ny), input_matrix (2ny × inputs of the scene): of d/dt (δξ, δy)
//   a_and_b                           -> results of a, then of b
class Solver {
 public:
  // With the model's default parameters and inputs.
  explicit Solver(const kanec_model& model);

  const kanec_model& model() const { return *model_; }
  void set_parameters(std::span<const double> parameters);  // runs prepare(); InputError unless n_parameters
  void set_inputs(std::span<const double> inputs);          // InputError unless n_inputs
  std::span<const double> parameters() const { return parameters_; }
  std::span<const double> inputs() const { return inputs_; }

  // The function of that name, or nullptr where the model was emitted without it.
  const kanec_function* find(std::string_view name) const;

  // The pattern of the matrix of that name, or nullptr where no function returns it.
  const kanec_pattern* find_pattern(std::string_view name) const;

  // One evaluation with these parameters and inputs; arguments that `function` does not read may be null.
  void evaluate(const kanec_function& function, double t, const double* x, const double* y, const double* ydot,
                double* out) const noexcept {
    function.evaluate(prepared_.data(), t, x, y, ydot, inputs_.data(), out);
  }

 private:
  const kanec_model* model_;
  std::vector<double> parameters_, inputs_;
  std::vector<double> prepared_;  // double for its alignment
};

}  // namespace kanec
