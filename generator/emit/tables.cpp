// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/tables.hpp"

#include <map>

#include "generator/symbolic/factor.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/fit.hpp"

namespace kanec::emit {
namespace {

using GiNaC::ex;
using symbolic::Blocks;
using symbolic::Style;

class Tables {
 public:
  Tables(const symbolic::Equations& equations, Style style)
      : equations_(equations), latex_(style == Style::latex), style_(style), n_(equations.mechanism.size()) {
    // positions and velocities in full: names of earlier rows and of q + s written out
    for (const symbolic::Quantity& quantity : equations.quantities) {
      values_.emplace(quantity.symbol, quantity.value);
      const std::string& name = equations.table.of(quantity.symbol).name;
      if (name == "d") joint_offsets_[quantity.symbol] = quantity.value;
      if (name == "P" || name == "Pdot") chain_[quantity.symbol] = quantity.value.subs(chain_, no_pattern);
    }
  }

  std::vector<Table> all() const {
    const symbolic::Tables& t = equations_.tables;
    return {tree(),
            state(),
            kinematics(),
            of_bodies("Positions of the mass centres", "p", t.centre),
            of_bodies("Velocities of the mass centres", "v", t.velocity),
            of_blocks("Partial angular velocities", "\\omega", "omega", "", t.omega_y),
            of_blocks("Partial velocities", "v", "v", "", t.v_y),
            of_blocks("Time derivatives of the partial angular velocities", "\\omega", "omega", "dot", t.omega_y_dot),
            of_blocks("Time derivatives of the partial velocities", "v", "v", "dot", t.v_y_dot),
            equations_of_motion(),
            mass_matrix(),
            forcing()};
  }

 private:
  static constexpr unsigned no_pattern = GiNaC::subs_options::no_pattern;

  std::string print(const ex& e) const { return symbolic::notation(e, equations_.table, style_); }
  std::string in_full(const ex& e) const { return print(e.subs(chain_, no_pattern).subs(joint_offsets_, no_pattern)); }
  std::string pick(const std::string& latex, const std::string& text) const { return latex_ ? latex : text; }
  std::string indexed(const std::string& latex, const std::string& text, const std::string& index) const {
    return pick(latex + "_{" + index + "}", text + index);
  }

  Table tree() const {
    Table table{"Connection array L(K) and steps u(K) to the first body of the tree", {}};
    const std::vector<int>& lower = equations_.scene.lower;
    table.rows = {{"K", list(static_cast<int>(lower.size()), [](int k) { return std::to_string(k); })},
                  {"L(K)", list(static_cast<int>(lower.size()), [&](int k) { return std::to_string(lower[at(k)]); })}};
    const std::vector<int> u = scene::depth(lower);
    table.rows.push_back({"u(K)", list(static_cast<int>(u.size()), [&](int k) { return std::to_string(u[at(k)]); })});
    return table;
  }

  template <class Text>
  static std::string list(int n, Text text) {
    std::string row;
    for (int k = 1; k <= n; ++k) row += (k > 1 ? ", " : "") + text(k);
    return "(" + row + ")";
  }

  // Every coordinate of the state, rotations first.
  template <class Visit>
  void for_coordinates(bool rotation, Visit visit) const {
    for (int j = 1; j <= n_; ++j)
      for (const symbolic::Coordinate& c : letters(j).coordinates) {
        const bool turns =
            c.freedom.kind == symbolic::Freedom::Kind::attitude || c.freedom.kind == symbolic::Freedom::Kind::turn;
        if (c.row >= 0 && turns == rotation) visit(j, c);
      }
  }

  std::string coordinate(int j, const symbolic::Coordinate& c) const {
    return c.freedom.kind == symbolic::Freedom::Kind::attitude ? indexed("\\varepsilon", "eps", suffix(j))
                                                               : print(c.value);
  }

  Table state() const {
    std::string x[2], y[2];
    for (const bool rotation : {true, false})
      for_coordinates(rotation, [&](int j, const symbolic::Coordinate& c) {
        const std::size_t part = rotation ? 0 : 1;
        x[part] += (x[part].empty() ? "" : ", ") + coordinate(j, c);
        y[part] += (y[part].empty() ? "" : ", ") + print(c.speed);
      });
    return {"State vectors",
            {{"x", "(" + x[0] + "; " + x[1] + ")"},
             {pick("\\dim x", "size of x"), std::to_string(equations_.layout.nx)},
             {"y", "(" + y[0] + "; " + y[1] + ")"},
             {pick("\\dim y", "size of y"), std::to_string(equations_.layout.ny)}}};
  }

