// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/emit/driver.hpp"

#include <cstdio>
#include <sstream>
#include <stdexcept>

#include "generator/emit/signature.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/process.hpp"

namespace kanec::test {
namespace {

// The header first: nothing before it may help it.
const char* const prologue = R"(
#include <cstdio>
#include <type_traits>
#include <vector>

static long adds, multiplies, divides, negations;

// A user's own scalar: explicit from double, + - * /, and no more.
struct Counted {
  Counted() = default;
  explicit Counted(double v) : value(v) {}
  double value = 0;
};
inline Counted operator-(const Counted& a) { ++negations; return Counted(-a.value); }
inline Counted operator+(const Counted& a, const Counted& b) { ++adds; return Counted(a.value + b.value); }
inline Counted operator-(const Counted& a, const Counted& b) { ++adds; return Counted(a.value - b.value); }
inline Counted operator*(const Counted& a, const Counted& b) { ++multiplies; return Counted(a.value * b.value); }
inline Counted operator/(const Counted& a, const Counted& b) { ++divides; return Counted(a.value / b.value); }

inline void print(double v) { std::printf(" %a", v); }
inline void print(long double v) { std::printf(" %La", v); }
inline void print(const Counted& v) { print(v.value); }

static std::vector<long double> numbers(int n) {
  std::vector<long double> list(static_cast<std::size_t>(n));
  for (long double& v : list)
    if (std::scanf("%La", &v) != 1) std::printf("input ends early\n");
  return list;
}

template <class T>
std::vector<T> as(const std::vector<long double>& list) {
  std::vector<T> result;
  for (const long double v : list) {
    if constexpr (std::is_arithmetic_v<T>)
      result.push_back(static_cast<T>(v));
    else
      result.push_back(T(static_cast<double>(v)));
  }
  return result;
}

template <class T, class Call>
void report(const char* scalar, const char* function, int n_out, Call call) {
  std::vector<T> out(static_cast<std::size_t>(n_out), T(12345.0));
  adds = multiplies = divides = negations = 0;
  call(out.data());
  std::printf("%s %s %ld %ld %ld %ld", scalar, function, adds, multiplies, divides, negations);
  for (const T& v : out) print(v);
  std::printf("\n");
}
)";

std::string fields(const std::string& variable, const std::string& list, const std::vector<scene::Named>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += "  " + variable + "." + names[i].name + " = " + list + "[" + std::to_string(i) + "];\n";
  return text;
}

std::string type_of(const std::string& scalar) { return scalar == "counted" ? "Counted" : scalar; }

std::string key(const std::string& scalar, const std::string& function) {
  return (scalar == "long double" ? "long_double" : scalar) + " " + function;
}

}  // namespace

std::vector<std::string> strict_flags() {
  return {"-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"};
}

Driver::Driver(const Sample& sample, const Generated& generated) : sample_(sample), generated_(generated) {
  write_file(folder_.path() / (generated.name + ".hpp"), generated.header);
}

std::string Driver::call(const program::Function& function) const {
  const program::Signature& signature = function.signature;
  std::string arguments = "c";
  if (signature.x) arguments += ", x.data()";
  if (signature.y) arguments += ", y.data()";
  if (signature.ydot) arguments += ", ydot.data()";
  if (signature.inputs) arguments += ", u";
  return "  report<T>(scalar, \"" + function.name + "\", " + std::to_string(function.n_out) +
         ", [&](T* out) { model::" + function.name + "(" + arguments + ", out); });\n";
}

std::string Driver::source(const std::vector<std::string>& scalars) const {
  const scene::Scene& scene = sample_.scene;
  std::string text =
      "#include \"" + generated_.name + ".hpp\"\n" + prologue + "\nnamespace model = kanec::" + generated_.name +
      ";\n\ntemplate <class T>\nvoid run(const char* scalar, const std::vector<long double>& list) {\n"
      "  const std::vector<T> all = as<T>(list);\n  std::size_t at = 0;\n"
      "  const auto take = [&](int n) {\n    const auto first = all.begin() + static_cast<std::ptrdiff_t>(at);\n"
      "    at += static_cast<std::size_t>(n);\n    return std::vector<T>(first, first + n);\n  };\n"
      "  const std::vector<T> parameters = take(model::n_parameters), x = take(model::nx), y = take(model::ny);\n"
      "  const std::vector<T> ydot = take(model::ny), inputs = take(model::n_inputs);\n"
      "  model::Parameters<T> p;\n  model::Inputs<T> u;\n";
  text += fields("p", "parameters", scene.parameters) + fields("u", "inputs", scene.inputs);
  text += "  report<T>(scalar, \"prepare\", 0, [&](T*) { model::prepare(p); });\n";
  text += "  const model::Prepared<T> c = model::prepare(p);\n  static_cast<void>(u);\n";
  for (const program::Function& function : generated_.program.functions) text += call(function);
  text +=
      "}\n\nint main() {\n  const auto list = numbers(model::n_parameters + model::nx + 2 * model::ny + "
      "model::n_inputs);\n";
  for (const std::string& scalar : scalars)
    text +=
        "  run<" + type_of(scalar) + ">(\"" + key(scalar, "").substr(0, key(scalar, "").size() - 1) + "\", list);\n";
  return text + "}\n";
}

std::string Driver::compile(const std::string& compiler, const std::vector<std::string>& flags,
                            const std::vector<std::string>& scalars) {
  const std::string main = (folder_.path() / "main.cpp").string();
  write_file(main, source(scalars));
  std::vector<std::string> command = {compiler};
  for (const auto& list : {strict_flags(), flags}) command.insert(command.end(), list.begin(), list.end());
  for (const std::string& word : {main, std::string("-o"), (folder_.path() / "main").string()}) command.push_back(word);
  const ProcessResult result = run_process(command);
  return result.status == 0 ? result.output : "status " + std::to_string(result.status) + "\n" + result.output;
}

std::string Driver::input() const {
  const program::Arguments<long double> at = arguments<long double>(sample_);
  std::string text;
  for (const auto* list : {&at.parameters, &at.x, &at.y, &at.ydot, &at.inputs})
    for (const long double value : *list) {
      char number[64];
      std::snprintf(number, sizeof number, "%La\n", value);
      text += number;
    }
  return text;
}

void Driver::run() {
  const ProcessResult result = run_process({(folder_.path() / "main").string()}, input());
  if (result.status != 0)
    throw std::runtime_error("driver: status " + std::to_string(result.status) + "\n" + result.output);
  std::istringstream lines(result.output);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string scalar, function, word;
    Counts counts;
    words >> scalar >> function >> counts.adds >> counts.multiplies >> counts.divides >> counts.negations;
    if (scalar == "counted") counts_[function] = counts;
    std::vector<long double>& values = results_[scalar + " " + function];
    while (words >> word) values.push_back(std::stold(word));
  }
}

template <class T>
std::vector<T> Driver::results(const std::string& scalar, const std::string& function) const {
  const std::vector<long double>& values = results_.at(key(scalar, function));
  std::vector<T> result;
  for (const long double value : values) result.push_back(static_cast<T>(value));
  return result;
}

template std::vector<double> Driver::results(const std::string&, const std::string&) const;
template std::vector<long double> Driver::results(const std::string&, const std::string&) const;

}  // namespace kanec::test
