// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/description.hpp"
#include "generator/emit/header.hpp"
#include "generator/emit/signature.hpp"
#include "generator/emit/taylor.hpp"

namespace kanec::emit {
namespace {

std::string wrapper(const program::Program& program, const program::Function& function, const Used& used) {
  const ArgumentList list(program, function, !used.inputs.empty());
  const std::string arguments = list.values("*static_cast<const Prepared*>(prepared)",
                                            "model::Inputs<double>" + spread("u", used.inputs.size()), "out");
  return "void " + function.name +
         "(const void* prepared, [[maybe_unused]] double t, [[maybe_unused]] const double* x,\n"
         "    [[maybe_unused]] const double* y, [[maybe_unused]] const double* ydot, [[maybe_unused]] const double* "
         "u,\n"
         "    double* out) {\n  model::" +
         function.name + "(" + arguments + ");\n}\n\n";
}

// The series of the file beside, where the compiler is told so.
std::string taylor(const program::Program& program, const Used& used) {
  const std::string none = "constexpr int n_taylor = 0;\nconstexpr const kanec_taylor* taylor = nullptr;\n";
  if (rates(program) == nullptr) return none + "\n";
  const std::string u = used.inputs.empty() ? "" : ", model::Inputs<T>" + spread("T(u", used.inputs.size(), ")");
  return "#if defined(KANEC_TAYLOR)\n"
         "template <class T, int N>\nstruct Series {\n  using Prepared = model::Prepared<T>;\n  using Work = "
         "model::Taylor<T, N>;\n"
         "  static void prepare([[maybe_unused]] const double* p, void* prepared) {\n    ::new (prepared) "
         "Prepared(model::prepare(model::Parameters<T>" +
         spread("T(p", used.parameters.size(), ")") +
         "));\n  }\n"
         "  static void coefficients(const void* prepared, double t, [[maybe_unused]] const double* u, int32_t order, "
         "void* z, void* work) {\n"
         "    (::new (work) Work)->coefficients(*static_cast<const Prepared*>(prepared), T(t)" +
         u +
         ", order, static_cast<T*>(z));\n  }\n"
         "  static constexpr kanec_taylor description = {sizeof(T), Work::size, N, sizeof(Prepared), sizeof(Work), "
         "alignof(Work), prepare,\n      coefficients};\n};\n"
         "constexpr int n_taylor = 2;\n"
         "constexpr kanec_taylor taylor[] = {Series<double, 24>::description, Series<long double, 32>::description};\n"
         "#else\n" +
         none + "#endif\n\n";
}

}  // namespace

std::string emit_abi(const Model& model, const program::Program& program) {
  const Used read = used(*model.scene, program);
  std::string text = begin(*model.scene, "in double",
                           "#include <new>\n\n#include \"abi.h\"\n#if defined(KANEC_TAYLOR)\n#include \"" +
                               model.scene->name + "_taylor.hpp\"\n#endif\n");
  text +=
      "using Prepared = model::Prepared<double>;\n\n"
      "void prepare([[maybe_unused]] const double* p, void* prepared) {\n  ::new (prepared) Prepared(model::prepare("
      "model::Parameters<double>" +
      spread("p", read.parameters.size()) + "));\n}\n\n";
  for (const program::Function& function : program.functions) text += wrapper(program, function, read);
  text += taylor(program, read);
  text += described(model, program, read, true);
  return text + "}  // namespace\n\n" + entry("kanec_model", "kanec_model_entry", "&description");
}

}  // namespace kanec::emit
