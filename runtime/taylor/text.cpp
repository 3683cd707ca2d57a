// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/taylor/text.hpp"

#include "kanec_taylor_text.hpp"

namespace kanec {

std::string taylor_products_text() { return taylor_products; }

}  // namespace kanec
