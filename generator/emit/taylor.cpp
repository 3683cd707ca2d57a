// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/taylor.hpp"

#include "generator/emit/calls.hpp"
#include "generator/emit/check_code.hpp"
#include "generator/emit/marked.hpp"
#include "generator/emit/prepare.hpp"
#include "generator/emit/recursions.hpp"
#include "generator/emit/statements.hpp"
#include "generator/scene/spelling.hpp"
#include "runtime/taylor/text.hpp"

namespace kanec::emit {
namespace {

std::string products_text(const std::string& list) {
  std::string text = "  static constexpr kanec_series::Product products[] = {\n";
  for (const std::string& line : wrapped("     " + list + " {0, 0, 0, 0}", "      ")) text += line + "\n";
  return text + "  };\n  static constexpr int n_products = sizeof products / sizeof *products - 1;\n\n";
}

std::string head(const Model& model) {
  const std::string& name = model.scene->name;
  return "// SPDX-License-Identifier: BSD-3-Clause\n// " + name + ": Taylor series of its motion, made by kanec " +
         model.version + ". Not to be edited by hand.\n//\n// model " + model.hash + "; stands beside " + name +
         ".hpp, which says what the state is\n#pragma once\n\n#include <cstdint>\n#include <cstring>\n\n#include \"" +
         name + ".hpp\"\n\n" + between_marks(taylor_products_text()) + "\n";
}

constexpr const char* meaning =
    R"(// Series in the time since t of z: x, y, and where the model has `power` the work of its loads; inputs are held. Of order
// N at most; coefficient k of entry i stands at z[k * size + i], so that z has (order + 1) * size entries. Coefficient k of a result of the rates follows from
// coefficients 0 ... k of what it is made of: of sums by itself; of products from what products of earlier coefficients
// have added up to, s, and the newest coefficient of either factor times the value, v, of the other.
)";

// `u`: ", u" where the model has inputs.
std::string run_text(const std::string& size, const std::string& inputs, const std::string& u) {
  return "template <class T, int N>\nclass Taylor {\n public:\n  static constexpr int size = " + size +
         ";\n\n  // The state stands in z[0] ... z[size - 1]. 1 <= order <= N.\n"
         "  void coefficients(const Prepared<T>& c, T t" +
         inputs +
         ", int order, T* z) noexcept {\n"
         "    for (auto& row : s)\n      for (T& entry : row) entry = T(0);\n"
         "    for (auto& row : f)\n      for (T& entry : row) entry = T(0);\n"
         "    values(c, t" +
         u +
         ", z, z + size);\n"
         "    for (int i = 0; i < F::count; ++i) v[i] = now[i];\n"
         "    for (int k = 1; k < order; ++k) {\n      z += size;\n      next(c" +
         u +
         ", k, z, z + size);\n"
         "      for (int i = 0; i < size; ++i) z[size + i] /= T(k + 1);\n"
         "      kanec_series::add_products<T, stride>(products, n_products, F::count, k, order, now, f, s);\n    }\n"
         "  }\n\n private:\n";
}

std::string class_text(const RecursionText& recursions, std::size_t size, bool has_inputs) {
  const std::string inputs = has_inputs ? ", [[maybe_unused]] const Inputs<T>& u" : "";
  std::string functions;
  for (const std::string& function : recursions.functions)
    if (function != "min" && function != "max")
      functions += (functions.empty() ? "    using std::" : ", std::") + function;
  if (!functions.empty()) functions += ";\n";
  return meaning + run_text(std::to_string(size), inputs, has_inputs ? ", u" : "") + recursions.factors +
         recursions.sums + "  // sum, factors, sign\n" + products_text(recursions.products) +
         "  // Values: z -> zdot.\n  void values([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T& t" +
         inputs + ",\n              [[maybe_unused]] const T* z, T* zdot) noexcept {\n" + functions +
         recursions.values +
         "  }\n\n  // Coefficient k >= 1 of everything: z -> zdot.\n"
         "  void next([[maybe_unused]] const Prepared<T>& c" +
         inputs + ", [[maybe_unused]] int k,\n            [[maybe_unused]] const T* z, T* zdot) noexcept {\n" +
         functions + "    [[maybe_unused]] const T n = T(k);\n" + recursions.coefficients +
         "  }\n\n  static constexpr int stride = N + 1 + kanec_series::group;\n"
         "  T now[F::count + 1], v[F::count + 1];  // coefficient k of each factor, and its value\n"
         "  T f[F::count + 1][stride], s[S::count + 1][stride];\n};\n";
}

}  // namespace

const program::Function* rates(const program::Program& program) {
  const program::Function* found = nullptr;
  for (const program::Function& function : program.functions) {
    if (function.name == "kinematics_and_accelerations" && found == nullptr) found = &function;
    if (function.name == "kinematics_and_accelerations_and_power") found = &function;
  }
  return found;
}

std::string emit_taylor(const Model& model, const program::Program& program) {
  const program::Function* function = rates(program);
  if (function == nullptr || function->outputs.empty()) return "";
  const scene::Scene& scene = *model.scene;
  const Preparation preparation = emit_prepare(used(scene, program), program, program::stages(program), Syntax());
  const RecursionText recursions = recursion_text(program, *function, preparation.named);
  const std::string code = "namespace kanec::" + scene::spelled(scene.name) + " {\n\n" +
                           (recursions.chooses && !selects(program) ? selection(Syntax()) : "") +
                           class_text(recursions, function->outputs.size(), preparation.named.has_inputs) +
                           "\n}  // namespace kanec::" + scene::spelled(scene.name) + "\n";
  // the header's names, and members of the class that its functions stand before
  check_code(code, {"kanec_series", "Prepared", "Inputs", "select", "values", "next", "F", "S", "products",
                    "n_products", "stride", "now", "v", "f", "s", "min", "max"});
  return head(model) + code;
}

}  // namespace kanec::emit
