// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/emit/driver.hpp"

#include <algorithm>
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
#include <cmath>
#include <cstdio>
#include <type_traits>
#include <vector>

static long adds, multiplies, divides, negations;

// A user's own scalar: explicit from double, + - * /, and what the code calls besides.
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

// Not operations of the three kinds above: found by the type's namespace.
inline bool operator<(const Counted& a, const Counted& b) { return a.value < b.value; }
#define FUNCTION(f) inline Counted f(const Counted& a) { return Counted(std::f(a.value)); }
FUNCTION(sqrt) FUNCTION(sin) FUNCTION(cos) FUNCTION(tan) FUNCTION(asin) FUNCTION(acos) FUNCTION(exp) FUNCTION(log)
FUNCTION(abs) FUNCTION(tanh)
#undef FUNCTION
inline Counted atan2(const Counted& a, const Counted& b) { return Counted(std::atan2(a.value, b.value)); }
inline Counted pow(const Counted& a, const Counted& b) { return Counted(std::pow(a.value, b.value)); }

// A number and its rate along one direction.
struct Dual {
  Dual() = default;
  explicit Dual(double v) : value(v) {}
  Dual(double v, double r) : value(v), rate(r) {}
  double value = 0, rate = 0;
};
inline Dual operator-(const Dual& a) { return {-a.value, -a.rate}; }
inline Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.rate + b.rate}; }
inline Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.rate - b.rate}; }
inline Dual operator*(const Dual& a, const Dual& b) { return {a.value * b.value, a.rate * b.value + a.value * b.rate}; }
inline Dual operator/(const Dual& a, const Dual& b) {
  return {a.value / b.value, (a.rate - a.value / b.value * b.rate) / b.value};
}
inline bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
#define FUNCTION(f, slope) inline Dual f(const Dual& a) { const double v = std::f(a.value); return {v, (slope) * a.rate}; }
FUNCTION(sqrt, 0.5 / v) FUNCTION(sin, std::cos(a.value)) FUNCTION(cos, -std::sin(a.value)) FUNCTION(tan, 1 + v * v)
FUNCTION(asin, 1 / std::sqrt(1 - a.value * a.value)) FUNCTION(acos, -1 / std::sqrt(1 - a.value * a.value))
FUNCTION(exp, v) FUNCTION(log, 1 / a.value) FUNCTION(abs, a.value < 0 ? -1 : 1) FUNCTION(tanh, 1 - v * v)
#undef FUNCTION
inline Dual atan2(const Dual& a, const Dual& b) {
  return {std::atan2(a.value, b.value), (a.rate * b.value - a.value * b.rate) / (a.value * a.value + b.value * b.value)};
}
inline Dual pow(const Dual& a, const Dual& b) {
  const double v = std::pow(a.value, b.value);
  return {v, b.value * std::pow(a.value, b.value - 1) * a.rate + (b.rate == 0 ? 0 : v * std::log(a.value) * b.rate)};
}

inline void print(double v) { std::printf(" %a", v); }
inline void print(long double v) { std::printf(" %La", v); }
inline void print(const Counted& v) { print(v.value); }
inline void print(const Dual& v) { print(v.rate); }

static std::vector<long double> numbers(int n) {
  std::vector<long double> list(static_cast<std::size_t>(n));
  for (long double& v : list)
    if (std::scanf("%La", &v) != 1) std::printf("input ends early\n");
  return list;
}

template <class T>
std::vector<T> as(const std::vector<long double>& list, const std::vector<long double>& rates) {
  std::vector<T> result;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if constexpr (std::is_arithmetic_v<T>)
      result.push_back(static_cast<T>(list[i]));
    else if constexpr (std::is_same_v<T, Dual>)
      result.push_back(Dual(static_cast<double>(list[i]), static_cast<double>(rates[i])));
    else
      result.push_back(T(static_cast<double>(list[i])));
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

// Of the scene's values those that the struct has.
std::string fields(const std::string& variable, const std::string& list, const std::vector<scene::Named>& all,
                   const std::vector<scene::Named>& used) {
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (std::any_of(used.begin(), used.end(), [&](const scene::Named& named) { return named.name == all[i].name; }))
      text += "  " + variable + "." + all[i].name + " = " + list + "[" + std::to_string(i) + "];\n";
  return text;
}

std::string type_of(const std::string& scalar) {
  return scalar == "counted" ? "Counted" : scalar == "dual" ? "Dual" : scalar;
}

std::string key(const std::string& scalar, const std::string& function) {
  return (scalar == "long double" ? "long_double" : scalar) + " " + function;
}

}  // namespace

