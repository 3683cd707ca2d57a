// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/emit/both_languages.hpp"

#include <cstdio>

#include "generator/emit/signature.hpp"
#include "generator/emit/used.hpp"
#include "generator/scene/spelling.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/process.hpp"
#include "tests/emit/driver.hpp"

namespace kanec::test {
namespace {

constexpr int states_a_model = 4;

// "  p.mu = (real)in[3];\n" for the fields of a struct, from all numbers of the scene.
std::string fields(const std::string& variable, std::size_t begin, const std::vector<scene::Named>& all,
                   const std::vector<scene::Named>& used) {
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const scene::Named& named : used)
      if (named.name == all[i].name)
        text +=
            "  " + variable + "." + scene::spelled(named.name) + " = (real)in[" + std::to_string(begin + i) + "];\n";
  return text;
}

std::string array(const std::string& name, std::size_t begin, int count) {
  const std::string n = std::to_string(count);
  return "  real " + name + "[" + std::to_string(std::max(count, 1)) + "];\n  for (int i = 0; i < " + n + "; ++i) " +
         name + "[i] = (real)in[" + std::to_string(begin) + " + i];\n  (void)" + name + ";\n";
}

// The part of a function that is the same in both languages; `of`: "&" where structs are given by pointers.
std::string calls(const scene::Scene& scene, const Generated& generated, const emit::Used& used,
                  const std::string& prefix, const std::string& of) {
  const std::size_t nx = static_cast<std::size_t>(n_coordinates(scene)), ny = static_cast<std::size_t>(n_speeds(scene));
  const std::size_t x = scene.parameters.size(), y = x + nx, ydot = y + ny, u = ydot + ny, t = u + scene.inputs.size();
  std::string text = fields("p", 0, scene.parameters, used.parameters) + fields("u", u, scene.inputs, used.inputs) +
                     "  const real t = (real)in[" + std::to_string(t) + "];\n  (void)t;\n" +
                     array("x", x, n_coordinates(scene)) + array("y", y, n_speeds(scene)) +
                     array("ydot", ydot, n_speeds(scene));
  for (const program::Function& function : generated.program.functions) {
    const emit::ArgumentList list(generated.program, function, !used.inputs.empty());
    const std::string n = std::to_string(function.n_out);
    text += "  {\n    real r[" + n + "];\n    for (int i = 0; i < " + n + "; ++i) r[i] = 7;\n    " + prefix +
            function.name + "(" + list.values(of + "c", of + "u", "r") + ");\n    for (int i = 0; i < " + n +
            "; ++i) *out++ = (double)r[i];\n  }\n";
  }
  return text;
}

std::vector<double> numbers(const Sample& sample) {
  const program::Arguments<long double> at = arguments<long double>(sample);
  std::vector<double> all;
  for (const auto* list : {&at.parameters, &at.x, &at.y, &at.ydot, &at.inputs})
    for (const long double value : *list) all.push_back(static_cast<double>(value));
  all.push_back(0.7);  // t
  return all;
}

std::string hexadecimal(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%a", value);
  return text;
}

std::string said(const ProcessResult& result) {
  return result.status == 0 ? result.output : result.output + "exit status " + std::to_string(result.status);
}

}  // namespace

std::vector<std::string> strict_c_flags() {
  return {"-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Wshadow", "-Werror"};
}

void BothLanguages::add(const scene::Scene& scene, const Generated& cpp, const Generated& c, std::uint64_t seed) {
  write_file(folder_.path() / (c.name + ".h"), c.header);
  write_file(folder_.path() / (cpp.name + ".hpp"), cpp.header);
  const emit::Used used = emit::used(scene, c.program);
  const std::string &name = c.name,
                    inputs = used.inputs.empty() ? "" : "  " + name + "_Inputs u = " + name + "_default_inputs();\n";
  Pair pair{name,
            "  " + name + "_Parameters p = " + name + "_default_parameters();\n" + inputs,
            "  model::Parameters<real> p;\n" + std::string(used.inputs.empty() ? "" : "  model::Inputs<real> u;\n"),
            {},
            {}};
  // both are prepared behind what changes the parameters
  const std::string c_calls = calls(scene, c, used, name + "_", "&"),
                    cpp_calls = calls(scene, cpp, used, "model::", "");
  const std::size_t begin_c = c_calls.find("  const real t = "), begin_cpp = cpp_calls.find("  const real t = ");
  pair.c += c_calls.substr(0, begin_c) + "  const " + name + "_Prepared c = " + name + "_prepare(&p);\n" +
            c_calls.substr(begin_c);
  pair.cpp += cpp_calls.substr(0, begin_cpp) + "  const model::Prepared<real> c = model::prepare(p);\n" +
              cpp_calls.substr(begin_cpp);
  for (const program::Function& function : c.program.functions)
    for (int i = 0; i < function.n_out; ++i) pair.results.push_back(function.name + "[" + std::to_string(i) + "]");
  Random random(seed);
  for (int i = 0; i < states_a_model; ++i) pair.arguments.push_back(numbers(sample_of(scene, random)));
  models_.push_back(std::move(pair));
}

