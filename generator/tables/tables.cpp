// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/tables/tables.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "generator/symbolic/factor.hpp"
#include "generator/symbolic/kane.hpp"
#include "generator/tables/formula.hpp"
#include "runtime/base/error.hpp"

namespace kanec::emit {
namespace {

using GiNaC::ex;
using symbolic::Blocks;
using symbolic::Style;

// Of a link's joint, and what moves it.
bool is_of_rotations(const std::string& name) {
  static const std::set<std::string> names = {"Rt", "Et", "Ct", "omega", "erel", "eps4rel"};
  return names.count(name) > 0;
}

// What a link is made of.
bool is_of_links(const std::string& name) {
  static const std::set<std::string> names = {"q", "o", "arm", "m_link", "r_link", "I_link"};
  return names.count(name) > 0;
}

class Tables {
 public:
  Tables(const symbolic::Equations& equations, Style style)
      : equations_(equations),
        letters_(equations.table),
        latex_(style == Style::latex),
        style_(style),
        n_(equations.mechanism.size()) {
    // positions and velocities in full: names of earlier rows and of q + s written out
    for (const symbolic::Quantity& quantity : equations.quantities) {
      values_.emplace(quantity.symbol, quantity.value);
      const std::string& name = equations.table.of(quantity.symbol).name;
      if (name == "d") joint_offsets_[quantity.symbol] = quantity.value;
      if (name == "P" || name == "Pdot") chain_[quantity.symbol] = quantity.value.subs(chain_, no_pattern);
    }
    collect_all();
    tell_apart();
  }

  std::vector<Table> all() const {
    const symbolic::Tables& t = equations_.tables;
    std::vector<Table> tables = {tree(),
                                 state(),
                                 kinematics(),
                                 rotations(),
                                 links(),
                                 of_bodies("Positions of the mass centres", "p", t.centre),
                                 of_bodies("Velocities of the mass centres", "v", t.velocity)};
    add_partials(tables, "Partial angular velocities", {"\\omega", "\\omega", "omega", ""}, t.omega_y);
    add_partials(tables, "Partial velocities", {"v", "v", "v", ""}, t.v_y);
    const std::string rates = "Time derivatives of the partial ";
    add_partials(tables, rates + "angular velocities", {"\\omega", "\\dot\\omega", "omega", "d/dt "}, t.omega_y_dot);
    add_partials(tables, rates + "velocities", {"v", "\\dot v", "v", "d/dt "}, t.v_y_dot);
    for (const Table& table : {equations_of_motion(), mass_matrix(), forcing()}) tables.push_back(table);
    const auto is_empty = [](const Table& table) { return table.rows.empty(); };
    tables.erase(std::remove_if(tables.begin(), tables.end(), is_empty), tables.end());
    return tables;
  }

 private:
  static constexpr unsigned no_pattern = GiNaC::subs_options::no_pattern;

  std::string print(const ex& e) const { return symbolic::notation(e, letters_, style_); }
  ex in_full(const ex& e) const { return e.subs(chain_, no_pattern).subs(joint_offsets_, no_pattern); }
  std::string pick(const std::string& latex, const std::string& text) const { return latex_ ? latex : text; }
  std::string indexed(const std::string& latex, const std::string& text, const std::string& index) const {
    return pick(latex + "_{" + symbolic::latex_index(index) + "}", text + index);
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
        if (c.row >= 0 && is_rotation(c) == rotation) visit(j, c);
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
            {{"x", "(" + parts(x[0], x[1]) + ")"},
             {pick("\\dim x", "size of x"), std::to_string(equations_.layout.nx)},
             {"y", "(" + parts(y[0], y[1]) + ")"},
             {pick("\\dim y", "size of y"), std::to_string(equations_.layout.ny)}}};
  }

