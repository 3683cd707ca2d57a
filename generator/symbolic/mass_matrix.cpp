// A = Σ_K (m_K v_{K,y}ᵀ v_{K,y} + ω_{K,y}ᵀ I_K ω_{K,y}), block by block, through what each joint carries.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/composites.hpp"
#include "generator/symbolic/stages.hpp"

namespace kanec::symbolic {

void derive_mass_matrix(Derivation& derivation) {
  Composites composites(derivation, std::vector<bool>(static_cast<std::size_t>(derivation.size()) + 1, false));
  Function& function = derivation.function("mass_matrix");
  const int ny = derivation.equations.layout.ny;
  const auto row_of = [&](int link, std::size_t i) { return derivation.letters(link).coordinates[i].row; };
  for (int k = derivation.size(); k >= 1; --k)
    for (const MatrixBlock& block : composites.columns(k)) {
      const int row = row_of(block.row_link, block.row);
      const int column = row_of(block.column_link, block.column);
      function.outputs.push_back({block.block, row * ny + column, ny, block.transposed, block.wide});
      if (row != column)
        function.outputs.push_back({block.block, column * ny + row, ny, !block.transposed, block.wide});
    }
}

}  // namespace kanec::symbolic
