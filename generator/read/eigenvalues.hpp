// Eigenvalues of a symmetric 3×3 matrix of doubles. Not: eigenvectors, or anything of a scene.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace kanec::scene {

// Ascending; absolute error of a few ulps of the largest. `matrix` is finite and symmetric.
// Cyclic Jacobi rotations (Golub & Van Loan, Matrix Computations, §8.5).
std::array<double, 3> eigenvalues(std::array<std::array<double, 3>, 3> matrix);

}  // namespace kanec::scene
