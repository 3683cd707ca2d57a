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

// What the emitted functions read and write, all in double; sizes for N bodies, nx = 7N, ny = 6N:
//   kinematics             x y        -> ẋ (nx)
//   mass_matrix            x          -> A (ny × ny, row-major)
//   forcing                x y u      -> f (ny)
//   residual               x y ẏ u    -> r = A ẏ - f (ny)
//   accelerations          x y u      -> ẏ (ny)
//   partial_velocities     x          -> v_{K,y} (N × 3 × ny)
//   partial_velocity_rates x y        -> their time derivatives (N × 3 × ny)
//   energy                 x y        -> kinetic, potential [J]
//   momentum               x y        -> linear (3) [kg m/s], angular about the inertial origin (3) [kg m²/s], inertial axes
//   poses                  x          -> for each body R_K (3 × 3), p_K (3)
//   power                  x y u      -> power of the applied forces and moments, gravity not included [W]
class Solver {
 public:
  // With the model's default parameters and inputs.
  explicit Solver(const kanec_model& model);

  const kanec_model& model() const { return *model_; }
  void set_parameters(std::span<const double> parameters);  // runs prepare(); InputError unless n_parameters
  void set_inputs(std::span<const double> inputs);          // InputError unless n_inputs
  std::span<const double> inputs() const { return inputs_; }

  // The function of that name, or nullptr where the model was emitted without it.
  const kanec_function* find(std::string_view name) const;

  // One evaluation with these parameters and inputs; arguments that `function` does not read may be null.
  void evaluate(const kanec_function& function, double t, const double* x, const double* y, const double* ydot,
                double* out) const noexcept {
    function.evaluate(prepared_.data(), t, x, y, ydot, inputs_.data(), out);
  }

 private:
  const kanec_model* model_;
  std::vector<double> inputs_;
  std::vector<double> prepared_;  // double for its alignment
};

}  // namespace kanec
