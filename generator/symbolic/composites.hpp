// What a joint carries, as one rigid body frozen in its present shape: mass, first moment, inertia. And the columns of
// A: forces and moments that one unit of a speed's rate takes. Not: A itself (mass_matrix.cpp, accelerations.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <vector>

#include "generator/symbolic/derivation.hpp"

namespace kanec::symbolic {

// One block of A: of a row coordinate and a column coordinate at or above it.
struct MatrixBlock {
  int row_link = 0, column_link = 0;
  std::size_t row = 0, column = 0;  // coordinates of these links
  GiNaC::ex block;
  bool transposed = false;  // `block` is the transpose of the entry
  bool wide = false;        // 3×3: a scalar stands for that times the identity
};

class Composites {
 public:
  // Links for which `starts_anew` pass nothing on to their lower link; their translation is then that of the link in
  // home axes, not along the lower link's.
  Composites(Derivation& derivation, std::vector<bool> starts_anew);

  // Blocks of the columns of all coordinates of a link in the state; every pair of coordinates once. Zero blocks are
  // left out.
  std::vector<MatrixBlock> columns(int link);

  // Of what a link carries, about its origin, link axes.
  const GiNaC::ex& mass(int link) const { return mass_[static_cast<std::size_t>(link)]; }
  const GiNaC::ex& moment(int link) const { return moment_[static_cast<std::size_t>(link)]; }
  const GiNaC::ex& inertia(int link) const { return inertia_[static_cast<std::size_t>(link)]; }
  // The same in the lower link's axes, for a link that turns with its lower link.
  const GiNaC::ex& lower_moment(int link);
  const GiNaC::ex& lower_inertia(int link);

 private:
  // Force (axes of `frame`) and moment about the origin (link axes) that the rest must give to what a link carries.
  struct Wrench {
    GiNaC::ex force;
    Frame frame;
    GiNaC::ex moment;
  };

  void add(int link);
  bool is_cut(int link) const { return starts_anew_[static_cast<std::size_t>(link)]; }
  bool passes_moment(int link) const { return derivation_.letters(link).turns_with_lower; }
  Wrench unit(int link, const Coordinate& coordinate);
  Wrench lowered(const Wrench& wrench, int link, const Coordinate& column);
  GiNaC::ex row(const Wrench& wrench, int link, const Coordinate& coordinate, bool column_is_wide, bool& transposed);
  GiNaC::ex with_names(const GiNaC::ex& value);
  GiNaC::ex relative(const GiNaC::ex& R_J, const GiNaC::ex& Rt_K);
  bool is_attitude(const GiNaC::ex& factor) const;
  GiNaC::ex define(const std::string& name, const std::string& latex, int link, const GiNaC::ex& value,
                   const std::string& meaning);
  GiNaC::ex define_column(const std::string& letter, const Coordinate& column, int link, const GiNaC::ex& value,
                          const std::string& meaning);

  Derivation& derivation_;
  std::vector<bool> starts_anew_;
  std::vector<GiNaC::ex> mass_, moment_, inertia_;  // m, h and J
  std::map<int, GiNaC::ex> lower_moment_, lower_inertia_;
  std::map<int, int> link_of_attitude_;  // by table index of R and Rᵀ
  GiNaC::exmap rotations_;
};

}  // namespace kanec::symbolic
