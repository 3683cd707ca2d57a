// The linear systems of Newton's method for SUNDIALS: a matrix, its factorisation, and the Jacobian that fills it. Not:
// Newton's method.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include <memory>
#include <optional>
#include <type_traits>

#include "runtime/integrate/jacobian.hpp"
#include "runtime/integrate/options.hpp"
#include "runtime/integrate/sundials.hpp"

namespace kanec::integrate {

class LinearSolver {
 public:
  // Of ż = g(t, z), or of F(t, z, ż) = 0.
  enum class Form { rates, residual };

  // Throws InputError where options.jacobian asks for derivatives that the model does not have. `vector`: any of the
  // system's size; must outlive it as the system must.
  LinearSolver(const System& system, const Options& options, Form form, N_Vector vector,
               const sundials::Context& context);

  SUNMatrix matrix() const { return matrix_.get(); }
  SUNLinearSolver solver() const { return solver_.get(); }
  bool has_jacobian() const { return jacobian_.has_value(); }  // else the library takes differences
  std::int64_t evaluations() const { return jacobian_ ? jacobian_->evaluations() : 0; }

  // Jacobian::evaluate() into `matrix`, which is of this kind and may be another than matrix(). Returns what the
  // library's callbacks do: 1 where an entry is not finite.
  int fill(SUNMatrix matrix, double t, N_Vector z, N_Vector zdot = nullptr, double c = 0.0) noexcept;

 private:
  struct MatrixDeleter {
    void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
  };
  struct SolverDeleter {
    void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
  };

  void make_dense(sunindextype size, N_Vector vector, const sundials::Context& context);
  void make_sparse(N_Vector vector, const sundials::Context& context);

  std::optional<Jacobian> jacobian_;
  bool is_sparse_ = false;
  std::unique_ptr<std::remove_pointer_t<SUNMatrix>, MatrixDeleter> matrix_;
  std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, SolverDeleter> solver_;
};

// Signatures of CVLsJacFn and ARKLsJacFn.
extern "C" int kanec_sundials_jacobian(realtype t, N_Vector z, N_Vector zdot, SUNMatrix matrix, void* data, N_Vector,
                                       N_Vector, N_Vector);

}  // namespace kanec::integrate
