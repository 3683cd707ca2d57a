// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/description.hpp"
#include "generator/emit/header.hpp"
#include "generator/emit/signature.hpp"

namespace kanec::emit {
namespace {

std::string wrapper(const program::Program& program, const program::Function& function, const Used& used) {
  const ArgumentList list(program, function, !used.inputs.empty());
  const std::string arguments = list.values("*static_cast<const Prepared*>(prepared)",
                                            "model::Inputs<double>" + spread("u", used.inputs.size()), "out");
  return "void " + function.name +
         "(const void* prepared, [[maybe_unused]] double t, [[maybe_unused]] const double* x,\n"
         "    [[maybe_unused]] const double* y, [[maybe_unused]] const double* ydot, [[maybe_unused]] const double* u,\n"
         "    double* out) {\n  model::" + function.name + "(" + arguments + ");\n}\n\n";
}

}  // namespace

std::string emit_abi(const Model& model, const program::Program& program) {
  const Used read = used(*model.scene, program);
  std::string text = begin(*model.scene, "in double", "#include <new>\n\n#include \"abi.h\"\n");
  text += "using Prepared = model::Prepared<double>;\n\n"
          "void prepare([[maybe_unused]] const double* p, void* prepared) {\n  ::new (prepared) Prepared(model::prepare("
          "model::Parameters<double>" + spread("p", read.parameters.size()) + "));\n}\n\n";
  for (const program::Function& function : program.functions) text += wrapper(program, function, read);
  text += described(model, program, read, true);
  return text + "}  // namespace\n\n" + entry("kanec_model", "kanec_model_entry", "&description");
}

}  // namespace kanec::emit
