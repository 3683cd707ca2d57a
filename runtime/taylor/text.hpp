// The text of products.hpp, of which emitted Taylor series hold a part. Not: the series (generator/emit/taylor.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace kanec {

std::string taylor_products_text();

}  // namespace kanec
