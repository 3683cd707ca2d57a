// The letters of every link and body: coordinates, attitudes, angular velocities, and the numbers of the bodies.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/derivation.hpp"
#include "generator/symbolic/relative_rotations.hpp"

namespace kanec::symbolic {

using GiNaC::ex;
using scene::Number;

namespace {

std::vector<Number> entries(const scene::Axis& a) {
  return {Number::constant(a[0]), Number::constant(a[1]), Number::constant(a[2])};
}

std::vector<Number> entries(const scene::Vector& v) { return {v[0], v[1], v[2]}; }

std::vector<Number> entries(const scene::Symmetric& m) {
  return {m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz};
}

std::vector<Number> entries(const scene::Rotation& a) {
  std::vector<Number> result;
  for (const auto& row : a)
    for (const double entry : row) result.push_back(Number::constant(entry));
  return result;
}

bool is_zero(const scene::Symmetric& m) {
  return m.xx.is_zero() && m.yy.is_zero() && m.zz.is_zero() && m.xy.is_zero() && m.xz.is_zero() && m.yz.is_zero();
}

class Definition {
 public:
  explicit Definition(Derivation& derivation)
      : derivation_(derivation), equations_(derivation.equations), table_(equations_.table) {}

  void all() {
    equations_.gravity = scene::is_zero(equations_.scene.gravity)
                             ? ex(0)
                             : table_.add_numbers("g", "g", "", entries(equations_.scene.gravity));
    equations_.letters.emplace_back();
    for (int j = 1; j <= equations_.mechanism.size(); ++j) add_link(j);
    number_columns();
    equations_.bodies.emplace_back();
    for (int k = 1; k <= derivation_.n_bodies(); ++k) add_body(k);
    for (int j = 1; j <= equations_.mechanism.size(); ++j) add_mass(j);
  }

 private:
  const scene::Body& scene_body(int k) const { return equations_.scene.bodies[static_cast<std::size_t>(k - 1)]; }
  Letters& letters(int j) { return equations_.letters[static_cast<std::size_t>(j)]; }

  void add_link(int j) {
    equations_.letters.emplace_back();
    const Link& link = equations_.mechanism.link(j);
    letters(j).offset = offset_of(link.offset, "q", link.suffix, j);
    add_slides(j);
    switch (link.turning) {
      case Link::Turning::ball:
        add_ball(j);
        break;
      case Link::Turning::held:
        add_held(j);
        break;
      default:
        add_turning(j);
    }
    if (link.pitch != 0) add_advance(j);
  }

  // --- letters of coordinates

  // A scalar coordinate in the state has three letters, a prescribed one three expressions, a locked one a number.
  Coordinate scalar(const Freedom& freedom, int j, const scene::Coordinate& of, int at_x, int at_y,
                    const std::string& letter, const std::string& latex, const std::string& component) {
    const std::string suffix = equations_.mechanism.link(j).suffix;
    const std::string number = std::to_string(equations_.mechanism.link(j).body) + component;
    const std::string dot = "\\dot " + latex, ddot = "\\ddot " + latex;
    Coordinate result{
        freedom,
        0,
        0,
        0,
        table_.add_numbers(freedom.kind == Freedom::Kind::turn ? "b" : "u",
                           freedom.kind == Freedom::Kind::turn ? "b" : "u", number, entries(freedom.axis)),
        -1,
        -1};
    if (of.motion == scene::Coordinate::Motion::locked) {
      result.value = table_.add_numbers(letter, latex, number, {Number::constant(of.value)});
    } else if (of.motion == scene::Coordinate::Motion::prescribed) {
      const auto rate = [&](const std::string& name, const std::string& tex, int order) {
        return define_scalar(name, tex, number, j, expression(of.expression, order));
      };
      result.value = rate(letter, latex, 0);
      result.speed = rate(letter + "dot", dot, 1);
      result.acceleration = rate(letter + "ddot", ddot, 2);
      derivation_.rates.set(result.value, result.speed);
      derivation_.rates.set(result.speed, result.acceleration);
    } else {
      result.value = table_.add_state(Role::x, letter, latex, number, Shape::scalar, at_x);
      result.speed = table_.add_state(Role::y, letter + "dot", dot, number, Shape::scalar, at_y);
      result.acceleration = table_.add_state(Role::ydot, letter + "ddot", ddot, number, Shape::scalar, at_y);
      result.row = at_y;
      set_rates(result);
    }
    return result;
  }

