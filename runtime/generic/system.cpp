// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/generic/system.inl"

namespace kanec::generic {

template class System<double>;
template class System<long double>;
template class System<Dual<double>>;
template class System<Dual<long double>>;

}  // namespace kanec::generic
