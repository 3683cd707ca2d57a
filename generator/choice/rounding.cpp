// SPDX-License-Identifier: BSD-3-Clause
#include "generator/choice/rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include "generator/program/overloaded.hpp"

namespace kanec {
namespace {

using program::Index;
using program::Node;

// Standard deviation of rounding to nearest as a share of the value: ulp/√12, an ulp being 2^-52/1.44 of it on average.
constexpr double share = 0x1p-52 / 1.44 / 3.46;

// Values of all operations, and what they give on to their operands.
class Tape {
 public:
  Tape(const program::Program& program, const program::Function& function, const program::Arguments<double>& arguments)
      : program_(program), alive_(program::reachable(program, function.outputs)), values_(program.nodes.size(), 0.0) {
    const program::detail::Evaluate<double> operation{arguments, values_};
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (alive_[i]) values_[i] = std::visit(operation, program.nodes[i]);
    for (std::size_t i = 0; i < values_.size(); ++i) partials_.push_back(alive_[i] ? partials(i) : Partials{});
  }

  double value(Index node) const { return values_[static_cast<std::size_t>(node)]; }

  // The square of the expected error of a result.
  double square(Index result) const {
    std::vector<double> adjoint(static_cast<std::size_t>(result) + 1, 0.0);
    adjoint.back() = 1.0;
    double sum = 0.0;
    for (std::size_t i = adjoint.size(); i-- > 0;) {
      if (adjoint[i] == 0.0) continue;
      const program::Operands from = program::operands(program_.nodes[i]);
      if (from.count == 0) continue;
      const double error = share * adjoint[i] * values_[i];
      sum += error * error;
      for (int j = 0; j < from.count; ++j)
        adjoint[static_cast<std::size_t>(from.at[j])] += adjoint[i] * partials_[i][static_cast<std::size_t>(j)];
    }
    return sum;
  }

 private:
  using Partials = std::array<double, 3>;

  Partials partials(std::size_t node) const {
    using namespace program;
    const double v = values_[node];
    const auto of = [this](Index i) { return value(i); };
    return std::visit(Overloaded{[](const Constant&) { return Partials{}; }, [](const Variable&) { return Partials{}; },
                                 [](const Add&) {
                                   return Partials{1.0, 1.0};
                                 },
                                 [](const Subtract&) {
                                   return Partials{1.0, -1.0};
                                 },
                                 [&](const Multiply& op) {
                                   return Partials{of(op.b), of(op.a)};
                                 },
                                 [&](const Divide& op) {
                                   return Partials{1.0 / of(op.b), -v / of(op.b)};
                                 },
                                 [&](const SquareRoot&) { return Partials{v == 0.0 ? 0.0 : 0.5 / v}; },
                                 [&](const Sine& op) { return Partials{std::cos(of(op.a))}; },
                                 [&](const Cosine& op) { return Partials{-std::sin(of(op.a))}; },
                                 [&](const UnaryCall& op) { return Partials{slope(op.function, of(op.a), v)}; },
                                 [&](const BinaryCall& op) { return slopes(op.function, of(op.a), of(op.b), v); },
                                 [&](const Select& op) {
                                   return of(op.sign) < 0.0 ? Partials{1.0} : Partials{0.0, 1.0};
                                 }},
                      program_.nodes[node]);
  }

  static double slope(program::Unary function, double a, double value) {
    using program::Unary;
    switch (function) {
      case Unary::tan:
        return 1.0 + value * value;
      case Unary::asin:
        return 1.0 / std::sqrt(1.0 - a * a);
      case Unary::acos:
        return -1.0 / std::sqrt(1.0 - a * a);
      case Unary::exp:
        return value;
      case Unary::log:
        return 1.0 / a;
      case Unary::abs:
        return a < 0.0 ? -1.0 : 1.0;
      case Unary::tanh:
        return 1.0 - value * value;
    }
    throw InternalError("rounding: no such function");
  }

  static Partials slopes(program::Binary function, double a, double b, double value) {
    using program::Binary;
    switch (function) {
      case Binary::atan2:
        return {b / (a * a + b * b), -a / (a * a + b * b)};
      case Binary::min:
        return b < a ? Partials{0.0, 1.0} : Partials{1.0};
      case Binary::max:
        return a < b ? Partials{0.0, 1.0} : Partials{1.0};
      case Binary::pow:
        return {b * std::pow(a, b - 1.0), a > 0.0 ? value * std::log(a) : 0.0};
    }
    throw InternalError("rounding: no such function");
  }

  const program::Program& program_;
  std::vector<bool> alive_;
  std::vector<double> values_;
  std::vector<Partials> partials_;
};

// The results of a function, each once, or so many of them.
std::vector<Index> results_of(const program::Function& function, std::size_t most) {
  std::vector<Index> all;
  for (const program::Ref ref : function.outputs) all.push_back(ref.node);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const std::size_t step = (all.size() + most - 1) / most;
  std::vector<Index> some;
  for (std::size_t i = all.size(); i > 0; i -= std::min(i, step)) some.push_back(all[i - 1]);
  return some;
}

}  // namespace

double Rounding::ulps() const {
  if (error == 0.0 && std::isfinite(size)) return 0.0;
  if (!std::isfinite(error) || !std::isfinite(size) || size == 0.0) return std::numeric_limits<double>::infinity();
  return error / std::ldexp(1.0, std::ilogb(size) - 52);
}

Rounding expected_rounding(const program::Program& program, const program::Function& function,
                           const program::Arguments<double>& arguments, std::size_t most_outputs) {
  const Tape tape(program, function, arguments);
  Rounding result;
  double most = 0.0;
  const auto larger = [](double a, double b) {
    return std::isnan(b) ? std::numeric_limits<double>::infinity() : std::max(a, b);
  };
  for (const program::Ref ref : function.outputs) result.size = larger(result.size, std::fabs(tape.value(ref.node)));
  for (const Index node : results_of(function, most_outputs)) most = larger(most, tape.square(node));
  result.error = std::sqrt(most);
  return result;
}

}  // namespace kanec
