// A ẏ = f solved with as little of A as the joints allow. A = Vᵀ 𝓜 V with V the stacked partial velocities. A free
// joint passes nothing on: with ω̇ and P̈ of its body as unknowns in place of ω̇ and s̈, V is block diagonal there, so that
// the tree falls into clusters that each begin with a free body (or with the inertial frame), and s̈ follows from the
// accelerations of the two bodies. A cluster of one body is its own balance, m a = F and I ω̇ + ω̃ I ω = M; the others
// are solved by elimination from the leaves inward, which fills in nothing.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <map>

#include "generator/symbolic/articulated.hpp"
#include "generator/symbolic/composites.hpp"
#include "generator/symbolic/factor.hpp"
#include "generator/symbolic/kane.hpp"
#include "generator/symbolic/loads.hpp"
#include "generator/symbolic/stages.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

class Solution {
 public:
  explicit Solution(Derivation& derivation) : derivation_(derivation), free_{false} {
    for (int k = 1; k <= derivation.size(); ++k) free_.push_back(derivation.is_free(k));
  }

  void all() {
    bool any_cluster = false;
    for (int k = 1; k <= derivation_.size(); ++k) any_cluster |= !is_alone(k) && has_state(k);
    if (any_cluster) derivation_.way.algorithm == Algorithm::composite ? solve_clusters() : eliminate_clusters();
    follow();
  }

 private:
  bool is_cut(int k) const { return free_[static_cast<std::size_t>(k)]; }
  const std::vector<Coordinate>& coordinates(int k) const { return derivation_.letters(k).coordinates; }

  bool has_state(int k) const {
    for (const Coordinate& c : coordinates(k))
      if (c.row >= 0) return true;
    return false;
  }

  // A free body whose links above are all free as well.
  bool is_alone(int k) const {
    if (!is_cut(k)) return false;
    for (const int c : derivation_.mechanism().children(k))
      if (!is_cut(c)) return false;
    return true;
  }

  // --- clusters

  // What is applied less inertia at ẏ = 0, and P̈ = 0 of free joints.
  Balance balance_at_rest() {
    AccelerationChain chain(derivation_, rates_at_rest(derivation_));
    const ex nothing = 0;
    for (int k = 1; k <= derivation_.size(); ++k) {
      chain.add_spin(k);
      chain.add_origin(k, is_cut(k) ? &nothing : nullptr);
    }
    return applied_less_inertia(derivation_, chain);
  }

  void eliminate_clusters() {
    std::vector<bool> alone = {true};
    for (int k = 1; k <= derivation_.size(); ++k) alone.push_back(is_alone(k));
    const Balance balance = balance_at_rest();
    const AppliedLoads loads = applied_loads(derivation_);
    found_ = Articulated(derivation_, balance, loads, alone).solution();
  }

  void solve_clusters() {
    const Balance balance = balance_at_rest();
    const InwardSums sums(derivation_, balance, "f", free_);
    const AppliedLoads loads = applied_loads(derivation_);
    Composites composites(derivation_, free_);
    Solve solve;
    std::map<Place, int> unknown;
    for (int k = derivation_.size(); k >= 1; --k) {
      if (is_alone(k)) continue;
      for (std::size_t i = 0; i < coordinates(k).size(); ++i) {
        const Coordinate& c = coordinates(k)[i];
        if (c.row < 0) continue;
        const bool is_cut_translation = is_cut(k) && c.freedom.kind == Freedom::Kind::translation;
        const ex right =
            (is_cut_translation ? sums.force(k) : sums.row(k, c)) + loads.effort[static_cast<std::size_t>(k)][i];
        unknown[{k, i}] = static_cast<int>(solve.unknowns.size());
        const ex letter = unknown_letter(c, is_cut_translation);
        solve.unknowns.push_back({letter, right, k});
        found_[{k, i}] = letter;
      }
    }
    for (int k = derivation_.size(); k >= 1; --k) {
      if (is_alone(k)) continue;
      for (const MatrixBlock& block : composites.columns(k))
        solve.matrix.push_back({unknown.at({block.row_link, block.row}), unknown.at({block.column_link, block.column}),
                                block.block, block.transposed, block.wide});
    }
    if (!solve.unknowns.empty()) derivation_.equations.solves.push_back(solve);
  }

