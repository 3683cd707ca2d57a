// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/random_numbers.hpp"

#include "tests/support/random_expression.hpp"

namespace kanec::test {

using scene::Number;

std::string RandomNumbers::own_name(const std::string& name) const {
  const std::size_t before = scene_.parameters.size() + scene_.inputs.size();
  return before < options_.names.size() ? options_.names[before] : name;
}

Number RandomNumbers::number(const std::string& name, double value) {
  if (!random_.chance(options_.parameter_share)) return Number::constant(value);
  scene_.parameters.push_back({own_name(name), value});
  return Number::parameter(static_cast<int>(scene_.parameters.size()) - 1);
}

Number RandomNumbers::number_or_zero(const std::string& name, double range) {
  const double value = random_.uniform(-range, range);
  return random_.chance(options_.zero_share) ? Number::constant(0) : number(name, value);
}

scene::Vector RandomNumbers::vector(const std::string& name, double range) {
  return {number_or_zero(name + "_1", range), number_or_zero(name + "_2", range), number_or_zero(name + "_3", range)};
}

Number RandomNumbers::load_entry(const std::string& name, double low, double high) {
  if (!random_.chance(options_.input_share)) {
    const double value = random_.uniform(low, high);
    return random_.chance(options_.zero_share) ? Number::constant(0) : number(name, value);
  }
  scene_.inputs.push_back({own_name(name), random_.uniform(low, high)});
  return Number::input(static_cast<int>(scene_.inputs.size()) - 1);
}

scene::Vector RandomNumbers::load(const std::string& name, double range) {
  return {load_entry(name + "_1", -range, range), load_entry(name + "_2", -range, range),
          load_entry(name + "_3", -range, range)};
}

Number RandomNumbers::magnitude(const std::string& name, double low, double high) {
  if (options_.expression_share > 0 && random_.chance(options_.expression_share)) return expression(high);
  return load_entry(name, low, high);
}

void RandomNumbers::some_to_expressions(scene::Vector& vector, double range) {
  for (Number& entry : vector)
    if (entry.kind == Number::Kind::constant && random_.chance(options_.expression_share)) entry = expression(range);
}

Number RandomNumbers::expression(double size) {
  scene_.expressions.push_back(random_expression(random_, scene_, size));
  return Number::expression(static_cast<int>(scene_.expressions.size()) - 1);
}

// Four mass points and a small ball: positive definite and within the triangle inequality by construction. Without the
// products of inertia the diagonal still is.
scene::Symmetric RandomNumbers::inertia(const std::string& name, double m) {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  for (int point = 0; point < 4; ++point) {
    const double a = random_.uniform(-0.5, 0.5);
    const double b = random_.uniform(-0.5, 0.5);
    const double c = random_.uniform(-0.5, 0.5);
    xx += m / 4 * (b * b + c * c), yy += m / 4 * (a * a + c * c), zz += m / 4 * (a * a + b * b);
    xy -= m / 4 * a * b, xz -= m / 4 * a * c, yz -= m / 4 * b * c;
  }
  const double ball = 0.1 * m;
  scene::Symmetric I;
  I.xx = number(name + "_xx", xx + ball);
  I.yy = number(name + "_yy", yy + ball);
  I.zz = number(name + "_zz", zz + ball);
  if (random_.chance(options_.zero_share)) return I;
  I.xy = number(name + "_xy", xy);
  I.xz = number(name + "_xz", xz);
  I.yz = number(name + "_yz", yz);
  return I;
}

}  // namespace kanec::test
