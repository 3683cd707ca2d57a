// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/tables/grids.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "generator/scene/component.hpp"
#include "generator/scene/expression_value.hpp"
#include "generator/symbolic/loads.hpp"
#include "generator/tables/formula.hpp"
#include "runtime/base/text.hpp"

namespace kanec::emit {
namespace {

using scene::Load;
using scene::Number;
using symbolic::Style;

// What a scene says, as text or as LaTeX.
class Words {
 public:
  Words(const scene::Scene& scene, Style style)
      : scene_(scene), latex_(style == Style::latex), x_(initial_coordinates(scene)), y_(initial_speeds(scene)) {}

  bool latex() const { return latex_; }
  std::string name(const std::string& given) const { return latex_ ? latex_word(given) : given; }
  std::string formula(const std::string& text) const { return latex_ ? "$" + latex_breaks(text) + "$" : text; }

  // "body 2 (arm)", "the ground".
  std::string body(int k) const {
    if (k == 0) return "the ground";
    return "body " + std::to_string(k) + " (" + name(scene_.bodies[static_cast<std::size_t>(k - 1)].name) + ")";
  }

  // As the scene has it.
  std::string written(const Number& number) const {
    switch (number.kind) {
      case Number::Kind::constant:
        return latex_ ? latex_number(number.value) : shortest(number.value);
      case Number::Kind::parameter:
        return of_scene(scene_.parameters[static_cast<std::size_t>(number.index)].name);
      case Number::Kind::input:
        return of_scene(scene_.inputs[static_cast<std::size_t>(number.index)].name);
      case Number::Kind::expression:
        break;
    }
    const scene::Expression& expression = scene_.expressions[static_cast<std::size_t>(number.index)];
    return latex_ ? latex_formula(scene_, expression) : expression.text;
  }

  // At the start, with the defaults of parameters and inputs. Expressions to six digits: the last ones of their
  // functions are not the same on every machine.
  std::string value(const Number& number) const {
    switch (number.kind) {
      case Number::Kind::constant:
        return written(number);
      case Number::Kind::parameter:
        return written(Number::constant(scene_.parameters[static_cast<std::size_t>(number.index)].value));
      case Number::Kind::input:
        return written(Number::constant(scene_.inputs[static_cast<std::size_t>(number.index)].value));
      case Number::Kind::expression:
        break;
    }
    const double result = at_start(scene_.expressions[static_cast<std::size_t>(number.index)]);
    if (!std::isfinite(result)) return latex_ ? "\\text{none}" : "none";
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(), result, std::chars_format::scientific, 5).ptr;
    double rounded = 0.0;
    std::from_chars(digits.begin(), end, rounded);
    return written(Number::constant(rounded + 0.0));
  }

  template <class Text>
  static std::string vector(const scene::Vector& v, Text text) {
    return "(" + text(v[0]) + ", " + text(v[1]) + ", " + text(v[2]) + ")";
  }

 private:
  std::string of_scene(const std::string& name) const { return latex_ ? latex_name(name) : name; }

  double at_start(scene::Expression expression) const {
    using NodeKind = scene::ExpressionNode::Kind;
    for (scene::ExpressionNode& node : expression.nodes) {
      const auto at = static_cast<std::size_t>(node.index);
      if (node.kind == NodeKind::coordinate)
        node = {.kind = NodeKind::number, .value = x_[at]};
      else if (node.kind == NodeKind::speed)
        node = {.kind = NodeKind::number, .value = y_[at]};
      else if (node.kind == NodeKind::input)
        node = {.kind = Kind::number, .value = scene_.inputs[at].value};
    }
    return static_cast<double>(scene::value(expression, scene_.parameters));
  }

  const scene::Scene& scene_;
  bool latex_;
  std::vector<double> x_, y_;
};

class LoadLines {
 public:
  LoadLines(const symbolic::Equations& equations, Style style)
      : scene_(equations.scene), words_(equations.scene, style) {}

  std::vector<std::vector<std::string>> all() {
    for (int k = 1; k <= size(scene_); ++k) add_own(k);
    for (const Load& load : scene_.loads) {
      load_ = load.name;
      add(load);
    }
    return std::move(lines_);
  }

