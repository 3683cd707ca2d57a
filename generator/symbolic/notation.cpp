// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/notation.hpp"

#include <algorithm>

#include "generator/symbolic/order.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/base/text.hpp"

namespace kanec::symbolic {
namespace {

using GiNaC::ex;

class Notation {
 public:
  Notation(const SymbolTable& table, Style style) : table_(table), latex_(style == Style::latex) {}

  std::string of(const ex& e) const {
    if (GiNaC::is_a<GiNaC::add>(e)) return sum(e);
    if (GiNaC::is_a<GiNaC::mul>(e)) return product(ordered(e));
    if (GiNaC::is_a<GiNaC::ncmul>(e)) return product({e.begin(), e.end()});
    if (GiNaC::is_a<Atom>(e)) return letter(table_.of(e), "");
    if (GiNaC::is_a<GiNaC::function>(e)) return function(e);
    if (GiNaC::is_a<GiNaC::power>(e)) return reciprocal(e);
    return number(GiNaC::ex_to<GiNaC::numeric>(e));
  }

 private:
  std::string sum(const ex& e) const {
    std::string result;
    for (const ex& operand : ordered(e)) {
      const std::string term = of(operand);
      if (result.empty())
        result = term;
      else if (term[0] == '-')
        result += " - " + term.substr(1);
      else
        result += " + " + term;
    }
    return result;
  }

  // A number stands first; -1 is a sign; factors that are sums stand in parentheses.
  std::string product(const std::vector<ex>& factors) const {
    std::string sign;
    std::string result;
    for (const ex& factor : factors) {
      if (factor.is_equal(-1)) {
        sign = "-";
        continue;
      }
      std::string text = of(factor);
      if (GiNaC::is_a<GiNaC::add>(factor)) text = "(" + text + ")";
      if (text[0] == '-') {
        sign = sign.empty() ? "-" : "";
        text = text.substr(1);
      }
      result += (result.empty() ? "" : " ") + text;
    }
    return sign + result;
  }

  std::string letter(const Symbol& symbol, const std::string& accent) const {
    const Symbol& named = symbol.is_transpose ? table_.of(symbol.transpose) : symbol;
    if (latex_) return latex_letter(named, accent, symbol.is_transpose);
    return named.name + named.suffix + accent + (symbol.is_transpose ? "^T" : "");
  }

  // The accent stands over the letter alone, the index at # or below it.
  static std::string latex_letter(const Symbol& symbol, const std::string& accent, bool transposed) {
    const std::string index = latex_index(symbol.suffix);
    std::string whole = symbol.latex;
    const std::size_t place = found(whole, "#", everywhere);
    if (place != std::string::npos) whole.replace(place, 1, index);
    const std::size_t end = std::min(found(whole, "_^'", 0), whole.size());
    std::string nucleus = whole.substr(0, end), scripts = whole.substr(end);
    if (!accent.empty()) nucleus = accent + "{" + nucleus + "}";
    if (place == std::string::npos && !index.empty()) {
      if (found(scripts, "_", 0) == std::string::npos)
        scripts = "_{" + index + "}" + scripts;
      else
        scripts = scripts + "{}_{" + index + "}";
    }
    return transposed ? raised_latex(nucleus + scripts, "T") : nucleus + scripts;
  }

  // Behind a superscript that is there already.
  static std::string raised_latex(const std::string& base, const std::string& exponent) {
    return base + (found(base, "^'", 0) == std::string::npos ? "^{" : "{}^{") + exponent + "}";
  }
  std::string raised(const std::string& base, const std::string& exponent) const {
    return latex_ ? raised_latex(base, exponent) : base + "^" + exponent;
  }

  // The first of some characters within so many braces; none after a backslash.
  static constexpr int everywhere = 1000;
  static std::size_t found(const std::string& text, const std::string& characters, int deepest) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (depth <= deepest && characters.find(text[i]) != std::string::npos) return i;
      depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
      if (text[i] == '\\') ++i;
    }
    return std::string::npos;
  }