  static std::string parts(const std::string& rotations, const std::string& translations) {
    return rotations + (rotations.empty() || translations.empty() ? "" : "; ") + translations;
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

  // --- rotations and links

  Table rotations() const {
    Table table{"Rotations and angular velocities of the joints", {}};
    append_if(table, [this](const symbolic::Quantity& q) { return is_of_rotations(name(q)) || is_prescribed(q); });
    return table;
  }

  Table links() const {
    Table table{"Links, from the numbers of their bodies", {}};
    append_if(table, [this](const symbolic::Quantity& q) { return is_of_links(name(q)); });
    return table;
  }

  const std::string& name(const symbolic::Quantity& quantity) const {
    return equations_.table.of(quantity.symbol).name;
  }

  static bool is_prescribed(const symbolic::Quantity& quantity) {
    return is_ex_the_function(quantity.value, symbolic::expression);
  }

  // Has it a row in one of the two tables above?
  bool is_told_before(const symbolic::Quantity& quantity) const {
    return is_prescribed(quantity) || is_of_rotations(name(quantity)) || is_of_links(name(quantity));
  }

  template <class Wanted>
  void append_if(Table& table, Wanted wanted) const {
    for (const symbolic::Quantity& quantity : equations_.quantities)
      if (printed_.count(quantity.symbol) > 0 && wanted(quantity)) table.rows.push_back(row(quantity));
  }

  Row row(const symbolic::Quantity& quantity) const {
    return {print(quantity.symbol), is_prescribed(quantity) ? prescribed(quantity.value) : print(quantity.value)};
  }

  std::string prescribed(const ex& value) const {
    const int order = GiNaC::ex_to<GiNaC::numeric>(value.op(1)).to_int();
    const scene::Expression& expression =
        equations_.scene.expressions[static_cast<std::size_t>(GiNaC::ex_to<GiNaC::numeric>(value.op(0)).to_int())];
    const std::string formula = pick(latex_formula(equations_.scene, expression), expression.text);
    if (order == 0) return formula;
    const std::string rate =
        order == 1 ? pick("\\tfrac{d}{dt}\\,", "d/dt ") : pick("\\tfrac{d^2}{dt^2}\\,", "d^2/dt^2 ");
    return rate + "(" + formula + ")";
  }

  Table of_bodies(const std::string& title, const std::string& letter, const std::vector<ex>& values) const {
    Table table{title + ", inertial axes", {}};
    GiNaC::exset used;
    for (int k = 1; k <= n_; ++k) {
      const ex value = in_full(values[at(k)]);
      collect(value, used);
      table.rows.push_back({indexed(letter, letter, suffix(k)), print(value)});
    }
    append_names(table, used);
    return table;
  }

  // --- partial velocities

  // "v", "\\dot v"; in text "v", "d/dt ".
  struct Letter {
    std::string latex, latex_rate, text, front;
  };

  // Block by block, and one matrix a link.
  void add_partials(std::vector<Table>& tables, const std::string& title, const Letter& letter,
                    const std::vector<Blocks>& rows) const {
    tables.push_back(of_blocks(title, letter, rows));
    tables.push_back(matrices(title, letter, rows));
  }

  // "v3,omega1" or "d/dt v3,omega1"
  std::string block_name(const Letter& letter, int k, int column) const {
    const std::string front = letter.front.empty() ? "" : pick("\\tfrac{d}{dt}", letter.front);
    return front + pick(letter.latex + "_{" + symbolic::latex_index(suffix(k)) + ",", letter.text + suffix(k) + ",") +
           column_name(column) + pick("}", "");
  }

  ex block_of(const ex& value) const { return symbolic::factored(value).subs(joint_offsets_, no_pattern); }

  Table of_blocks(const std::string& title, const Letter& letter, const std::vector<Blocks>& rows) const {
    Table table{title + (all_wide() ? " (3 x 3 blocks; all others are 0)" : " (blocks; all others are 0)"), {}};
    GiNaC::exset used, told;
    for (int k = 1; k <= n_; ++k)
      for (const auto& [column, value] : rows[at(k)]) {
        const ex block = block_of(value);
        const std::string left = block_name(letter, k, column);
        const auto named = values_.find(block);
        if (named == values_.end() || is_of_rotations(equations_.table.of(block).name)) {
          collect(block, used);
          table.rows.push_back({left, print(block)});
          continue;
        }
        collect(named->second, used);
        table.rows.push_back({left, with_name(left, *named)});
        told.insert(block);
      }
    for (const ex& block : told) used.erase(block);
    if (table.rows.empty()) table.rows.push_back({pick("\\text{all}", "all"), "0"});
    append_names(table, used);
    return table;
  }

  // "P_omega1_3 = -R2^T q3~ E2": a block that later rows have by a name; the value alone where `left` is that name.
  std::string with_name(const std::string& left, const std::pair<const ex, ex>& named) const {
    const std::string name = print(named.first);
    return (name == left ? "" : name + " = ") + print(named.second);
  }

  // [v3,y1] = [-R1^T (q2~ + s2~), ..., 0], as wide as y1; y1 are the speeds of rotations, y2 those of translations.
  Table matrices(const std::string& title, const Letter& letter, const std::vector<Blocks>& rows) const {
    Table table{title + pick(", one matrix a body: by $y_1$, the speeds of rotations, and by $y_2$, of translations",
                             ", one matrix a body: by y1, the speeds of rotations, and by y2, of translations"),
                {}};
    for (int k = 1; k <= n_; ++k)
      for (const bool rotation : {true, false}) {
        const std::string part = rotation ? pick("y_1", "y1") : pick("y_2", "y2");
        const std::string left =
            pick("[" + letter.latex_rate + "_{" + symbolic::latex_index(suffix(k)) + "," + part + "}]",
                 "[" + letter.front + letter.text + suffix(k) + "," + part + "]");
        std::string right;
        for_coordinates(rotation, [&](int, const symbolic::Coordinate& c) {
          const auto block = rows[at(k)].find(c.column);
          right += (right.empty() ? "" : ", ") + (block == rows[at(k)].end() ? "0" : print(block_of(block->second)));
        });
        if (!right.empty()) table.rows.push_back({left, "[" + right + "]"});
      }
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
      const bool is_row =
          output.transposed && !output.wide && symbolic::shape_of(output.block) != symbolic::Shape::scalar;
      const ex block = output.transposed && output.wide ? equations_.table.transposed(output.block) : output.block;
      blocks[place] = is_row ? "(" + print(block) + ")" + pick("^{T}", "^T") : print(block);
    }
    for (const auto& [place, text] : blocks)
      table.rows.push_back({pick("A_{" + column_name(place.first) + "," + column_name(place.second) + "}",
                                 "A[" + column_name(place.first) + ", " + column_name(place.second) + "]"),
                            text});
    append_names(table, used_by("mass_matrix"));
    return table;
  }

