// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/generic/evaluate.inl"

namespace kanec::generic {

std::vector<std::string_view> function_names() {
  std::vector<std::string_view> names;
  for (const auto& function : detail::functions<double>()) names.push_back(function.name);
  return names;
}

template std::vector<double> evaluate(const System<double>&, std::string_view, const Arguments<double>&);
template std::vector<long double> evaluate(const System<long double>&, std::string_view, const Arguments<long double>&);

}  // namespace kanec::generic