std::vector<std::string> strict_flags() {
  return {"-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"};
}

Driver::Driver(const Sample& sample, const Generated& generated)
    : sample_(sample), generated_(generated), used_(emit::used(sample.scene, generated.program)) {
  write_file(folder_.path() / (generated.name + ".hpp"), generated.header);
}

std::string Driver::call(const program::Function& function) const {
  const emit::ArgumentList list(generated_.program, function, !used_.inputs.empty());
  return "  report<T>(scalar, \"" + function.name + "\", " + std::to_string(function.n_out) +
         ", [&](T* out) { model::" + function.name + "(" + list.values("c", "u", "out") + "); });\n";
}

std::string Driver::source(const std::vector<std::string>& scalars) const {
  const scene::Scene& scene = sample_.scene;
  std::string text =
      "#include \"" + generated_.name + ".hpp\"\n" + prologue + "\nnamespace model = kanec::" + generated_.name +
      ";\n\ntemplate <class T>\nvoid run(const char* scalar, const std::vector<long double>& list, const "
      "std::vector<long double>& rates) {\n"
      "  const std::vector<T> all = as<T>(list, rates);\n  std::size_t at = 0;\n"
      "  const auto take = [&](int n) {\n    const auto first = all.begin() + static_cast<std::ptrdiff_t>(at);\n"
      "    at += static_cast<std::size_t>(n);\n    return std::vector<T>(first, first + n);\n  };\n"
      "  const std::vector<T> parameters = take(" +
      std::to_string(scene.parameters.size()) +
      ");\n"
      "  const std::vector<T> all_x = take(model::nx), all_y = take(model::ny), all_ydot = take(model::ny);\n"
      "  const std::vector<T> inputs = take(" +
      std::to_string(scene.inputs.size()) +
      ");\n"
      "  const T t = take(1)[0];\n  const T *x = all_x.data(), *y = all_y.data(), *ydot = all_ydot.data();\n"
      "  static_cast<void>(t), static_cast<void>(x), static_cast<void>(y), static_cast<void>(ydot);\n"
      "  model::Parameters<T> p;\n" +
      (used_.inputs.empty() ? "" : "  model::Inputs<T> u;\n");
  text +=
      fields("p", "parameters", scene.parameters, used_.parameters) + fields("u", "inputs", scene.inputs, used_.inputs);
  text += "  report<T>(scalar, \"prepare\", 0, [&](T*) { model::prepare(p); });\n";
  text += "  const model::Prepared<T> c = model::prepare(p);\n";
  for (const program::Function& function : generated_.program.functions) text += call(function);
  text += "}\n\nint main() {\n  const int n = model::nx + 2 * model::ny + " +
          std::to_string(scene.parameters.size() + scene.inputs.size() + 1) +
          ";\n  const auto list = numbers(n), rates = numbers(n);\n";
  for (const std::string& scalar : scalars)
    text += "  run<" + type_of(scalar) + ">(\"" + key(scalar, "").substr(0, key(scalar, "").size() - 1) +
            "\", list, rates);\n";
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

std::string Driver::input(const program::Arguments<long double>& at) const {
  const std::vector<long double> now = {at.time};
  std::string text;
  for (const auto* list : {&at.parameters, &at.x, &at.y, &at.ydot, &at.inputs, &now})
    for (const long double value : *list) {
      char number[64];
      std::snprintf(number, sizeof number, "%La\n", value);
      text += number;
    }
  return text;
}

program::Arguments<long double> still(const Sample& sample) {
  const auto zeros = [](const std::vector<double>& v) { return std::vector<long double>(v.size()); };
  return {zeros(sample.parameters), zeros(sample.state.x), zeros(sample.state.y), zeros(sample.state.ydot),
          zeros(sample.inputs)};
}

void Driver::run() { run(still(sample_)); }

void Driver::run(const program::Arguments<long double>& rates) {
  program::Arguments<long double> at = arguments<long double>(sample_);
  at.time = time;
  const std::string main = (folder_.path() / "main").string();
  const ProcessResult result = run_process({main}, input(at) + input(rates));
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
