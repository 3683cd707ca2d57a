// Several lambdas as one visitor of a Node. Not: any visitor.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace kanec::program {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

}  // namespace kanec::program