  void set_rates(const Coordinate& c) {
    derivation_.rates.set(c.value, c.speed);
    derivation_.rates.set(c.speed, c.acceleration);
  }

  ex define_scalar(const std::string& name, const std::string& latex, const std::string& suffix, int j,
                   const ex& value) {
    const ex symbol = table_.add(Role::quantity, name, latex, suffix, Shape::scalar);
    equations_.quantities.push_back({symbol, value, equations_.mechanism.link(j).body, Pass::outward, "prescribed"});
    return symbol;
  }

  static std::string component(std::size_t of, int i) { return of == 1 ? "" : "_" + std::to_string(i + 1); }

  void add_slides(int j) {
    const Link& link = equations_.mechanism.link(j);
    const scene::Joint& joint = scene_body(link.body).joint;
    const scene::BodyLayout& at = equations_.layout.bodies[static_cast<std::size_t>(link.body - 1)];
    Letters& l = letters(j);
    for (const Freedom& freedom : link.freedoms) {
      const auto i = static_cast<std::size_t>(freedom.coordinate);
      if (freedom.kind == Freedom::Kind::translation) {
        add_translation(l, freedom, link.suffix, at.s[0], at.sdot[0]);
      } else if (freedom.kind == Freedom::Kind::slide) {
        l.coordinates.push_back(scalar(freedom, j, joint.slides[i], at.s[i], at.sdot[i], "s", "s",
                                       component(joint.slides.size(), freedom.coordinate)));
        const Coordinate& slide = l.coordinates.back();
        l.s += slide.value * slide.axis;
        l.sdot += slide.speed * slide.axis;
      }
    }
  }

  // A screw moves along its axis as it turns.
  void add_advance(int j) {
    const Link& link = equations_.mechanism.link(j);
    Letters& l = letters(j);
    const Coordinate& turn = l.coordinates.front();
    l.pitch = table_.add_numbers("pitch", "\\operatorname{pitch}", link.suffix, {Number::constant(link.pitch)});
    const ex axis = table_.add_numbers("u", "u", link.suffix, entries(link.freedoms.front().axis));
    l.s += l.pitch * turn.value * axis;
    l.sdot += l.pitch * turn.speed * axis;
  }

  void add_translation(Letters& l, const Freedom& freedom, const std::string& suffix, int at_x, int at_y) {
    l.s = table_.add_state(Role::x, "s", "s", suffix, Shape::vector, at_x);
    l.sdot = table_.add_state(Role::y, "sdot", "\\dot s", suffix, Shape::vector, at_y);
    const ex sddot = table_.add_state(Role::ydot, "sddot", "\\ddot s", suffix, Shape::vector, at_y);
    l.coordinates.push_back({freedom, l.s, l.sdot, sddot, 0, at_y, -1});
    set_rates(l.coordinates.back());
  }

  // --- attitudes

  void pair_of_attitude(int j, const std::string& name, const std::string& latex, ex& transposed, ex& plain) {
    const std::string suffix = equations_.mechanism.link(j).suffix;
    transposed = table_.add(Role::quantity, name + "t", latex, suffix, Shape::matrix);
    plain = table_.add(Role::quantity, name, latex, suffix, Shape::matrix);
    table_.pair(plain, transposed);
  }

  void add_quantity(const ex& symbol, const ex& value, int j, const std::string& meaning) {
    equations_.quantities.push_back({symbol, value, equations_.mechanism.link(j).body, Pass::outward, meaning});
  }