 private:
  void add_own(int k) {
    const scene::Body& body = scene_.bodies[static_cast<std::size_t>(k - 1)];
    const std::string number = std::to_string(k);
    load_ = body.name;
    where_ = words_.body(k) + " at its mass centre, inertial axes";
    add("F" + number, "F_{" + number + "}", body.force, "N");
    where_ = words_.body(k) + ", its axes";
    add("M" + number, "M_{" + number + "}", body.moment, "N m");
  }

  void add(const Load& load) {
    switch (load.kind) {
      case Load::Kind::force:
      case Load::Kind::moment:
        return add_vector(load);
      case Load::Kind::joint:
        return add_joint(load);
      case Load::Kind::spring:
        break;
    }
    where_ = "between " + place(load.point, load.name) + " and " + place(load.other, load.name + "_other");
    add_line("k", load.stiffness, "N/m");
    add_line("c", load.damping, "N s/m");
    add_line("l", load.rest, "m");
  }

  void add_vector(const Load& load) {
    const bool is_force = load.kind == Load::Kind::force;
    where_ = is_force ? place(load.point, load.name) : words_.body(load.point.body);
    const int below = scene_.lower[static_cast<std::size_t>(load.point.body - 1)];
    where_ += load.axes == scene::Axes::inertial || (load.axes == scene::Axes::lower && below == 0)
                  ? ", inertial axes"
                  : ", axes of " + words_.body(load.axes == scene::Axes::body ? load.point.body : below);
    if (load.reaction >= 0) where_ += "; the opposite on " + words_.body(load.reaction);
    const symbolic::LoadLetter letter = symbolic::load_letter(is_force ? "F" : "M", load.name);
    add(letter.name, letter.latex, load.vector, is_force ? "N" : "N m");
  }

  void add_joint(const Load& load) {
    const scene::Joint& joint = scene_.bodies[static_cast<std::size_t>(load.point.body - 1)].joint;
    const scene::Component along{load.turn ? scene::Component::Kind::turn : scene::Component::Kind::slide,
                                 load.point.body, load.coordinate,
                                 static_cast<int>((load.turn ? joint.turns : joint.slides).size())};
    where_ =
        "joint of " + words_.body(load.point.body) + ", along " + words_.name(coordinate_name_by_body(scene_, along));
    add_line("tau", load.effort, load.turn ? "N m" : "N");
    add_line("k", load.stiffness, load.turn ? "N m/rad" : "N/m");
    add_line("c", load.damping, load.turn ? "N m s/rad" : "N s/m");
    add_line("l", load.rest, load.turn ? "rad" : "m");
  }

  // "body 2 (arm) at r_push_ = (0, 0, 0.1) m, body axes"; a body's origin without numbers.
  std::string place(const scene::Point& point, const std::string& name) const {
    if (scene::is_zero(point.r))
      return words_.body(point.body) + (point.body == 0 ? " at the origin" : " at its origin");
    const symbolic::LoadLetter letter = symbolic::load_letter("r", name);
    const std::string r = words_.vector(point.r, [this](const Number& n) { return words_.written(n); });
    return words_.body(point.body) + " at " +
           words_.formula((words_.latex() ? letter.latex : letter.name) + " = " + r) + (words_.latex() ? "~m" : " m");
  }

  void add(const std::string& name, const std::string& latex, const scene::Vector& v, const std::string& unit) {
    if (scene::is_zero(v)) return;
    line(words_.latex() ? latex : name, words_.vector(v, [this](const Number& n) { return words_.written(n); }),
         words_.vector(v, [this](const Number& n) { return words_.value(n); }), unit);
  }

  void add_line(const std::string& letter, const Number& number, const std::string& unit) {
    if (number.is_zero()) return;
    const symbolic::LoadLetter named = symbolic::load_letter(letter, load_);
    line(words_.latex() ? named.latex : named.name, words_.written(number), words_.value(number), unit);
  }

  void line(const std::string& letter, const std::string& written, const std::string& value, const std::string& unit) {
    lines_.push_back(
        {words_.name(load_), where_, words_.formula(letter), words_.formula(written), words_.formula(value), unit});
  }

