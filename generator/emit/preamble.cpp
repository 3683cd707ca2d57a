// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/preamble.hpp"

#include <algorithm>

#include "generator/emit/angles.hpp"
#include "generator/emit/calls.hpp"
#include "generator/emit/statements.hpp"
#include "generator/scene/spelling.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/base/text.hpp"

namespace kanec::emit {
namespace {

using scene::Coordinate;

// Wrapped; further lines begin with as many blanks behind the slashes.
std::string comment(const std::string& text, const std::string& indent = "") {
  std::string lines;
  for (const std::string& line : wrapped("// " + indent + text, "// " + indent)) lines += line + "\n";
  return lines;
}

std::string joined(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& item : list) text += (text.empty() ? "" : ", ") + item;
  return text;
}

std::string bodies(const scene::Scene& scene) {
  std::string text = "// bodies and their joints:\n";
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const int lower = scene.lower[k];
    text += comment(std::to_string(k + 1) + " " + fit::comment(scene.bodies[k].name) + " on " +
                        (lower == 0 ? "the inertial frame" : std::to_string(lower)) + ": " + scene.bodies[k].joint.kind,
                    "  ");
  }
  return text;
}

// Entries of one vector as "eps_1_1 .. eps_1_4".
std::string entries(const std::vector<std::string>& names) {
  const auto stem = [](const std::string& name) { return name.substr(0, name.rfind('_')); };
  std::vector<std::string> list;
  for (std::size_t i = 0; i < names.size();) {
    std::size_t end = i + 1;
    const bool has_component = std::count(names[i].begin(), names[i].end(), '_') > 1;
    while (has_component && end < names.size() && stem(names[end]) == stem(names[i])) ++end;
    list.push_back(end - i > 2 ? names[i] + no_break + ".." + no_break + names[end - 1] : names[i]);
    if (end - i == 2) list.push_back(names[i + 1]);
    i = end;
  }
  return joined(list);
}

// Coordinates that are no part of the state: "theta_3 = 0.5", "s_2_1 = 0.1*sin(t)".
std::vector<std::string> not_free(const scene::Scene& scene, Coordinate::Motion motion) {
  std::vector<std::string> list;
  const auto append = [&](const std::vector<Coordinate>& coordinates, const std::string& name) {
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      const Coordinate& coordinate = coordinates[i];
      if (coordinate.motion != motion) continue;
      const bool is_locked = motion == Coordinate::Motion::locked;
      list.push_back(name + (coordinates.size() > 1 ? "_" + std::to_string(i + 1) : "") + no_break + "=" + no_break +
                     (is_locked
                          ? shortest(coordinate.value)
                          : fit::comment(scene.expressions[static_cast<std::size_t>(coordinate.expression)].text)));
    }
  };
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const scene::Joint& joint = scene.bodies[k].joint;
    const std::string number = std::to_string(k + 1);
    if (joint.ball && joint.held && motion == Coordinate::Motion::locked) list.push_back("eps_" + number);
    if (!joint.ball) append(joint.turns, "theta_" + number);
  }
  for (std::size_t k = 0; k < scene.bodies.size(); ++k)
    append(scene.bodies[k].joint.slides, "s_" + std::to_string(k + 1));
  return list;
}

// What the letters mean that this model has.
std::string letters(const std::string& names) {
  const auto has = [&](const std::string& letter) {
    return (", " + names).find(", " + letter + "_") != std::string::npos;
  };
  std::string text;
  if (has("eps"))
    text += "//   eps       Euler parameters relative to the inertial frame, scalar last, of unit norm (4 a body)\n";
  if (has("theta")) text += "//   theta     angle of a joint about its axis [rad]\n";
  if (has("s")) text += "//   s         translation from the joint point, axes of the lower body [m]\n";
  if (has("omega")) text += "//   omega     absolute angular velocity, body axes [rad/s] (3)\n";
  if (has("thetadot")) text += "//   thetadot  rate of theta [rad/s]\n";
  if (has("sdot")) text += "//   sdot      rate of s [m/s]\n";
  return text;
}