  void add_ball(int j) {
    const Link& link = equations_.mechanism.link(j);
    const scene::BodyLayout& at = equations_.layout.bodies[static_cast<std::size_t>(link.body - 1)];
    Letters& l = letters(j);
    pair_of_attitude(j, "R", "R", l.to_inertial, l.to_body);
    l.turns_with_lower = false;
    l.e = table_.add_state(Role::x, "e", "e", link.suffix, Shape::vector, at.eps);
    l.eps4 = table_.add_state(Role::x, "eps4_", "\\varepsilon_{4}^{(#)}", link.suffix, Shape::scalar, at.eps + 3);
    l.omega = table_.add_state(Role::y, "omega", "\\omega", link.suffix, Shape::vector, at.omega);
    const ex omegadot = table_.add_state(Role::ydot, "omegadot", "\\dot\\omega", link.suffix, Shape::vector, at.omega);
    l.coordinates.insert(l.coordinates.begin(), {link.freedoms.front(), 0, l.omega, omegadot, 0, at.omega, -1});
    derivation_.rates.set(l.omega, omegadot);
    set_rotation_rates(l.to_inertial, l.to_body, l.omega);
    add_quantity(l.to_inertial, rotation(l.e, l.eps4), j,
                 "R takes inertial components to body components; e = (eps_1, eps_2, eps_3)");
    const bool is_free = link.freedoms.size() == 2 && link.freedoms.back().kind == Freedom::Kind::translation;
    if (derivation_.way.axes == Axes::body && !is_free && !letters(link.lower).to_body.is_equal(1)) add_relative(j);
  }

  // C_K = R_K R_Lᵀ of a ball, through the product of the two sets of Euler parameters where the lower body has some: R
  // itself is then needed by nothing but what acts in inertial axes.
  void add_relative(int j) {
    const Letters& lower = letters(equations_.mechanism.link(j).lower);
    Letters& l = letters(j);
    ex transposed, plain;
    pair_of_attitude(j, "C", "C", transposed, plain);
    ex value = lower.to_body * l.to_inertial;
    if (!lower.e.is_zero()) {
      const ex e =
          derivation_.define("erel", "e'", j, Pass::outward, lower.eps4 * l.e - l.eps4 * lower.e - skew(lower.e) * l.e,
                             "Euler parameters relative to the lower body");
      const ex eps4 = derivation_.define("eps4rel", "\\varepsilon_{4}^{\\prime\\,(#)}", j, Pass::outward,
                                         lower.eps4 * l.eps4 + dot(lower.e, l.e), "");
      value = rotation(e, eps4);
    }
    add_quantity(transposed, value, j, "C takes components in the lower body to those in the body");
    derivation_.rates.set(transposed, transposed * skew(l.omega) - skew(lower.omega) * transposed);
    derivation_.rates.set(plain, plain * skew(lower.omega) - skew(l.omega) * plain);
    equations_.joint_rotations.add(lower.to_body, l.to_inertial, transposed);
    equations_.joint_rotations.add(l.to_body, lower.to_inertial, plain);
  }

  void set_rotation_rates(const ex& transposed, const ex& plain, const ex& omega) {
    derivation_.rates.set(transposed, transposed * skew(omega));
    derivation_.rates.set(plain, -skew(omega) * plain);
  }

  void add_held(int j) {
    const Link& link = equations_.mechanism.link(j);
    Letters& l = letters(j);
    l.turns_with_lower = false;
    if (!is_identity(link.zero)) constant_rotation(link.zero, "R", "R", link.suffix, l.to_inertial, l.to_body);
    if (!link.freedoms.empty() && link.freedoms.front().kind == Freedom::Kind::attitude)
      l.coordinates.insert(l.coordinates.begin(), {link.freedoms.front(), 0, 0, 0, 0, -1, -1});
  }

  // Letters of a constant rotation and of its transpose.
  void constant_rotation(const scene::Rotation& a, const std::string& name, const std::string& latex,
                         const std::string& suffix, ex& itself, ex& transpose) {
    scene::Rotation other;
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) other[c][r] = a[r][c];
    itself = table_.add_numbers(name + "t", latex, suffix, entries(a));
    transpose = table_.add_numbers(name, latex, suffix, entries(other));
    table_.pair(transpose, itself);
  }

