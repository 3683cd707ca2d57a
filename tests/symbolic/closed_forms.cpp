// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/symbolic/closed_forms.hpp"

#include "tests/support/random_scene.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

void set(Blocks& blocks, int column, const ex& block) {
  if (!block.is_zero()) blocks[column] = block;
}

}  // namespace

ClosedForms closed_forms(const Equations& equations) {
  const int n = size(equations.scene);
  const auto& letters = equations.letters;
  const auto at = [](int k) { return static_cast<std::size_t>(k); };
  const auto lower = [&](int k) { return equations.scene.lower[at(k - 1)]; };
  const auto omega_of = [&](int k) { return lower(k) == 0 ? ex(0) : letters[at(lower(k))].omega; };
  ClosedForms forms;
  for (int k = 1; k <= n; ++k) {
    const Letters& own = letters[at(k)];
    ex centre = own.to_inertial * own.r;
    Blocks v_y, v_y_dot;
    set(v_y, k - 1, -own.to_inertial * skew(own.r));
    set(v_y_dot, k - 1, -own.to_inertial * skew(own.omega) * skew(own.r));
    // j runs down the path; c is the body just above it
    for (int j = k, c = 0; j != 0; c = j, j = lower(j)) {
      const Letters& body = letters[at(j)];
      const Letters& below = letters[at(lower(j))];
      centre += below.to_inertial * (body.offset + body.s);
      set(v_y, n + j - 1, below.to_inertial);
      set(v_y_dot, n + j - 1, below.to_inertial * skew(omega_of(j)));
      if (j == k) continue;
      const Letters& above = letters[at(c)];
      const ex d = skew(above.offset) + skew(above.s);
      set(v_y, j - 1, -body.to_inertial * d);
      set(v_y_dot, j - 1, -body.to_inertial * (skew(body.omega) * d + skew(above.sdot)));
    }
    forms.centre.push_back(centre);
    forms.v_y.push_back(v_y);
    forms.v_y_dot.push_back(v_y_dot);
  }
  return forms;
}

ex written_out(const Equations& equations, const ex& e) {
  GiNaC::exmap names;
  for (const Quantity& quantity : equations.quantities) {
    const std::string& name = equations.table.of(quantity.symbol).name;
    if (name == "d" || name == "P" || name == "p" || name == "Pdot" || name == "v")
      names[quantity.symbol] = quantity.value.subs(names, GiNaC::subs_options::no_pattern);
  }
  return sum(expanded(e.subs(names, GiNaC::subs_options::no_pattern)));
}

namespace {

// ã b = -b̃ a at the end of products, in one of the two ways.
ex with_ordered_cross_products(const ex& e) {
  std::vector<Term> terms = expanded(e);
  for (Term& term : terms) {
    const std::size_t n = term.factors.size();
    if (n < 2 || !is_ex_the_function(term.factors[n - 2], skew) || !GiNaC::is_a<Atom>(term.factors[n - 1])) continue;
    const ex a = term.factors[n - 2].op(0);
    const ex b = term.factors[n - 1];
    if (shape_of(b) != Shape::vector || GiNaC::ex_to<Atom>(a).index() <= GiNaC::ex_to<Atom>(b).index()) continue;
    term.scalar = -term.scalar;
    term.factors[n - 2] = skew(b);
    term.factors[n - 1] = a;
  }
  return sum(terms).expand();
}

}  // namespace

bool are_equal(const Equations& equations, const ex& a, const ex& b) {
  return with_ordered_cross_products(written_out(equations, a) - written_out(equations, b)).is_zero();
}

ex rate_of_letter(const Equations& equations, const Atom& atom) {
  for (const Letters& body : equations.letters) {
    const ex& letter = equations.table.of(atom).atom;
    if (letter.is_equal(body.to_inertial)) return body.to_inertial * skew(body.omega);
    if (letter.is_equal(body.s)) return body.sdot;
    for (const Coordinate& c : body.coordinates)
      if (letter.is_equal(c.speed)) return c.acceleration;
  }
  return 0;
}

std::vector<scene::Scene> sample_scenes() {
  test::Random random(20);
  std::vector<scene::Scene> scenes;
  for (const std::vector<int>& lower :
       {std::vector<int>{0, 1, 2, 2, 1, 5}, {0, 1, 2, 3, 4}, {0, 1, 1, 1, 1}, {0, 0, 0}})
    scenes.push_back(test::random_scene(random, lower));
  for (int n_bodies = 1; n_bodies <= 12; ++n_bodies)
    for (const bool forest : {false, true}) {
      scenes.push_back(test::random_scene(random, test::random_connection(random, n_bodies, forest)));
      scene::Scene sparse = scenes.back();
      for (scene::Body& body : sparse.bodies)
        for (scene::Vector* vector : {&body.r, &body.q})
          if (random.chance(0.4)) *vector = {};
      scenes.push_back(sparse);
    }
  return scenes;
}

}  // namespace kanec::symbolic
