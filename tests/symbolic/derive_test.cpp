// Positions, velocities and partial velocities that the generator derives. Oracle: the closed forms of the text, and
// the product rule on them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/derive.hpp"

#include <gtest/gtest.h>

#include "tests/symbolic/closed_forms.hpp"

namespace kanec::symbolic {
namespace {

using GiNaC::ex;

class Derive : public testing::Test {
 protected:
  // Calls test(equations, closed forms, K) for every body of every scene.
  template <class Test>
  static void for_bodies(Test test) {
    for (const scene::Scene& scene : sample_scenes()) {
      const Equations equations = derive(scene);
      const ClosedForms forms = closed_forms(equations);
      for (std::size_t k = 0; k < scene.bodies.size(); ++k) test(equations, forms, k);
    }
  }

  static void expect_equal(const Equations& equations, const Blocks& derived, const Blocks& closed) {
    ASSERT_EQ(derived.size(), closed.size());
    for (const auto& [column, block] : closed) {
      ASSERT_EQ(derived.count(column), 1u) << "column " << column;
      EXPECT_TRUE(are_equal(equations, derived.at(column), block)) << derived.at(column) << "  for  " << block;
    }
  }

  // Σ block · speed over the columns.
  static ex times(const Equations& equations, const Blocks& blocks, bool rates) {
    ex result = 0;
    for (const auto& [column, block] : blocks) {
      const Speed& speed = equations.speeds[static_cast<std::size_t>(column)];
      for (const Coordinate& c : equations.letters[static_cast<std::size_t>(speed.link)].coordinates)
        if (c.column == column) result += block * (rates ? c.acceleration : c.speed);
    }
    return result;
  }
};

TEST_F(Derive, positions_have_the_closed_form) {
  for_bodies([](const Equations& equations, const ClosedForms& forms, std::size_t k) {
    EXPECT_TRUE(are_equal(equations, equations.tables.centre[k], forms.centre[k]));
  });
}

TEST_F(Derive, velocity_is_the_time_derivative_of_the_position) {
  for_bodies([](const Equations& equations, const ClosedForms& forms, std::size_t k) {
    const auto rate = [&](const Atom& atom) { return rate_of_letter(equations, atom); };
    EXPECT_TRUE(are_equal(equations, equations.tables.velocity[k], time_derivative(forms.centre[k], rate)));
  });
}

TEST_F(Derive, partial_velocities_have_the_closed_form_and_no_other_blocks) {
  for_bodies([](const Equations& equations, const ClosedForms& forms, std::size_t k) {
    expect_equal(equations, equations.tables.v_y[k], forms.v_y[k]);
  });
}

TEST_F(Derive, partial_velocity_rates_have_the_closed_form_and_no_other_blocks) {
  for_bodies([](const Equations& equations, const ClosedForms& forms, std::size_t k) {
    expect_equal(equations, equations.tables.v_y_dot[k], forms.v_y_dot[k]);
  });
}

TEST_F(Derive, partial_angular_velocities_are_the_identity_and_constant) {
  for_bodies([](const Equations& equations, const ClosedForms&, std::size_t k) {
    const Blocks& blocks = equations.tables.omega_y[k];
    ASSERT_EQ(blocks.size(), 1u);
    EXPECT_EQ(blocks.begin()->first, static_cast<int>(k));
    EXPECT_TRUE(blocks.begin()->second.is_equal(1));
    EXPECT_TRUE(equations.tables.omega_y_dot[k].empty());
  });
}

TEST_F(Derive, velocity_is_the_partial_velocities_times_the_speeds) {
  for_bodies([](const Equations& equations, const ClosedForms&, std::size_t k) {
    const ex v = times(equations, equations.tables.v_y[k], false);
    EXPECT_TRUE(are_equal(equations, equations.tables.velocity[k], v));
  });
}

// D(v_y y) = v_y ẏ + v̇_y y
TEST_F(Derive, acceleration_is_partial_velocities_times_rates_and_their_rates_times_speeds) {
  for_bodies([](const Equations& equations, const ClosedForms&, std::size_t k) {
    const auto rate = [&](const Atom& atom) { return rate_of_letter(equations, atom); };
    const ex a = time_derivative(written_out(equations, equations.tables.velocity[k]), rate);
    const ex by_parts =
        times(equations, equations.tables.v_y[k], true) + times(equations, equations.tables.v_y_dot[k], false);
    EXPECT_TRUE(are_equal(equations, a, by_parts));
  });
}

TEST_F(Derive, every_quantity_stands_after_the_ones_that_it_is_written_in) {
  for (const scene::Scene& scene : sample_scenes()) {
    const Equations equations = derive(scene);
    GiNaC::exset known;
    const auto check = [&](const ex& e, const auto& self) -> void {
      if (!GiNaC::is_a<Atom>(e)) {
        for (const ex& operand : e) self(operand, self);
        return;
      }
      const Symbol& symbol = equations.table.of(e);
      const bool is_known = known.count(e) > 0 || known.count(symbol.transpose) > 0;
      EXPECT_TRUE(symbol.role != Role::quantity || is_known) << symbol.atom;
    };
    for (const Quantity& quantity : equations.quantities) {
      check(quantity.value, check);
      EXPECT_TRUE(known.insert(quantity.symbol).second) << quantity.symbol;
    }
    for (const Function& function : equations.functions)
      for (const Output& output : function.outputs) check(output.block, check);
  }
}

TEST_F(Derive, no_name_stands_for_zero_or_for_another_letter) {
  for (const scene::Scene& scene : sample_scenes())
    for (const Quantity& quantity : derive(scene).quantities) {
      EXPECT_FALSE(quantity.value.is_zero()) << quantity.symbol;
      EXPECT_FALSE(GiNaC::is_a<Atom>(quantity.value)) << quantity.symbol;
    }
}

}  // namespace
}  // namespace kanec::symbolic