  const scene::Scene& scene_;
  Words words_;
  std::string load_, where_;
  std::vector<std::vector<std::string>> lines_;
};

bool is_free(const scene::Scene& scene, const scene::Component& c) {
  const scene::Coordinate* coordinate = coordinate_of(scene, c);
  return !coordinate || coordinate->motion == scene::Coordinate::Motion::free;
}

// What a coordinate that is not in the state is locked at, or prescribed as, is told with its name.
std::string coordinate_of(const scene::Scene& scene, const Words& words, const scene::Component& c) {
  const std::string name = words.name(coordinate_name_by_body(scene, c));
  if (is_free(scene, c)) return name;
  const scene::Coordinate& coordinate = *coordinate_of(scene, c);
  if (coordinate.motion == scene::Coordinate::Motion::locked)
    return name + " = " + words.formula(words.written(Number::constant(coordinate.value)));
  return name + " = " + words.formula(words.written(Number::expression(coordinate.expression)));
}

// One kind of a joint's components: "s_hub_1 to 3" where all of them are in the state.
std::string coordinates_of(const scene::Scene& scene, const Words& words, const std::vector<scene::Component>& list) {
  const bool all_free =
      std::all_of(list.begin(), list.end(), [&](const scene::Component& c) { return is_free(scene, c); });
  if (all_free && list.size() > 1)
    return coordinate_of(scene, words, list.front()) + " to " + std::to_string(list.size());
  std::string text;
  for (const scene::Component& c : list) text += (text.empty() ? "" : ", ") + coordinate_of(scene, words, c);
  return text;
}

// What a body's joint moves by.
std::string coordinates_of(const scene::Scene& scene, const Words& words, int body) {
  using PartKind = scene::Component::Kind;
  std::string text;
  for (const PartKind kind : {PartKind::attitude, PartKind::turn, PartKind::slide}) {
    std::vector<scene::Component> list;
    for (const scene::Component& c : scene::components(scene))
      if (c.body == body && c.kind == kind) list.push_back(c);
    if (list.empty()) continue;
    const bool is_held = kind == PartKind::attitude && scene.bodies[static_cast<std::size_t>(body - 1)].joint.held;
    text += (text.empty() ? "" : ", ") + (is_held ? "attitude held" : coordinates_of(scene, words, list));
  }
  return text.empty() ? "none" : text;
}

}  // namespace

std::vector<std::vector<std::string>> without_repetition(const Grid& grid) {
  std::vector<std::vector<std::string>> lines = grid.lines;
  for (std::size_t i = lines.size(); i-- > 1;)
    for (std::size_t j = 0; j < 2 && lines[i][j] == lines[i - 1][j]; ++j) lines[i][j].clear();
  return lines;
}

Grid body_grid(const symbolic::Equations& equations, Style style) {
  const scene::Scene& scene = equations.scene;
  const Words words(scene, style);
  Grid grid{"Bodies", "", {{"K", 0.04}, {"name", 0.22}, {"joint", 0.12}, {"coordinates", 0.54}}, {}};
  for (int k = 1; k <= size(scene); ++k) {
    const scene::Body& body = scene.bodies[static_cast<std::size_t>(k - 1)];
    grid.lines.push_back(
        {std::to_string(k), words.name(body.name), words.name(body.joint.kind), coordinates_of(scene, words, k)});
  }
  return grid;
}

Grid load_grid(const symbolic::Equations& equations, Style style) {
  const bool latex = style == Style::latex;
  return {
      "Loads, besides gravity",
      latex ? "Along a joint acts $\\tau - k\\,(x - l) - c\\,\\dot x$, where $x$ is the coordinate; a spring between "
              "points "
              "draws them together with $k\\,(x - l) + c\\,\\dot x$, where $x$ is its length."
            : "Along a joint acts tau - k (x - l) - c xdot, where x is the coordinate; a spring between points draws "
              "them together with k (x - l) + c xdot, where x is its length.",
      {{"load", 0.11}, {"where it acts", 0.27}, {"letter", 0.12}, {"is", 0.2}, {"at the start", 0.12}, {"unit", 0.09}},
      LoadLines(equations, style).all()};
}

}  // namespace kanec::emit
