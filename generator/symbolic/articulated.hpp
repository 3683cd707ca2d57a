// A ẏ = f solved joint by joint, from the leaves inward and back: what a link and all above it ask of their joint, with
// the joint's own speeds eliminated. Grows with the number of links, not with its cube. Not here: the choice between
// this and a system for all speeds at once (accelerations.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <vector>

#include "generator/symbolic/inward_sums.hpp"
#include "generator/symbolic/loads.hpp"

namespace kanec::symbolic {

using Place = std::pair<int, std::size_t>;  // of a coordinate: link, index

// With accelerations P̈ of a link's origin and ω̇ beyond those that it has at ẏ = 0, force and moment on it and on all
// that it carries are F = M P̈ + Hᵀ ω̇ − g and N = H P̈ + J ω̇ − n. After Featherstone (1983), with ball joints that pass a
// force alone and free ones that pass nothing, and of symmetric matrices the six entries.
class Articulated {
 public:
  // Links for which `skip` are solved elsewhere; the translation of a free joint is solved as P̈, in home axes.
  Articulated(Derivation& derivation, const Balance& balance, const AppliedLoads& loads, std::vector<bool> skip);

  // Rates of the speeds, P̈ of a free joint's translation.
  const std::map<Place, GiNaC::ex>& solution() const { return found_; }

 private:
  // M and g in the axes of `frame`, H from there to the axes of J and n.
  struct Load {
    GiNaC::ex M, H, J, g, n;
    Frame frame = 0;
  };
  // Of a scalar coordinate: force and moment of a unit of its acceleration, and what of them it feels itself.
  struct Pivot {
    GiNaC::ex B, K, D;
  };
  // What is needed on the way out to find its rate: v − kB·P̈ − kK·ω̇; with the projection normal to its axis (1 where
  // that gives no zeros) and what is applied along it.
  struct Scalar {
    GiNaC::ex v, kB, kK, normal, tau;
  };
  // The same for three: L⁻ᵀ (w − W P̈).
  struct Triple {
    GiNaC::ex factors, w, W;
  };

  void inward(int link);
  void outward(int link);

  Load carried(int link);
  void add(Load& sum, int link, int child);
  void eliminate_attitude(Load& load, int link, std::size_t i);
  const Scalar& solve(int link, std::size_t i, const Pivot& pivot, const GiNaC::ex& driving);
  void eliminate_turn(Load& load, int link, std::size_t i);
  void eliminate_slide(Load& load, int link, std::size_t i);
  void eliminate_translation(Load& load, int link, std::size_t i);
  void eliminate_root(const Load& load, int link);
  Load in_lower_axes(const Load& load, int link);

  GiNaC::ex follow_slides(GiNaC::ex joint, int link);
  GiNaC::ex follow_turn(const GiNaC::ex& turned, int link);
  bool is_cut(int link) const { return derivation_.is_free(link); }
  bool passes_moment(int link) const { return derivation_.letters(link).turns_with_lower; }
  const std::vector<Coordinate>& coordinates(int link) const { return derivation_.letters(link).coordinates; }
  GiNaC::ex effort(int link, std::size_t i) const { return loads_.effort[static_cast<std::size_t>(link)][i]; }
  GiNaC::ex define(const std::string& name, int link, const GiNaC::ex& value, const std::string& meaning,
                   Pass pass = Pass::inward);
  GiNaC::ex symmetric(const std::string& name, int link, const GiNaC::ex& value, const std::string& meaning);
  GiNaC::ex rotation(Frame from, Frame to, int link);
  GiNaC::ex projection(const Coordinate& c, int link);
  GiNaC::ex found(int link, std::size_t i, const GiNaC::ex& value);
  // "B", with the number of the coordinate where a link has several.
  std::string of(const std::string& letter, int link, std::size_t i) const;

  Derivation& derivation_;
  const Balance& balance_;
  const AppliedLoads& loads_;
  std::vector<bool> skip_;
  std::vector<Load>
      passed_;  // by link: what its joint passes on, about the link's origin, moments in the lower link's axes
  std::map<Place, Scalar> scalars_;
  std::map<Place, Triple> triples_;
  std::vector<GiNaC::ex> spin_, origin_;  // ω̇ (link axes) and P̈ (home axes) beyond those at ẏ = 0
  std::map<Place, GiNaC::ex> found_;
  std::map<std::pair<Frame, Frame>, GiNaC::ex> rotations_;
  GiNaC::ex identity_;
};

}  // namespace kanec::symbolic
