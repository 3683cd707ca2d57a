// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/generic/evaluate.inl"
#include "runtime/generic/system.inl"
#include "runtime/verify/precise_scalar.hpp"

namespace kanec::generic {

template class System<Precise>;
template class System<Dual<Precise>>;
template std::vector<Dual<Precise>> evaluate(const System<Dual<Precise>>&, std::string_view,
                                             const Arguments<Dual<Precise>>&);
template std::vector<Precise> evaluate(const System<Precise>&, std::string_view, const Arguments<Precise>&);

}  // namespace kanec::generic