  ex unknown_letter(const Coordinate& c, bool is_cut_translation) {
    SymbolTable& table = derivation_.equations.table;
    const Symbol& rate = table.of(c.acceleration);
    const std::string name = is_cut_translation ? "Pddot" : rate.name;
    const std::string latex = is_cut_translation ? "\\ddot P" : rate.latex;
    const std::string suffix = rate.suffix;
    const Shape shape = shape_of(c.acceleration);
    return table.add(Role::quantity, name, latex, suffix, shape);
  }

  // --- the motion that follows

  // Outward: accelerations of all links, and s̈ where a joint is free.
  void follow() {
    std::vector<bool> beside_rest = {false};
    for (int k = 1; k <= derivation_.size(); ++k) beside_rest.push_back(!is_alone(k));
    AccelerationChain chain(derivation_, derivation_.rates, beside_rest);
    const AppliedLoads loads = applied_loads(derivation_);
    for (int k = 1; k <= derivation_.size(); ++k) {
      if (is_alone(k)) {
        add_alone(chain, loads, k);
      } else {
        set_found(chain, k);
        const ex* origin = is_cut(k) ? &found_.at({k, 1}) : nullptr;
        chain.add_spin(k);
        chain.add_origin(k, origin);
      }
      if (is_cut(k)) add_sddot(chain, k);
    }
  }

  void set_found(AccelerationChain& chain, int k) {
    for (std::size_t i = 0; i < coordinates(k).size(); ++i) {
      const Coordinate& c = coordinates(k)[i];
      if (c.row < 0 || (is_cut(k) && i == 1)) continue;
      chain.rates().set(c.speed, found_.at({k, i}));
      output(found_.at({k, i}), c);
    }
  }

  void output(const ex& value, const Coordinate& c) {
    derivation_.function("accelerations").outputs.push_back({value, c.row, 1, false});
  }

  void add_alone(AccelerationChain& chain, const AppliedLoads& loads, int k) {
    const Letters& link = derivation_.letters(k);
    const auto at = static_cast<std::size_t>(k);
    const auto define = [&](const char* name, const char* latex, const ex& value, const char* meaning,
                            bool symmetric = false) {
      return derivation_.define(name, latex, k, Pass::outward, value, meaning, symmetric);
    };
    const ex moment = define("N", "N", loads.moment[at] - gyroscopic(link.inertia, link.omega),
                             "applied less gyroscopic moment, body axes [N m]");
    const ex inertia_inverse = define("Iinv", "I^{-1}", inverse(link.inertia), "inverse of the inertia matrix", true);
    const ex omegadot = define("omegadot", "\\dot\\omega", inertia_inverse * moment, "I omegadot + omega~ I omega = M");
    chain.rates().set(link.omega, omegadot);
    chain.add_spin(k);
    const ex force = define("F", "F", loads.force[at], "applied force, inertial axes [N]");
    const ex centre =
        define("a", "a", force / link.mass, "acceleration of the mass centre, less gravity, inertial axes [m/s^2]");
    const ex Pddot = centre - chain.about_origin(k);
    chain.add_origin(k, &Pddot);
    output(omegadot, coordinates(k)[0]);
  }

  // s̈ from what the lower link gives its joint point and what the link's origin has, all less gravity.
  void add_sddot(AccelerationChain& chain, int k) {
    const Coordinate& c = coordinates(k)[1];
    Rates& rates = chain.rates();
    rates.set(c.speed, 0);
    const int below = derivation_.lower(k);
    const ex carried = chain.joint_point(k);
    const ex value = derivation_.in_axes(chain.origin(k), derivation_.home(k), below) - carried;
    output(derivation_.define("sddot", "\\ddot s", k, Pass::outward, chain.with_spin(sum(expanded(value)), below),
                              "relative acceleration, axes of the lower body [m/s^2]"),
           c);
  }

  Derivation& derivation_;
  std::vector<bool> free_;
  std::map<Place, ex> found_;
};

}  // namespace

void derive_accelerations(Derivation& derivation) { Solution(derivation).all(); }

}  // namespace kanec::symbolic
