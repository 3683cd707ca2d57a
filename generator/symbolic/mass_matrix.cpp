// A = Σ_K (m_K v_{K,y}ᵀ v_{K,y} + ω_{K,y}ᵀ I_K ω_{K,y}), block by block; bodies that share both partial velocities are
// summed as masses.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <iterator>

#include "generator/symbolic/factor.hpp"
#include "generator/symbolic/partials.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

class MassMatrix {
 public:
  explicit MassMatrix(Derivation& derivation)
      : derivation_(derivation), masses_(masses(derivation), "m_sub", "m^{*}", "mass of the subtree [kg]") {
    for (int column = 0; column < 2 * derivation.size(); ++column)
      columns_.push_back(groups(derivation.equations.tables.v_y, column));
  }

  // Block (i, j) of A, 0 where no body has both speeds.
  ex block(int i, int j) {
    ex value = 0;
    for (const Group& left : columns_[static_cast<std::size_t>(i)])
      for (const Group& right : columns_[static_cast<std::size_t>(j)]) {
        std::vector<int> both;
        std::set_intersection(left.bodies.begin(), left.bodies.end(), right.bodies.begin(), right.bodies.end(),
                              std::back_inserter(both));
        if (!both.empty())
          value += masses_.over(derivation_, both) * (derivation_.transposed(left.block) * right.block);
      }
    if (i == j && i < derivation_.size()) value += derivation_.letters(i + 1).inertia;
    return with_names(with_orthonormal_rotations(value, derivation_.equations.table));
  }

 private:
  static std::vector<ex> masses(const Derivation& derivation) {
    std::vector<ex> result = {ex(0)};
    for (int k = 1; k <= derivation.size(); ++k) result.push_back(derivation.letters(k).mass);
    return result;
  }

  // Relative rotations R_J R_Kᵀ and first moments by name; what is left is factored.
  ex with_names(const ex& value) {
    std::vector<Term> terms = expanded(value);
    for (Term& term : terms) name_rotations(term);
    return name_moments(terms);
  }

  void name_rotations(Term& term) {
    for (std::size_t i = 0; i + 1 < term.factors.size(); ++i)
      if (is_rotation(term.factors[i]) && is_rotation(term.factors[i + 1])) {
        term.factors[i] = relative(term.factors[i], term.factors[i + 1]);
        term.factors.erase(term.factors.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      }
  }

  bool is_rotation(const ex& factor) const {
    if (!GiNaC::is_a<Atom>(factor)) return false;
    const ex transpose = derivation_.equations.table.of(factor).transpose;
    return !transpose.is_equal(factor) && relative_.count(factor) == 0;
  }

  // C_{J,K} = R_J R_Kᵀ with J < K; the other one is its transpose.
  ex relative(const ex& R_J, const ex& Rt_K) {
    SymbolTable& table = derivation_.equations.table;
    const int j = table.of(R_J).body;
    const int k = table.of(Rt_K).body;
    if (j > k) return table.of(relative(table.of(Rt_K).transpose, table.of(R_J).transpose)).transpose;
    const ex value = R_J * Rt_K;
    const auto known = rotations_.find(value);
    if (known != rotations_.end()) return known->second;
    const ex symbol = derivation_.define("C" + std::to_string(j) + "_", "C_{" + std::to_string(j) + "}", k, Pass::outward,
                                         value, "takes components in the body to those in body " + std::to_string(j));
    const ex other = table.add(Role::quantity, "Ct" + std::to_string(j) + "_", "C_{" + std::to_string(j) + "}", k,
                               Shape::matrix);
    table.pair(symbol, other);
    relative_.emplace(symbol, 1);
    relative_.emplace(other, 1);
    rotations_.emplace(value, symbol);
    return symbol;
  }

  // Σ m_i X ã_i = X h~ with the first moment h = Σ m_i a_i; and the same from the other side.
  ex name_moments(const std::vector<Term>& terms) {
    if (terms.size() < 2) return sum(terms);
    const auto all_end_in_skew = [&](bool left) {
      return std::all_of(terms.begin(), terms.end(), [&](const Term& term) {
        if (term.factors.empty()) return false;
        const ex& end = left ? term.factors.front() : term.factors.back();
        return is_ex_the_function(end, skew) && rest_of(term, left).is_equal(rest_of(terms[0], left));
      });
    };
    for (const bool left : {false, true})
      if (all_end_in_skew(left)) {
        ex moment = 0;
        for (const Term& term : terms) moment += term.scalar * (left ? term.factors.front() : term.factors.back()).op(0);
        const ex rest = rest_of(terms[0], left);
        return left ? skew(moment_name(moment)) * rest : rest * skew(moment_name(moment));
      }
    return factored(sum(terms));
  }

  static ex rest_of(const Term& term, bool left) {
    std::vector<ex> factors = term.factors;
    factors.erase(left ? factors.begin() : factors.end() - 1);
    return product(factors);
  }

  ex moment_name(const ex& moment) {
    const auto negative = moments_.find(-moment);
    if (negative != moments_.end()) return -negative->second;
    const auto known = moments_.find(moment);
    if (known != moments_.end()) return known->second;
    const int body = first_body(moment);
    const ex symbol = derivation_.define("h", "h", body, Pass::inward, moment,
                                         "first moment of mass carried, about the body origin, body axes [kg m]");
    moments_.emplace(moment, symbol);
    return symbol;
  }

  // The body that all terms belong to: J of r_J, the lower body of c of d_c.
  int first_body(const ex& moment) const {
    const Symbol& symbol = derivation_.equations.table.of(expanded(moment).front().factors.back());
    return symbol.role == Role::r ? symbol.body : derivation_.lower(symbol.body);
  }

  Derivation& derivation_;
  SubsetSums masses_;
  std::vector<std::vector<Group>> columns_;
  GiNaC::exmap rotations_, relative_, moments_;
};

}  // namespace

void derive_mass_matrix(Derivation& derivation) {
  MassMatrix mass_matrix(derivation);
  const int ny = 6 * derivation.size();
  Function function{"mass_matrix", "A, symmetric positive definite", {}, ny * ny, false,
                    {true, false, false, false, "A", "A (ny x ny) [kg m^2], [kg m], [kg]"}};
  for (int i = 2 * derivation.size() - 1; i >= 0; --i)
    for (int j = i; j < 2 * derivation.size(); ++j) {
      const ex value = mass_matrix.block(i, j);
      if (value.is_zero()) continue;
      function.outputs.push_back({value, derivation.row(i) * ny + derivation.row(j), ny, false});
      if (i != j) function.outputs.push_back({value, derivation.row(j) * ny + derivation.row(i), ny, true});
    }
  derivation.equations.functions.push_back(function);
}

}  // namespace kanec::symbolic