  Table kinematics() const {
    Table table{"Kinematical equations, e = (eps_1, eps_2, eps_3)", {}};
    if (latex_) table.title = "Kinematical equations, $e = (\\varepsilon_1, \\varepsilon_2, \\varepsilon_3)$";
    for (int j = 1; j <= n_; ++j)
      for (const symbolic::Coordinate& c : letters(j).coordinates) {
        if (c.row < 0) continue;
        if (c.freedom.kind == symbolic::Freedom::Kind::attitude)
          add_attitude(table, j);
        else
          table.rows.push_back({pick("\\tfrac{d}{dt}", "d/dt ") + print(c.value), print(c.speed)});
      }
    return table;
  }

  void add_attitude(Table& table, int j) const {
    const symbolic::Letters& link = letters(j);
    const std::string e = print(link.e), eps4 = print(link.eps4), omega = print(link.omega), index = suffix(j);
    table.rows.push_back(
        {pick("\\dot e_{" + index + "}", "edot" + index),
         pick("\\tfrac12(", "1/2 (") + eps4 + " " + omega + " + " + print(symbolic::skew(link.e) * link.omega) + ")"});
    table.rows.push_back({pick("\\dot\\varepsilon_{4}^{(" + index + ")}", "eps4dot" + index),
                          pick("-\\tfrac12 ", "-1/2 ") + print(symbolic::dot(link.e, link.omega))});
  }

  Table of_bodies(const std::string& title, const std::string& letter, const std::vector<ex>& values) const {
    Table table{title + ", inertial axes", {}};
    for (int k = 1; k <= n_; ++k) table.rows.push_back({indexed(letter, letter, suffix(k)), in_full(values[at(k)])});
    return table;
  }

  // "v3,omega1" or "d/dt v3,omega1"
  std::string block_name(const std::string& latex, const std::string& text, const std::string& dot, int k,
                         int column) const {
    const std::string front = dot.empty() ? "" : pick("\\tfrac{d}{dt}", "d/dt ");
    return front + indexed(latex, text, suffix(k) + "," + column_name(column));
  }

  Table of_blocks(const std::string& title, const std::string& latex, const std::string& text, const std::string& dot,
                  const std::vector<Blocks>& rows) const {
    Table table{title + (all_wide() ? " (3 x 3 blocks; all others are 0)" : " (blocks; all others are 0)"), {}};
    for (int k = 1; k <= n_; ++k)
      for (const auto& [column, block] : rows[at(k)])
        table.rows.push_back({block_name(latex, text, dot, k, column),
                              print(symbolic::factored(block).subs(joint_offsets_, no_pattern))});
    if (table.rows.empty()) table.rows.push_back({pick("\\text{all}", "all"), "0"});
    return table;
  }

  Table equations_of_motion() const {
    return {"Equations of motion",
            {{pick("A\\dot y", "A ydot"), "f"},
             {"A", pick("\\sum_K \\left( m_K v_{K,y}^{T} v_{K,y} + \\omega_{K,y}^{T} I_K \\omega_{K,y} \\right)",
                        "sum_K (m_K v_K,y^T v_K,y + omega_K,y^T I_K omega_K,y)")},
             {"f", pick("\\sum_K v_{K,y}^{T} ( F_K - m_K \\dot v_{K,y} y ) + \\sum_K \\omega_{K,y}^{T} "
                        "( M_K - \\tilde\\omega_K I_K \\omega_K )",
                        "sum_K v_K,y^T (F_K - m_K (d/dt v_K,y) y) + sum_K omega_K,y^T (M_K - omega_K~ I_K omega_K)")},
             {"r", pick("A\\dot y - f", "A ydot - f")}}};
  }

  std::string column_name(int column) const {
    return print(equations_.speeds[static_cast<std::size_t>(column)].letter);
  }

  bool all_wide() const {
    for (const symbolic::Speed& speed : equations_.speeds)
      if (symbolic::shape_of(speed.letter) != symbolic::Shape::vector) return false;
    return true;
  }

  int column_at(int row) const {
    for (std::size_t i = 0; i < equations_.speeds.size(); ++i)
      if (equations_.speeds[i].row == row) return static_cast<int>(i);
    throw InternalError("tables: a row between speeds");
  }

  // The blocks as the function emits them; upper triangle.
  Table mass_matrix() const {
    Table table{"Blocks of A (upper triangle; all others are 0)", {}};
    const int ny = equations_.layout.ny;
    std::map<std::pair<int, int>, std::string> blocks;
    for (const symbolic::Output& output : function("mass_matrix").outputs) {
      const std::pair place(column_at(output.offset / ny), column_at(output.offset % ny));
      if (place.first > place.second) continue;
      const bool is_row = output.transposed && !output.wide;
      const ex block = output.transposed && output.wide ? equations_.table.transposed(output.block) : output.block;
      blocks[place] = is_row ? "(" + print(block) + ")" + pick("^{T}", "^T") : print(block);
    }
    for (const auto& [place, text] : blocks)
      table.rows.push_back({pick("A_{" + column_name(place.first) + "," + column_name(place.second) + "}",
                                 "A[" + column_name(place.first) + ", " + column_name(place.second) + "]"),
                            text});
    append_names(table, "mass_matrix");
    return table;
  }