  // E of a turn about an axis, then R = E R_L and ω = E ω_L + b θ̇.
  void add_turning(int j) {
    const Link& link = equations_.mechanism.link(j);
    const Letters lower = letters(link.lower);
    Letters& l = letters(j);
    ex spin = 0;
    if (link.turning == Link::Turning::turn) {
      add_turn(j);
      spin = l.coordinates.front().speed * l.coordinates.front().axis;
    }
    if (l.to_lower.is_equal(1)) {  // axes of the lower link
      l.to_inertial = lower.to_inertial;
      l.to_body = lower.to_body;
      l.omega = lower.omega;
      return;
    }
    if (!spin.is_zero()) set_rotation_rates(l.to_lower, l.from_lower, spin);
    add_absolute(j, lower);
    l.omega_value = l.from_lower * lower.omega + spin;
    l.omega = derivation_.define("omega", "\\omega", j, Pass::outward, l.omega_value,
                                 "absolute angular velocity, body axes [rad/s]");
    if (GiNaC::is_a<Atom>(l.omega)) set_rotation_rates(l.to_inertial, l.to_body, l.omega);
  }

  void add_turn(int j) {
    const Link& link = equations_.mechanism.link(j);
    const Freedom& freedom = link.freedoms.front();
    const auto i = static_cast<std::size_t>(freedom.coordinate);
    const scene::Joint& joint = scene_body(link.body).joint;
    const scene::BodyLayout& at = equations_.layout.bodies[static_cast<std::size_t>(link.body - 1)];
    Letters& l = letters(j);
    // the same axis in the link's own axes, where it does not move either
    Freedom own = freedom;
    scene::Rotation back;
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) back[c][r] = link.zero[r][c];
    own.axis = turned(back, freedom.axis);
    l.coordinates.insert(l.coordinates.begin(), scalar(own, j, joint.turns[i], at.theta[i], at.thetadot[i], "theta",
                                                       "\\theta", component(joint.turns.size(), freedom.coordinate)));
    const Coordinate& c = l.coordinates.front();
    pair_of_attitude(j, "E", "E", l.to_lower, l.from_lower);
    ex value = turn(c.axis, c.value);
    if (!is_identity(link.zero)) {
      ex zero, other;
      constant_rotation(link.zero, "Z", "Z", link.suffix, zero, other);
      const bool along_lower = coordinate_axis(freedom.axis) >= 0 && coordinate_axis(own.axis) < 0;
      value = along_lower ? turn(table_.add_numbers("a", "a", link.suffix, entries(freedom.axis)), c.value) * zero
                          : zero * turn(c.axis, c.value);
    }
    add_quantity(l.to_lower, value, j, "E takes components in the lower body to those in the body");
  }

  void add_absolute(int j, const Letters& lower) {
    Letters& l = letters(j);
    if (lower.to_inertial.is_equal(1)) {
      l.to_inertial = l.to_lower;
      l.to_body = l.from_lower;
      return;
    }
    pair_of_attitude(j, "R", "R", l.to_inertial, l.to_body);
    add_quantity(l.to_inertial, lower.to_inertial * l.to_lower, j, "R takes inertial components to body components");
    equations_.joint_rotations.add(l.to_body, lower.to_inertial, l.from_lower);
    equations_.joint_rotations.add(lower.to_body, l.to_inertial, l.to_lower);
  }

  // --- numbers of bodies and links

  ex offset_of(const Offset& offset, const std::string& name, const std::string& suffix, int j) {
    ex value = 0;
    for (const OffsetTerm& term : offset) {
      const std::string index =
          offset.size() == 1 ? suffix : suffix + "_" + std::to_string(&term - offset.data() + 1) + "_";
      const ex vector = table_.add_numbers(name, name, index, entries(term.numbers));
      if (is_identity(term.orientation)) {
        value += vector;
      } else {
        ex orientation, other;
        constant_rotation(term.orientation, "Z" + name, "Z_{" + name + "\\,#}", index, orientation, other);
        value += orientation * vector;
      }
    }
    return derivation_.define(name, name, j, Pass::outward, value, "");
  }

