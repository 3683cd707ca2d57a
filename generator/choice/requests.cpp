// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/choice/requests.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "generator/lower/derivatives.hpp"
#include "generator/lower/lower.hpp"
#include "generator/program/combined.hpp"
#include "generator/program/passes.hpp"
#include "generator/scene/place.hpp"
#include "generator/symbolic/derive.hpp"
#include "generator/symbolic/functions.hpp"
#include "runtime/base/error.hpp"

namespace kanec {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// What a scene that lacks this function is without; empty of a name that no scene has.
std::string lacking(const std::string& function) {
  if (function == "power" || function == "power_x" || function == "power_y" || function == "load_powers")
    return "applied loads";
  if (function == "events") return "events";
  if (function == "accelerations_u" || function == "input_matrix") return "inputs";
  return function == "driving_loads" ? "locked or prescribed coordinates" : "";
}

// What has to be there before a name can be: its parts, and what they are differentiated from.
struct Needed {
  std::vector<std::string> derived, whole, reduced;
};

Needed needed_for(const scene::Scene& scene, const std::vector<std::string>& names, symbolic::Derivatives way) {
  Needed needed;
  for (const std::string& name : names)
    for (const std::string& part : parts(name)) {
      if (const std::optional<lower::Derived> derived = lower::derived_function(scene, part)) {
        insert(needed.derived, part);
        for (const std::string& made_of : lower::parts_of(*derived, way)) insert(needed.reduced, made_of);
      } else {
        insert(symbolic::needs_whole_mechanism(part) ? needed.whole : needed.reduced, part);
      }
    }
  return needed;
}

void keep(program::Program& program, const std::vector<std::string>& names) {
  std::vector<program::Function> kept(names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const std::vector<std::string> of = parts(names[i]); of.size() > 1) kept[i] = program::combined(program, of);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (parts(names[i]).size() == 1) {
      const auto is_named = [&](const program::Function& function) { return function.name == names[i]; };
      kept[i] = std::move(*std::find_if(program.functions.begin(), program.functions.end(), is_named));
    }
  program.functions = std::move(kept);
}

}  // namespace

void insert(std::vector<std::string>& list, const std::string& name) {
  if (!contains(list, name)) list.push_back(name);
}

std::vector<std::string> parts(const std::string& name) {
  std::vector<std::string> result = {""};
  for (const char c : name)
    if (c == '+')
      result.emplace_back();
    else
      result.back() += c;
  return result;
}

std::vector<Available> available_functions(const scene::Scene& scene) {
  std::vector<Available> result;
  for (const symbolic::Function& function : symbolic::functions(scene))
    result.push_back({function.name, function.meaning, function.n_out, function.signature, function.usual});
  for (const lower::Derived& derived : lower::derived_functions(scene))
    result.push_back({derived.name, derived.meaning, derived.rows * derived.columns, derived.signature, false});
  return result;
}

std::optional<Fault> fault_of(const std::string& request, const std::vector<Available>& available) {
  std::vector<std::string> known, before;
  for (const Available& function : available) known.push_back(function.name);
  for (const std::string& part : parts(request)) {
    if (contains(before, part)) return Fault{scene::in_quotes(request), "each part once"};
    before.push_back(part);
    if (contains(known, part)) continue;
    if (const std::string what = lacking(part); !what.empty())
      return Fault{part + ", which a scene without " + what + " does not have", scene::one_of(known, "")};
    return Fault{scene::in_quotes(part), scene::one_of(known, part) + "; several joined by + are one"};
  }
  return std::nullopt;
}

std::vector<std::string> requested_functions(const scene::Scene& scene, const std::vector<std::string>& names) {
  const std::vector<Available> available = available_functions(scene);
  const std::vector<std::string>& requests = names.empty() ? scene.functions : names;
  std::vector<std::string> result;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (const std::optional<Fault> fault = fault_of(requests[i], available)) {
      if (names.empty() && i < scene.function_places.size())
        scene::fail(scene.function_places[i], fault->found, fault->allowed);
      throw InputError("function: found " + fault->found + "; allowed: " + fault->allowed);
    }
    insert(result, requests[i]);
  }
  if (result.empty())
    for (const Available& function : available)
      if (function.usual) result.push_back(function.name);
  return result;
}

program::Program program_of(const scene::Scene& scene, const std::vector<std::string>& names,
                            const symbolic::Way& way) {
  const Needed needed = needed_for(scene, names, way.derivatives);
  program::Program program;
  if (!needed.reduced.empty()) program = lower::lower(symbolic::derive(scene, needed.reduced, way));
  if (!needed.whole.empty()) {
    const symbolic::Way none{.reductions = {false, false, false, false, false}};
    program::Program whole = lower::lower(symbolic::derive(scene, needed.whole, none));
    program = needed.reduced.empty() ? std::move(whole) : program::joined(std::move(program), std::move(whole));
  }
  if (!needed.derived.empty()) program = program::share(program::simplify(std::move(program)));
  for (const lower::Derived& derived : lower::derived_functions(scene))
    if (contains(needed.derived, derived.name)) lower::append_derived(program, scene, derived, way.derivatives);
  keep(program, names);
  return program;
}

}  // namespace kanec
