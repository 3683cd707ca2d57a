// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/products.hpp"

#include "kanec_abi_text.hpp"
#include "runtime/base/error.hpp"

namespace kanec {

void check_products(const Products& products) {
  if (products.language != emit::Language::c) return;
  const auto refuse = [](const std::string& option, const std::string& why) {
    throw InputError("language c: found it beside " + option + "; allowed: cpp, since " + why);
  };
  if (products.abi) refuse("abi", "the library is made of the C++ header; C programs link it by abi.h");
  if (products.taylor) refuse("taylor", "the series is a class template");
}

std::vector<std::string> product_names(const std::string& model, const Products& products) {
  std::vector<std::string> names = {model + (products.language == emit::Language::c ? ".h" : ".hpp")};
  if (products.abi) names.insert(names.end(), {model + "_abi.cpp", "abi.h"});
  if (products.taylor) names.push_back(model + "_taylor.hpp");
  return names;
}

std::vector<std::string> product_texts(const Generated& generated, const Products& products) {
  std::vector<std::string> texts = {generated.header};
  if (products.abi) texts.insert(texts.end(), {generated.abi, abi_text});
  if (products.taylor) texts.push_back(generated.taylor);
  return texts;
}

}  // namespace kanec
