// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/bench/variants.hpp"

#include <algorithm>

#include "generator/scene/place.hpp"
#include "runtime/base/error.hpp"

namespace kanec {
namespace {

// How a variant differs from what is emitted by default.
struct Known {
  const char* name;
  const char* meaning;
  void (*change)(Variant& variant);
};

const Known known[] = {
    {"composite", "accelerations from A by composite bodies",
     [](Variant& v) { v.build.algorithm = symbolic::Algorithm::composite; }},
    {"articulated", "accelerations joint by joint",
     [](Variant& v) { v.build.algorithm = symbolic::Algorithm::articulated; }},
    {"size", "loops over bodies where they take less code",
     [](Variant& v) { v.build.optimize = emit::Optimize::size; }},
    {"lanes", "double, as many states at once as the processor has lanes",
     [](Variant& v) { v.lanes = LaneArguments{}; }},
    {"float_lanes", "the same in float",
     [](Variant& v) {
       v.lanes = LaneArguments{"float", 0};
     }},
    {"g++", "compiled by g++", [](Variant& v) { v.build.compiler = "g++"; }},
    {"clang++", "compiled by clang++", [](Variant& v) { v.build.compiler = "clang++"; }},
};

const Known& find(const std::string& name) {
  std::vector<std::string> names = {"all"};
  for (const Known& one : known) {
    if (name == one.name) return one;
    names.push_back(one.name);
  }
  throw InputError("--variants: found " + scene::in_quotes(name) + "; allowed: " + scene::one_of(names, name));
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::vector<NamedVariant> variants_known() {
  std::vector<NamedVariant> list;
  for (const Known& one : known) list.push_back({one.name, one.meaning});
  return list;
}

std::vector<Variant> variants(const std::vector<std::string>& names, const BuildOptions& build) {
  for (const std::string& name : names)
    if (name != "all") find(name);
  std::vector<Variant> list = {{"emitted", build}};
  for (const Known& one : known) {
    if (!has(names, "all") && !has(names, one.name)) continue;
    list.push_back({one.name, build});
    one.change(list.back());
  }
  return list;
}

}  // namespace kanec