  Table forcing() const {
    Table table{"f, with the sums over bodies that share a partial velocity taken once", {}};
    append_names(table, "forcing");
    return table;
  }

  const symbolic::Function& function(const std::string& name) const {
    for (const symbolic::Function& f : equations_.functions)
      if (f.name == name) return f;
    throw InternalError("tables: no function " + name);
  }

  // The named quantities that a function's blocks are written in, besides attitudes.
  void append_names(Table& table, const std::string& name) const {
    GiNaC::exset used;
    for (const symbolic::Output& output : function(name).outputs) collect(output.block, used);
    for (const symbolic::Quantity& quantity : equations_.quantities)
      if (used.count(quantity.symbol) > 0 && equations_.table.of(quantity.symbol).name != "Rt" &&
          equations_.table.of(quantity.symbol).name != "Et")
        table.rows.push_back({print(quantity.symbol), print(quantity.value)});
  }

  void collect(const ex& e, GiNaC::exset& used) const {
    if (!GiNaC::is_a<symbolic::Atom>(e)) {
      for (const ex& operand : e) collect(operand, used);
      return;
    }
    if (!used.insert(e).second) return;
    collect(equations_.table.of(e).transpose, used);
    if (const auto known = values_.find(e); known != values_.end()) collect(known->second, used);
  }

  const std::string& suffix(int j) const { return equations_.mechanism.link(j).suffix; }
  const symbolic::Letters& letters(int k) const { return equations_.letters[static_cast<std::size_t>(k)]; }
  static std::size_t at(int k) { return static_cast<std::size_t>(k - 1); }

  const symbolic::Equations& equations_;
  bool latex_;
  Style style_;
  int n_;
  GiNaC::exmap values_, chain_, joint_offsets_;  // by letter
};

}  // namespace

std::vector<Table> tables(const symbolic::Equations& equations, Style style) { return Tables(equations, style).all(); }

namespace {

// "1 base revolute, 2 arm weld", a line.
std::string joints(const scene::Scene& scene) {
  std::string text;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k)
    text += (k > 0 ? ", " : "joints: ") + std::to_string(k + 1) + " " + scene.bodies[k].joint.kind;
  return text + "\n";
}

}  // namespace

std::string text_document(const symbolic::Equations& equations) {
  std::string text = equations.scene.name + ": " + std::to_string(size(equations.scene)) +
                     (size(equations.scene) == 1 ? " body" : " bodies") + "\n" + joints(equations.scene) +
                     "a~ b = a x b; R_K takes inertial components to those in body K\n";
  for (const Table& table : tables(equations, Style::text)) {
    text += "\n" + table.title + "\n";
    for (const auto& [left, right] : table.rows) text += "  " + left + " = " + right + "\n";
  }
  return text;
}

namespace {

// A long right side broken before its outer signs.
std::string broken(const std::string& side) {
  std::string result;
  std::size_t column = 0;
  int depth = 0;
  for (std::size_t i = 0; i < side.size(); ++i, ++column) {
    depth += side[i] == '(' || side[i] == '{';
    depth -= side[i] == ')' || side[i] == '}';
    const bool at_sign = depth == 0 && (side.compare(i, 3, " + ") == 0 || side.compare(i, 3, " - ") == 0);
    if (at_sign && column > 200) {
      result += " \\\\\n&\\quad";
      column = 0;
    }
    result += side[i];
  }
  return result;
}

}  // namespace

std::string latex_document(const symbolic::Equations& equations) {
  std::string text =
      "\\documentclass{article}\n\\usepackage{amsmath}\n\\usepackage[landscape,margin=15mm]{geometry}\n"
      "\\allowdisplaybreaks\n\\begin{document}\n\\section*{" +
      fit::latex(equations.scene.name) + ": " + std::to_string(size(equations.scene)) +
      (size(equations.scene) == 1 ? " body" : " bodies") + "}\n" + joints(equations.scene) +
      "\n$\\tilde a b = a \\times b$; $R_K$ takes inertial components to those in body "
      "$K$.\n";
  for (const Table& table : tables(equations, Style::latex)) {
    text += "\\subsection*{" + table.title + "}\n\\begin{align*}\n";
    for (std::size_t i = 0; i < table.rows.size(); ++i)
      text +=
          table.rows[i].first + " &= " + broken(table.rows[i].second) + (i + 1 < table.rows.size() ? " \\\\\n" : "\n");
    text += "\\end{align*}\n";
  }
  return text + "\\end{document}\n";
}

}  // namespace kanec::emit