  std::string function(const ex& e) const {
    const auto argument = [&](std::size_t i) { return of(e.op(i)); };
    if (is_ex_the_function(e, skew)) return skew_of(e.op(0));
    if (is_ex_the_function(e, dot)) return grouped(e.op(0)) + (latex_ ? " \\cdot " : " . ") + grouped(e.op(1));
    if (is_ex_the_function(e, inverse)) return raised(argument(0), "-1");
    if (is_ex_the_function(e, gyroscopic)) return skew_of(e.op(1)) + " " + argument(0) + " " + argument(1);
    if (is_ex_the_function(e, turn))
      return (latex_ ? "\\operatorname{Rot}(" : "Rot(") + argument(0) + ", " + argument(1) + ")";
    if (is_ex_the_function(e, congruence) || is_ex_the_function(e, similarity))
      return argument(0) + " " + grouped(e.op(1)) + " " + of(table_.of(e.op(0)).transpose);
    if (is_ex_the_function(e, outer)) return grouped(e.op(0)) + " " + raised(argument(1), "T");
    if (is_ex_the_function(e, ldl)) return factors_of(argument(0));
    if (is_ex_the_function(e, forward)) return solved("L", "-1", e);
    if (is_ex_the_function(e, scaled)) return solved("D", "-1", e);
    if (is_ex_the_function(e, backward)) return solved("L", "-T", e);
    if (is_ex_the_function(e, expression)) return expression_of(e);
    if (is_ex_the_function(e, rotation)) {
      // Rᵀ = 1 + 2 ẽ (ε4 + ẽ)
      return "1 + 2 " + skew_of(e.op(0)) + " (" + argument(1) + " + " + skew_of(e.op(0)) + ")";
    }
    if (is_ex_the_function(e, second_moment)) return second_moment_of(argument(0));
    return (latex_ ? "\\operatorname{axial}(" : "axial(") + argument(0) + " " + second_moment_of(argument(1)) + ")";
  }

  std::string second_moment_of(const std::string& inertia) const {
    const std::string trace = latex_ ? "\\tfrac12\\operatorname{tr}(" + inertia + ")" : "tr(" + inertia + ")/2";
    return "(" + trace + " - " + inertia + ")";
  }

  // "L D L^T of J3"
  std::string factors_of(const std::string& matrix) const {
    return latex_ ? "(L, D)(" + matrix + ")" : "L D L^T of " + matrix;
  }

  // L⁻¹ b with the L that stands in the first argument: "(L of LD3)^-1 b".
  std::string solved(const std::string& part, const std::string& power, const ex& e) const {
    const std::string base = part + "(" + of(e.op(0)) + ")";
    return base + "^" + (latex_ ? "{" + power + "}" : power) + " " + grouped(e.op(1));
  }

  static std::string expression_of(const ex& e) {
    const int order = GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int();
    const std::string number = std::to_string(GiNaC::ex_to<GiNaC::numeric>(e.op(0)).to_int() + 1);
    const std::string rate = order == 0 ? "" : order == 1 ? "d/dt " : "d^2/dt^2 ";
    return rate + "expression " + number;
  }

  std::string skew_of(const ex& e) const {
    if (GiNaC::is_a<Atom>(e)) return letter(table_.of(e), latex_ ? "\\tilde" : "~");
    return latex_ ? "\\widetilde{(" + of(e) + ")}" : "(" + of(e) + ")~";
  }

  std::string grouped(const ex& e) const {
    return GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::ncmul>(e) ? "(" + of(e) + ")" : of(e);
  }

  std::string reciprocal(const ex& e) const {
    const std::string exponent = of(e.op(1));
    const std::string base = GiNaC::is_a<Atom>(e.op(0)) ? of(e.op(0)) : "(" + of(e.op(0)) + ")";
    return raised(base, exponent);
  }

  // "1e-36", where a fraction would have dozens of digits.
  std::string decimal(const GiNaC::numeric& value) const {
    const std::string text = shortest(value.to_double());
    const std::size_t exponent = text.find('e');
    if (!latex_ || exponent == std::string::npos) return text;
    return text.substr(0, exponent) + " \\cdot 10^{" + text.substr(exponent + 1) + "}";
  }

  std::string number(const GiNaC::numeric& value) const {
    constexpr long most = 1'000'000'000;
    if (GiNaC::abs(value.numer()) > most || value.denom() > most) return decimal(value);
    if (value.is_integer()) return std::to_string(value.to_long());
    const std::string sign = value.is_negative() ? "-" : "";
    const std::string over = std::to_string(GiNaC::abs(value.numer()).to_long());
    const std::string under = std::to_string(value.denom().to_long());
    return latex_ ? sign + "\\tfrac{" + over + "}{" + under + "}" : sign + over + "/" + under;
  }

  const SymbolTable& table_;
  bool latex_;
};

}  // namespace

std::string notation(const ex& e, const SymbolTable& table, Style style) { return Notation(table, style).of(e); }

std::string latex_named(const std::string& letter, const std::string& name, const std::string& more) {
  return letter + "_{\\text{" + fit::latex(name) + "}" + more + "}";
}

std::string latex_index(const std::string& suffix) {
  std::string result;
  for (const char c : suffix) {
    if (c != '_')
      result += c;
    else if (!result.empty() && result.back() != ',')
      result += ',';
  }
  if (!result.empty() && result.back() == ',') result.pop_back();
  return result;
}

}  // namespace kanec::symbolic