  void add_body(int k) {
    const BodyPlace& place = equations_.mechanism.body(k);
    const scene::Body& body = scene_body(k);
    const std::string suffix = std::to_string(k);
    BodyFrame frame;
    frame.link = place.link;
    if (!is_identity(place.orientation))
      constant_rotation(place.orientation, "C", "C", suffix, frame.orientation, frame.orientation_transposed);
    frame.offset = offset_of(place.offset, "o", suffix, place.link);
    frame.mass = body.mass.is_zero() ? ex(0) : table_.add_numbers("m", "m", suffix, {body.mass});
    frame.r = scene::is_zero(body.r) ? ex(0) : table_.add_numbers("r", "r", suffix, entries(body.r));
    frame.inertia = is_zero(body.inertia) ? ex(0) : table_.add_numbers("I", "I", suffix, entries(body.inertia));
    equations_.bodies.push_back(frame);
  }

  // Mass, mass centre and inertia of all bodies on a link as one.
  void add_mass(int j) {
    Letters& l = letters(j);
    std::vector<const BodyFrame*> heavy;
    for (const int k : equations_.mechanism.carried(j))
      if (!derivation_.body(k).mass.is_zero() || !derivation_.body(k).inertia.is_zero())
        heavy.push_back(&derivation_.body(k));
    const auto inertia_of = [](const BodyFrame& body) {
      const bool is_turned = !body.orientation.is_equal(1) && !body.inertia.is_zero();
      return is_turned ? congruence(body.orientation, body.inertia) : body.inertia;
    };
    const auto define_inertia = [&](const ex& value) {
      return derivation_.define("I_link", "I_{\\mathrm{link}\\,#}", j, Pass::outward, value,
                                "inertia of the link about its mass centre, link axes [kg m^2]", true);
    };
    const auto define_centre = [&](const ex& value) {
      return derivation_.define("r_link", "r_{\\mathrm{link}\\,#}", j, Pass::outward, sum(expanded(value)),
                                "mass centre of the link, link axes [m]");
    };
    const auto& turned = equations_.mechanism.link(j).centre;
    const ex centre =
        turned ? table_.add_numbers("rt", "r'", equations_.mechanism.link(j).suffix, entries(*turned)) : ex(0);
    if (heavy.size() == 1) {
      l.mass = heavy[0]->mass;
      l.r = define_centre(turned ? centre : heavy[0]->offset + heavy[0]->orientation * heavy[0]->r);
      l.inertia = define_inertia(inertia_of(*heavy[0]));
      return;
    }
    ex mass = 0, moment = 0, inertia = 0;
    for (const BodyFrame* body : heavy) {
      mass += body->mass;
      moment += body->mass * (body->offset + body->orientation * body->r);
    }
    l.mass = derivation_.define("m_link", "m_{\\mathrm{link}\\,#}", j, Pass::outward, mass, "mass of the link [kg]");
    if (!l.mass.is_zero()) l.r = define_centre(turned ? centre : moment / l.mass);
    for (const BodyFrame* body : heavy) {
      const ex arm = derivation_.define("arm", "c_{\\mathrm{arm}\\,#}", j, Pass::outward,
                                        sum(expanded(body->offset + body->orientation * body->r - l.r)), "");
      inertia += inertia_of(*body) - body->mass * (skew(arm) * skew(arm));
    }
    l.inertia = define_inertia(inertia);
  }

  void number_columns() {
    for (const bool rotation : {true, false})
      for (int j = 1; j <= equations_.mechanism.size(); ++j)
        for (Coordinate& c : letters(j).coordinates) {
          if (is_rotation(c) != rotation || c.row < 0) continue;
          c.column = static_cast<int>(equations_.speeds.size());
          equations_.speeds.push_back({c.speed, c.row, j});
        }
  }

  Derivation& derivation_;
  Equations& equations_;
  SymbolTable& table_;
};

}  // namespace

void define_letters(Derivation& derivation) { Definition(derivation).all(); }

}  // namespace kanec::symbolic
