// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/language.hpp"

#include "generator/emit/statements.hpp"

namespace kanec::emit {
namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace

Syntax::Syntax(const Model& model)
    : language_(model.language), model_(is_c() ? model.scene->name + "_" : ""), prefix_(model_) {}

// C++: by the scalar's own functions as well, and whatever macros are called min and max. C: macros that follow the
// scalar; what the library has no such function for is the model's.
std::string Syntax::call(const std::string& function) const {
  const bool is_compared = function == "min" || function == "max";
  if (!is_c()) return function + (is_compared ? " KANEC_CALL" : "");
  return (is_compared || function == "select" || function == "cos_sin" ? model_ : "kanec_") + function;
}

Syntax Syntax::within(const std::string& space) const {
  Syntax inner = *this;
  if (is_c()) inner.prefix_ += space + "_";
  return inner;
}

std::string Syntax::from_outside(const std::string& space, const std::string& name) const {
  return is_c() ? prefix_ + space + "_" + name : space + "::" + name;
}

std::string Syntax::given(const std::string& type, const std::string& name) const {
  return "const " + written(type, name);
}

std::string Syntax::unused(const std::vector<std::string>& names, const std::string& indent) const {
  if (!is_c() || names.empty()) return "";
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "(void)" : ", (void)") + name;
  return joined(wrapped(indent + list + ";", indent + "    "));
}

std::string Syntax::opening(const std::string& result, const std::string& name, const std::string& parameters,
                            const std::vector<std::string>& unused_names, bool apart) const {
  if (is_c())
    return joined(wrapped(
               (apart ? "KANEC_APART " : "static inline ") + result + " " + global(name) + "(" + parameters + ") {",
               "    ")) +
           unused(unused_names);
  return "template <class T>\n" +
         joined(wrapped((apart ? "[[gnu::noinline]] " : "") + result + " " + name + "(" + parameters + ") noexcept {",
                        "    "));
}

std::string Syntax::constants(const std::string& list) const {
  if (is_c()) return joined(wrapped("enum { " + list + no_break + "};", "    "));
  return joined(wrapped("inline constexpr int " + list + ";", "    "));
}

std::string Syntax::table(const std::string& type, const std::string& name, const std::string& sizes) const {
  return (is_c() ? "static const " : "inline constexpr ") + type + " " + global(name) + sizes + " = ";
}

std::string Syntax::open_struct(const std::string& name) const {
  return is_c() ? "typedef struct " + prefix_ + name + " {\n" : "template <class T>\nstruct " + name + " {\n";
}

}  // namespace kanec::emit
