// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/generic/evaluate.inl"

namespace kanec::generic {

template std::vector<Dual<double>> evaluate(const System<Dual<double>>&, std::string_view,
                                            const Arguments<Dual<double>>&);
template std::vector<Dual<long double>> evaluate(const System<Dual<long double>>&, std::string_view,
                                                 const Arguments<Dual<long double>>&);

}  // namespace kanec::generic