std::string state(const scene::Scene& scene) {
  const std::string x = joined(coordinate_names(scene)), y = joined(speed_names(scene));
  std::string text = "//\n// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:\n";
  text += comment("x = (" + entries(coordinate_names(scene)) + ")", "  ");
  text += comment("y = (" + entries(speed_names(scene)) + ")", "  ");
  const auto locked = not_free(scene, Coordinate::Motion::locked);
  const auto prescribed = not_free(scene, Coordinate::Motion::prescribed);
  if (!locked.empty()) text += comment("locked: " + joined(locked), "  ");
  if (!prescribed.empty()) text += comment("prescribed: " + joined(prescribed), "  ");
  return text + letters(x + ", " + y);
}

std::string left_out(const Used& used) {
  std::vector<std::string> names;
  for (const scene::Named& named : used.left_out) names.push_back(named.name);
  return names.empty() ? ""
                       : comment("Parameters and inputs that nothing here reads are left out: " + joined(names) + ".");
}

std::string spellings(const Used& used) {
  std::vector<std::string> names;
  for (const auto* list : {&used.parameters, &used.inputs})
    for (const scene::Named& named : *list)
      if (const std::string name = scene::spelled(named.name); name != named.name)
        names.push_back(name + no_break + "for" + no_break + named.name);
  return names.empty() ? ""
                       : comment("Spelled otherwise, since they may be macros or keywords: " + joined(names) + ".");
}

std::string c_conventions(bool chooses, bool turns) {
  std::string text = std::string("No function allocates, branches") +
                     (chooses ? " (it may choose between two values)" : "") +
                     " or keeps a state; results must not overlap arguments. kanec_real is double, or where KANEC_REAL "
                     "is defined as float "
                     "before the include float.";
  if (turns)
    text +=
        " Cosines and sines of angles in double are those of cos_sin() below, with KANEC_LIBM_COS_SIN the library's.";
  return "// R takes inertial components to body components; a~ b = a x b; matrices are row-major.\n" + comment(text);
}

std::string conventions(const program::Program& program, bool turns, const Syntax& syntax) {
  const bool chooses = selects(program);
  const std::vector<std::string> calls = functions_called(program);
  const bool compares = chooses || std::any_of(calls.begin(), calls.end(),
                                               [](const std::string& name) { return name == "min" || name == "max"; });
  if (syntax.is_c()) return c_conventions(chooses, turns);
  std::string scalar =
      "T is the scalar: float, double, long double, or any type with + - * /, unary -, a constructor from double and a "
      "default one";
  if (compares) scalar += ", <";
  if (chooses) scalar += " (where that gives no bool, select(condition, a, b) as well)";
  if (!calls.empty()) scalar += ", and of its own or by conversion " + joined(calls);
  if (turns)
    scalar +=
        ". Cosines and sines of angles in double are those of cos_sin() below, with KANEC_LIBM_COS_SIN the library's";
  return "// R takes inertial components to body components; a~ b = a x b; matrices are row-major.\n" +
         comment(std::string("No function allocates, throws, branches") +
                 (chooses ? " (it may choose between two values)" : "") +
                 " or keeps a state; results must not overlap arguments. " + scalar + ".");
}

std::string operations(const program::Program& program, const std::vector<program::Ledger>& costs) {
  std::size_t width = 24;
  for (const program::Function& function : program.functions) width = std::max(width, function.name.size() + 2);
  std::string text = "//\n// operations of one call (adds + multiplies + divides):\n";
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const std::string& name = program.functions[i].name;
    text += "//   " + name + std::string(width - name.size(), ' ') + std::to_string(costs[i].operations()) + " (" +
            program::text(costs[i]) + ")\n";
  }
  return text;
}

}  // namespace

std::string preamble(const Model& model, const program::Program& program, const Used& used,
                     const std::vector<program::Ledger>& costs) {
  const scene::Scene& scene = *model.scene;
  const std::string source = model.source.empty() ? "" : " of " + fit::comment(model.source);
  return "// SPDX-License-Identifier: BSD-3-Clause\n" +
         comment(scene.name + ": equations of motion of " + std::to_string(size(scene)) + " rigid " +
                 (size(scene) == 1 ? "body" : "bodies") + ", made by kanec " + model.version +
                 ". Not to be edited by hand.") +
         "//\n" + comment("model " + model.hash + source + "; " + model.options) + bodies(scene) + state(scene) +
         left_out(used) + spellings(used) +
         conventions(program, takes_turns(model, program) && model.optimize != Optimize::size, Syntax(model)) +
         operations(program, costs);
}

}  // namespace kanec::emit
