// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/requests.hpp"

#include <algorithm>
#include <utility>

#include "generator/lower/derivatives.hpp"
#include "generator/lower/lower.hpp"
#include "generator/program/combined.hpp"
#include "generator/program/passes.hpp"
#include "generator/symbolic/derive.hpp"
#include "generator/symbolic/functions.hpp"
#include "runtime/base/error.hpp"

namespace kanec {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

void insert(std::vector<std::string>& list, const std::string& name) {
  if (!contains(list, name)) list.push_back(name);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// What has to be there before a name can be: its parts, and what they are differentiated from.
struct Needed {
  std::vector<std::string> derived, whole, reduced;
};

Needed needed_for(const scene::Scene& scene, const std::vector<std::string>& names, symbolic::Derivatives way) {
  const std::vector<lower::Derived> derived = lower::derived_functions(scene);
  Needed needed;
  for (const std::string& name : names)
    for (const std::string& part : parts(name)) {
      const auto found = std::find_if(derived.begin(), derived.end(), [&](const auto& d) { return d.name == part; });
      if (found != derived.end()) {
        insert(needed.derived, part);
        for (const std::string& made_of : lower::parts_of(*found, way)) insert(needed.reduced, made_of);
      } else {
        insert(symbolic::needs_whole_mechanism(part) ? needed.whole : needed.reduced, part);
      }
    }
  return needed;
}

void keep(program::Program& program, const std::vector<std::string>& names) {
  std::vector<program::Function> kept;
  for (const std::string& name : names) {
    const std::vector<std::string> of = parts(name);
    if (of.size() > 1) {
      kept.push_back(program::combined(program, of));
      continue;
    }
    const auto found =
        std::find_if(program.functions.begin(), program.functions.end(), [&](const auto& f) { return f.name == name; });
    if (found == program.functions.end()) throw InternalError("no function " + name + " in the program");
    kept.push_back(*found);
  }
  program.functions = std::move(kept);
}

}  // namespace

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

std::vector<std::string> requested_functions(const scene::Scene& scene, const std::vector<std::string>& names) {
  const std::vector<Available> available = available_functions(scene);
  std::vector<std::string> known, result;
  for (const Available& function : available) known.push_back(function.name);
  for (const std::string& name : names.empty() ? scene.functions : names) {
    std::vector<std::string> before;
    for (const std::string& part : parts(name)) {
      if (!contains(known, part))
        throw InputError("no function '" + part + "' in this model; it has: " + listed(known));
      if (contains(before, part)) throw InputError("function '" + part + "' stands twice in '" + name + "'");
      before.push_back(part);
    }
    insert(result, name);
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
    const symbolic::Way none{.reductions = {false, false, false, false}};
    const program::Program whole = lower::lower(symbolic::derive(scene, needed.whole, none));
    program = needed.reduced.empty() ? whole : program::joined(std::move(program), whole);
  }
  if (!needed.derived.empty()) program = program::share(program::simplify(program));
  for (const lower::Derived& derived : lower::derived_functions(scene))
    if (contains(needed.derived, derived.name)) lower::append_derived(program, scene, derived, way.derivatives);
  keep(program, names);
  return program;
}

}  // namespace kanec