std::string BothLanguages::c_file(const std::string& real, const std::string& name) const {
  std::string text = "#define KANEC_REAL " + real + "\n";
  for (const Pair& model : models_) text += "#include \"" + model.name + ".h\"\n";
  text += "#ifdef __cplusplus\nextern \"C\" {\n#endif\ntypedef " + real + " real;\n";
  for (const Pair& model : models_) {
    const std::string head = "void c_" + real + "_" + model.name + "(const double* in, double* out)";
    text += head + ";\n" + head + " {\n" + model.c + "}\n";
  }
  const std::string file = (folder_.path() / name).string();
  write_file(file, text + "#ifdef __cplusplus\n}\n#endif\n");
  return file;
}

std::string BothLanguages::complaints(const std::vector<std::string>& compiler_and_flags,
                                      const std::string& real) const {
  const bool is_cpp = compiler_and_flags[0].ends_with("++");
  std::vector<std::string> command = compiler_and_flags;
  command.push_back("-fsyntax-only");
  command.push_back(c_file(real, real + (is_cpp ? "_side.cpp" : "_side.c")));
  return said(run_process(command));
}

std::string BothLanguages::differences(const std::string& c_compiler, const std::string& cpp_compiler) const {
  std::string text = "#include <cstdio>\n#include <cstring>\n";
  for (const Pair& model : models_) text += "#include \"" + model.name + ".hpp\"\n";
  text += R"(
static void compare(const char* what, const double* c, const double* cpp, const char* const* names, int n) {
  for (int i = 0; i < n; ++i)
    if (std::memcmp(c + i, cpp + i, sizeof *c) != 0) std::printf("%s %s: C %a, C++ %a\n", what, names[i], c[i], cpp[i]);
}
)";
  std::string main = "int main() {\n";
  for (const Pair& model : models_) {
    const std::string n = std::to_string(model.results.size());
    text += "namespace of_" + model.name + " {\nnamespace model = kanec::" + model.name +
            ";\ntemplate <class real>\nvoid cpp([[maybe_unused]] const double* in, double* out) {\n" + model.cpp +
            "}\n" + "const char* const names[] = {";
    for (const std::string& result : model.results) text += "\"" + result + "\", ";
    text += "};\nconst double arguments[][" + std::to_string(model.arguments[0].size()) + "] = {\n";
    for (const std::vector<double>& list : model.arguments) {
      text += "  {";
      for (const double value : list) text += hexadecimal(value) + ", ";
      text += "},\n";
    }
    text += "};\ndouble c[" + n + "], d[" + n + "];\n}\n";
    for (const std::string real : {"double", "float"}) {
      text += "extern \"C\" void c_" + real + "_" + model.name + "(const double*, double*);\n";
      main += "  for (const auto& in : of_" + model.name + "::arguments) {\n    c_" + real + "_" + model.name +
              "(in, of_" + model.name + "::c);\n    of_" + model.name + "::cpp<" + real + ">(in, of_" + model.name +
              "::d);\n    compare(\"" + model.name + " " + real + "\", of_" + model.name + "::c, of_" + model.name +
              "::d, of_" + model.name + "::names, " + n + ");\n  }\n";
    }
  }
  const std::string file = (folder_.path() / "main.cpp").string(), program = (folder_.path() / "main").string();
  write_file(file, text + main + "}\n");
  std::vector<std::string> objects;
  for (const std::string real : {"double", "float"}) {
    objects.push_back((folder_.path() / (real + ".o")).string());
    const ProcessResult made = run_process(
        {c_compiler, "-std=c99", "-O1", "-ffp-contract=off", "-c", c_file(real, real + ".c"), "-o", objects.back()});
    if (made.status != 0) return said(made);
  }
  const ProcessResult made = run_process(
      {cpp_compiler, "-std=c++17", "-O1", "-ffp-contract=off", file, objects[0], objects[1], "-o", program, "-lm"});
  return made.status != 0 ? said(made) : said(run_process({program}));
}

}  // namespace kanec::test
