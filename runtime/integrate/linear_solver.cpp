// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/linear_solver.hpp"

#include <sunlinsol/sunlinsol_dense.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <algorithm>

#include "runtime/base/error.hpp"

namespace kanec::integrate {
namespace {

std::optional<Jacobian> jacobian_of(const System& system, const Options& options, LinearSolver::Form form) {
  if (options.jacobian == JacobianChoice::differences) return std::nullopt;
  auto jacobian = form == LinearSolver::Form::rates ? Jacobian::of_rates(system) : Jacobian::of_residual(system);
  if (!jacobian && options.jacobian != JacobianChoice::automatic)
    throw InputError("jacobian: found '" + name_of(options.jacobian) + "' for a model without the function '" +
                     (form == LinearSolver::Form::rates ? Jacobian::request_of_rates(system.has_work())
                                                        : Jacobian::request_of_residual(system.has_work())) +
                     "'; allowed: differences");
  return jacobian;
}

}  // namespace

LinearSolver::LinearSolver(const System& system, const Options& options, Form form, N_Vector vector,
                           const sundials::Context& context)
    : jacobian_(jacobian_of(system, options, form)) {
  // KLU orders once; after that a factorisation and four solutions took it 0.05 to 0.7 of the time of the dense L U, of
  // matrices of 8 to 200 rows with 5 % to all of their entries
  is_sparse_ = jacobian_ && options.jacobian != JacobianChoice::dense;
  if (is_sparse_)
    make_sparse(vector, context);
  else
    make_dense(system.size(), vector, context);
}

void LinearSolver::make_dense(sunindextype size, N_Vector vector, const sundials::Context& context) {
  matrix_.reset(SUNDenseMatrix(size, size, context));
  if (!matrix_) throw InternalError("SUNDenseMatrix failed");
  solver_.reset(SUNLinSol_Dense(vector, matrix_.get(), context));
  if (!solver_) throw InternalError("SUNLinSol_Dense failed");
}

void LinearSolver::make_sparse(N_Vector vector, const sundials::Context& context) {
  const sunindextype size = jacobian_->size();
  const auto entries = static_cast<sunindextype>(jacobian_->values().size());
  matrix_.reset(SUNSparseMatrix(size, size, entries, CSC_MAT, context));
  if (!matrix_) throw InternalError("SUNSparseMatrix failed");
  solver_.reset(SUNLinSol_KLU(vector, matrix_.get(), context));
  if (!solver_) throw InternalError("SUNLinSol_KLU failed");
}

int LinearSolver::fill(SUNMatrix matrix, double t, N_Vector z, N_Vector zdot, double c) noexcept {
  if (!jacobian_->evaluate(t, N_VGetArrayPointer(z), zdot ? N_VGetArrayPointer(zdot) : nullptr, c)) return 1;
  const auto starts = jacobian_->starts(), rows = jacobian_->rows();
  const auto values = jacobian_->values();
  if (is_sparse_) {
    std::copy(starts.begin(), starts.end(), SUNSparseMatrix_IndexPointers(matrix));
    std::copy(rows.begin(), rows.end(), SUNSparseMatrix_IndexValues(matrix));
    std::copy(values.begin(), values.end(), SUNSparseMatrix_Data(matrix));
    return 0;
  }
  SUNMatZero(matrix);
  for (std::size_t j = 0; j + 1 < starts.size(); ++j) {
    realtype* column = SUNDenseMatrix_Column(matrix, static_cast<sunindextype>(j));
    for (auto k = static_cast<std::size_t>(starts[j]); k < static_cast<std::size_t>(starts[j + 1]); ++k)
      column[rows[k]] = values[k];
  }
  return 0;
}

extern "C" int kanec_sundials_jacobian(realtype t, N_Vector z, N_Vector, SUNMatrix matrix, void* data, N_Vector,
                                       N_Vector, N_Vector) {
  return static_cast<CallbackData*>(data)->linear->fill(matrix, t, z);
}

}  // namespace kanec::integrate
