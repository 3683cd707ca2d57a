// Accelerations along the tree by differentiating the velocities once more. Not here: what drives them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/symbolic/derivation.hpp"

namespace kanec::symbolic {

// Accelerations less gravity, by link; gravity enters as an acceleration −g of the inertial frame, exact since every
// v_K then changes by the same g t. In home axes.
class AccelerationChain {
 public:
  // `rates` gives the rates of the speeds. beside_rest: by link, whether the same letters stand in the same function
  // for what they are at ẏ = 0; they are called solved here, "U_solved_1".
  AccelerationChain(Derivation& derivation, Rates rates, std::vector<bool> beside_rest = {});

  // The next link, from 1 on: ω̇ and U, then P̈. A known P̈ (home axes) stands for what the lower link gives.
  void add_spin(int link);
  void add_origin(int link, const GiNaC::ex* known = nullptr);
  // P̈ as the lower link and the joint give it, axes of the lower link, not yet factored.
  GiNaC::ex joint_point(int link) const;

  // a = v̇ − g of the mass centre, home axes.
  GiNaC::ex centre(int link);
  // With common factors taken out and U of the link by its name.
  GiNaC::ex with_spin(const GiNaC::ex& acceleration, int link) const;
  // a without its part P̈; home axes.
  GiNaC::ex about_origin(int link) const;
  // Of a point at `place` from the origin, link axes; home axes, less gravity.
  GiNaC::ex of_point(int link, const GiNaC::ex& place) const;

  const GiNaC::ex& spin(int link) const { return spin_[static_cast<std::size_t>(link)]; }      // U
  const GiNaC::ex& origin(int link) const { return origin_[static_cast<std::size_t>(link)]; }  // P̈
  Rates& rates() { return rates_; }

 private:
  GiNaC::ex define(const std::string& name, const std::string& latex, int link, const GiNaC::ex& value,
                   const std::string& meaning);

  Derivation& derivation_;
  Rates rates_;
  std::vector<bool> beside_rest_;
  std::vector<GiNaC::ex> spin_, origin_;
};

// All links.
AccelerationChain derive_acceleration_chain(Derivation& derivation, const Rates& rates);

}  // namespace kanec::symbolic
