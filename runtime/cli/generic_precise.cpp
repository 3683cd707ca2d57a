// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/precise_scalar.hpp"
#include "runtime/generic/evaluate.inl"
#include "runtime/generic/system.inl"

namespace kanec::generic {

using cli::Precise;

template class System<Precise>;
template class System<Dual<Precise>>;
template std::vector<Dual<Precise>> evaluate(const System<Dual<Precise>>&, std::string_view,
                                             const Arguments<Dual<Precise>>&);
template std::vector<Precise> evaluate(const System<Precise>&, std::string_view, const Arguments<Precise>&);

}  // namespace kanec::generic
