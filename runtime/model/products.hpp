// The files that are emitted of a scene. Not: what stands in them (generator/emit), nor where they are written.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/pipeline.hpp"

namespace kanec {

struct Products {
  emit::Language language = emit::Language::cpp;
  bool abi = false;     // what a shared library is made of, beside the header
  bool taylor = false;  // the Taylor series of the motion
};

// Throws InputError for what there is in C++ alone.
void check_products(const Products& products);

// The header first: "six_body.hpp", "six_body_abi.cpp", "abi.h", "six_body_taylor.hpp".
std::vector<std::string> product_names(const std::string& model, const Products& products);

// In the order of their names.
std::vector<std::string> product_texts(const Generated& generated, const Products& products);

}  // namespace kanec