  // What its rows are written in, then one row a speed, also of one that is 0 or has a name of its own.
  Table forcing() const {
    Table table{"f, with the sums over bodies that share a partial velocity taken once", {}};
    const symbolic::Function& f = function("forcing");
    std::vector<Row> rows;
    GiNaC::exset known;
    for (const bool rotation : {true, false})
      for_coordinates(rotation,
                      [&](int j, const symbolic::Coordinate& c) { rows.push_back(forcing_row(f, j, c, known)); });
    GiNaC::exset used = used_by("forcing");
    for (const ex& row : known) used.erase(row);
    append_names(table, used);
    table.rows.insert(table.rows.end(), rows.begin(), rows.end());
    return table;
  }

  // Kane's equation of a coordinate; `known` takes its letter where it is one of the quantities.
  Row forcing_row(const symbolic::Function& f, int j, const symbolic::Coordinate& c, GiNaC::exset& known) const {
    const symbolic::RowLetter letter = row_letter("f", letters(j), c);
    symbolic::SymbolTable table;
    const std::string left = symbolic::notation(
        table.add(symbolic::Role::quantity, letter.name, letter.latex, suffix(j), symbolic::Shape::scalar), table,
        style_);
    for (const symbolic::Output& output : f.outputs) {
      if (output.offset != c.row) continue;
      const bool is_row =
          GiNaC::is_a<symbolic::Atom>(output.block) && equations_.table.of(output.block).name == letter.name;
      if (!is_row) return {left, print(output.block)};
      known.insert(output.block);
      return {left, print(values_.at(output.block))};
    }
    return {left, "0"};
  }

  const symbolic::Function& function(const std::string& name) const {
    for (const symbolic::Function& f : equations_.functions)
      if (f.name == name) return f;
    throw InternalError("tables: no function " + name);
  }

  // --- the named quantities that blocks are written in

  GiNaC::exset used_by(const std::string& name) const {
    GiNaC::exset used;
    for (const symbolic::Output& output : function(name).outputs) collect(output.block, used);
    return used;
  }

  void append_names(Table& table, const GiNaC::exset& used) const {
    for (const symbolic::Quantity& quantity : equations_.quantities)
      if (used.count(quantity.symbol) > 0 && !is_told_before(quantity)) table.rows.push_back(row(quantity));
  }

  // Everything that any table shows.
  void collect_all() {
    const symbolic::Tables& t = equations_.tables;
    for (const std::vector<ex>* values : {&t.centre, &t.velocity})
      for (const ex& value : *values) collect(in_full(value), printed_);
    for (const std::vector<Blocks>* rows : {&t.omega_y, &t.v_y, &t.omega_y_dot, &t.v_y_dot})
      for (const Blocks& blocks : *rows)
        for (const auto& [column, block] : blocks) collect(block_of(block), printed_);
    for (const char* name : {"mass_matrix", "forcing"}) {
      const GiNaC::exset used = used_by(name);
      printed_.insert(used.begin(), used.end());
    }
    for (int j = 1; j <= n_; ++j)
      for (const symbolic::Coordinate& c : letters(j).coordinates)
        for (const ex& letter : {c.value, c.speed, letters(j).e, letters(j).eps4}) collect(letter, printed_);
  }

  // Two letters that would be printed alike: the later one gets a prime in text, a bar in LaTeX.
  void tell_apart() {
    std::set<std::string> taken;
    for (const symbolic::Symbol& symbol : equations_.table.all()) {
      if (symbol.is_transpose || (printed_.count(symbol.atom) == 0 && printed_.count(symbol.transpose) == 0)) continue;
      while (!taken.insert(print(symbol.atom)).second) {
        const symbolic::Symbol& now = letters_.of(symbol.atom);
        letters_.rename(symbol.atom, now.name + "'", "\\bar{" + now.latex + "}");
      }
    }
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
  symbolic::SymbolTable letters_;  // as they are printed
  bool latex_;
  Style style_;
  int n_;
  GiNaC::exmap values_, chain_, joint_offsets_;  // by letter
  GiNaC::exset printed_;                         // letters
};

}  // namespace

std::vector<Table> tables(const symbolic::Equations& equations, Style style) { return Tables(equations, style).all(); }

}  // namespace kanec::emit
