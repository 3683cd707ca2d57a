// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "generator/emit/description.hpp"
#include "generator/emit/header.hpp"
#include "generator/emit/signature.hpp"
#include "generator/emit/taylor.hpp"

namespace kanec::emit {
namespace {

std::string constant_of(const std::string& type, const std::string& name, const std::string& value) {
  return "  static constexpr " + type + " " + name + " = " + value + ";\n";
}

std::string truth(bool value) { return value ? "true" : "false"; }

// What evaluate() of runtime/lanes/batch.hpp asks of a function.
std::string traits(const program::Program& program, const program::Function& function, const Used& used) {
  const ArgumentList list(program, function, !used.inputs.empty());
  const Reads read = reads(program, function);
  std::string text = "struct " + function.name + " {\n";
  text += constant_of("int", "n_out", std::to_string(function.n_out));
  text += constant_of("bool", "reads_time", truth(read.time)) + constant_of("bool", "reads_x", truth(read.x)) +
          constant_of("bool", "reads_y", truth(read.y)) + constant_of("bool", "reads_ydot", truth(read.ydot)) +
          constant_of("bool", "reads_inputs", truth(list.takes_inputs()));
  return text +
         "  // by itself, however many call it: long functions are compiled once\n"
         "  __attribute__((noinline)) static void call(const Prepared& prepared, [[maybe_unused]] const Lane& t,\n"
         "      [[maybe_unused]] const Lane* x, [[maybe_unused]] const Lane* y, [[maybe_unused]] const Lane* ydot,\n"
         "      [[maybe_unused]] const Lane* u, Lane* out) noexcept {\n    model::" +
         function.name + "(" + list.values("prepared", "model::Inputs<Lane>" + spread("u", used.inputs.size()), "out") +
         ");\n  }\n};\n\n";
}

std::string rk4(const program::Function* rates) {
  if (rates == nullptr) return "constexpr const kanec_rk4* rk4 = nullptr;\n\n";
  return "const kanec_rk4 method = {" + rates->name + "::n_out,\n    kanec::lanes::batch::Rk4<Lane, Prepared, Sizes, " +
         rates->name + ">::steps};\nconstexpr const kanec_rk4* rk4 = &method;\n\n";
}

int most_results(const program::Program& program) {
  int most = 1;
  for (const program::Function& function : program.functions) most = std::max(most, static_cast<int>(function.n_out));
  return most;
}

}  // namespace

std::string emit_batch(const Model& model, const program::Program& program) {
  const Used read = used(*model.scene, program);
  std::string text = begin(*model.scene, "in lanes of KANEC_SCALAR (double), KANEC_LANES of them (as the target has)",
                           "#include \"rk4.hpp\"\n");
  text +=
      "#if !defined(KANEC_SCALAR)\n#define KANEC_SCALAR double\n#endif\n#if !defined(KANEC_LANES)\n"
      "#define KANEC_LANES kanec::lanes::native_lanes<KANEC_SCALAR>\n#endif\n"
      "using Lane = kanec::lanes::Lanes<KANEC_SCALAR, KANEC_LANES>;\nusing Prepared = model::Prepared<Lane>;\n\n"
      "struct Sizes {\n  [[maybe_unused]] static constexpr int nx = model::nx, ny = model::ny, n_inputs = "
      "model::n_inputs,\n"
      "      n_parameters = model::n_parameters, n_attitudes = " +
      std::to_string(attitudes(*model.scene).size()) + ";\n  [[maybe_unused]] static constexpr " +
      attitude_list(*model.scene) +
      "};\n\n"
      "struct Preparation {\n  static Prepared call([[maybe_unused]] const Lane* p) noexcept {\n    return "
      "model::prepare(model::Parameters<Lane>" +
      spread("p", read.parameters.size()) + ");\n  }\n};\n\n";
  for (const program::Function& function : program.functions) text += traits(program, function, read);
  text += "const kanec_evaluate_batch evaluate[] = {\n";
  for (const program::Function& function : program.functions)
    text += "    kanec::lanes::batch::evaluate<Lane, Prepared, Sizes, " + function.name + ">,\n";
  text += "    nullptr};\n\n" + rk4(rates(program)) + described(model, program, read, false) +
          "const kanec_batch batch = {\n    KANEC_ABI_VERSION, sizeof(kanec_batch), &description, Lane::size, "
          "sizeof(KANEC_SCALAR), sizeof(Prepared),\n    alignof(Lane), " +
          std::to_string(most_results(program)) +
          " * sizeof(Lane), kanec::lanes::batch::prepare<Lane, Prepared, Sizes, Preparation>,\n    evaluate, rk4};\n\n";
  return text + "}  // namespace\n\n" + entry("kanec_batch", "kanec_model_batch", "&batch");
}

}  // namespace kanec::emit
