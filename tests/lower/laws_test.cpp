// Laws of mechanics that the programs of trees of every joint obey, whatever they were derived from. Oracles: the laws,
// with rates by dual numbers along the motion.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "generator/choice/requests.hpp"
#include "runtime/generic/expression.hpp"
#include "tests/lower/sample.hpp"
#include "tests/support/dual.hpp"

namespace kanec::test {
namespace {

using Real = long double;
using Moving = Dual<Real>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// A tree that moves as its loads and drives tell it.
class Tree {
 public:
  Tree(const scene::Scene& scene, Random& random) : s_(sample_of(scene, random)), at_(arguments<Real>(s_)) {
    std::vector<std::string> names;
    for (const Available& available : available_functions(scene))
      if (available.usual || available.name == "driving_loads") names.push_back(available.name);
    program_ = program_of(scene, names);
    const Vector accelerations = (*this)("accelerations");
    given_ydot_ = at_.ydot;
    at_.ydot.assign(accelerations.begin(), accelerations.end());
  }

  Vector operator()(const std::string& name) const { return vector(evaluate(program_, find(name), at_)); }
  Vector with_given_rates(const std::string& name) const {
    program::Arguments<Real> other = at_;
    other.ydot = given_ydot_;
    return vector(evaluate(program_, find(name), other));
  }
  Vector given_ydot() const { return vector(given_ydot_); }
  Eigen::Index ny() const { return static_cast<Eigen::Index>(at_.y.size()); }
  bool has_power() const { return has("power"); }
  bool has_drives() const { return has("driving_loads"); }

  // Its rate while t runs, x follows kinematics and y the accelerations.
  Vector rate(const std::string& name) const {
    const auto still = [](const std::vector<Real>& v) { return std::vector<Moving>(v.begin(), v.end()); };
    const auto along = [](const std::vector<Real>& v, const Vector& rates) {
      std::vector<Moving> result;
      for (std::size_t i = 0; i < v.size(); ++i) result.emplace_back(v[i], rates[static_cast<Eigen::Index>(i)]);
      return result;
    };
    const program::Arguments<Moving> moving{still(at_.parameters),
                                            along(at_.x, (*this)("kinematics")),
                                            along(at_.y, vector(at_.ydot)),
                                            still(at_.ydot),
                                            still(at_.inputs),
                                            Moving(at_.time, 1)};
    std::vector<Real> rates;
    for (const Moving& entry : evaluate(program_, find(name), moving)) rates.push_back(entry.rate);
    return vector(rates);
  }

  // Rates of the prescribed coordinates, zero of locked ones, in the order of driving_loads.
  Vector driven_rates() const {
    std::vector<Real> rates;
    const auto append = [&](const std::vector<scene::Coordinate>& coordinates) {
      using Motion = scene::Coordinate::Motion;
      for (const scene::Coordinate& one : coordinates)
        if (one.motion != Motion::free) rates.push_back(one.motion == Motion::locked ? 0 : course_rate(one.expression));
    };
    for (const scene::Body& body : s_.scene.bodies) {
      if (body.joint.ball && body.joint.held) rates.insert(rates.end(), 3, 0);
      if (!body.joint.ball) append(body.joint.turns);
    }
    for (const scene::Body& body : s_.scene.bodies) append(body.joint.slides);
    return vector(rates);
  }

 private:
  static Vector vector(const std::vector<Real>& v) {
    return Eigen::Map<const Vector>(v.data(), static_cast<Eigen::Index>(v.size()));
  }
  bool has(const std::string& name) const {
    for (const program::Function& function : program_.functions)
      if (function.name == name) return true;
    return false;
  }
  const program::Function& find(const std::string& name) const {
    for (const program::Function& function : program_.functions)
      if (function.name == name) return function;
    throw std::out_of_range(name);
  }
  Real course_rate(int expression) const {
    const auto leaf = [&](const scene::ExpressionNode& node) {
      if (node.kind == scene::ExpressionNode::Kind::time) return Moving(at_.time, 1);
      return Moving(at_.parameters[static_cast<std::size_t>(node.index)]);
    };
    return generic::value_of<Moving>(s_.scene.expressions[static_cast<std::size_t>(expression)], leaf).rate;
  }

  Sample s_;
  program::Arguments<Real> at_;
  std::vector<Real> given_ydot_;
  program::Program program_;
};

template <class Test>
void for_trees(Test test) {
  for (int n_bodies = 1; n_bodies <= 12; ++n_bodies)
    for (int i = 0; i < 2; ++i) {
      Random random(static_cast<std::uint64_t>(3000 + 2 * n_bodies + i));
      const scene::Scene scene = random_scene(random, n_bodies, everything());
      SCOPED_TRACE(std::to_string(n_bodies) + " bodies, tree " + std::to_string(i));
      test(Tree(scene, random));
    }
}

// Constants that were folded stand in the program as doubles, 1.1e-16 off; a few hundred of them in a sum.
// Measured: below 1e-15.
constexpr Real of_constants = 1e-14;

TEST(Laws, energy_changes_at_the_rate_of_applied_and_driving_power) {
  for_trees([](const Tree& tree) {
    const Vector rate = tree.rate("energy");
    const Real power = tree.has_power() ? tree("power")[0] : 0;
    const Real driving = tree.has_drives() ? tree("driving_loads").dot(tree.driven_rates()) : 0;
    const Real scale = rate.cwiseAbs().sum() + std::abs(power) + std::abs(driving);
    EXPECT_LT(std::abs(rate.sum() - power - driving), of_constants * scale);
  });
}

TEST(Laws, mass_matrix_is_symmetric_and_positive_definite) {
  for_trees([](const Tree& tree) {
    if (tree.ny() == 0) return;
    const Vector flat = tree("mass_matrix");
    const Matrix A = Eigen::Map<const Matrix>(flat.data(), tree.ny(), tree.ny());
    EXPECT_LE((A - A.transpose()).cwiseAbs().maxCoeff(), of_constants * A.cwiseAbs().maxCoeff());
    EXPECT_EQ(A.llt().info(), Eigen::Success);
  });
}

TEST(Laws, residual_is_mass_matrix_times_rates_less_forcing) {
  for_trees([](const Tree& tree) {
    const Vector flat = tree("mass_matrix"), f = tree("forcing");
    const Matrix A = Eigen::Map<const Matrix>(flat.data(), tree.ny(), tree.ny());
    const Vector A_ydot = A * tree.given_ydot();
    EXPECT_LE((tree.with_given_rates("residual") - (A_ydot - f)).norm(), of_constants * (A_ydot.norm() + f.norm()));
    EXPECT_LE(tree("residual").norm(), of_constants * f.norm());
  });
}

// A free first body, no gravity, inner loads only: effects between bodies of the tree with their reactions.
scene::Scene left_alone(Random& random, int n_bodies) {
  RandomSceneOptions options = everything();
  options.forest = options.gravity = options.loads = false;
  options.expression_share = 0;
  scene::Scene scene = random_scene(random, n_bodies, options);
  scene.bodies[0].joint = scene::Joint();
  for (scene::Body& body : scene.bodies) body.joint.held = false;
  std::erase_if(scene.loads, [](const scene::Load& load) {
    using Kind = scene::Load::Kind;
    if (load.kind == Kind::joint) return load.point.body == 1;
    return load.kind == Kind::spring ? load.other.body == 0 || load.point.body == 0 : load.reaction <= 0;
  });
  return scene;
}

TEST(Laws, momentum_is_kept_where_nothing_acts_from_outside) {
  for (int n_bodies = 2; n_bodies <= 12; ++n_bodies) {
    Random random(static_cast<std::uint64_t>(4000 + n_bodies));
    const scene::Scene scene = left_alone(random, n_bodies);
    const Tree tree(scene, random);
    const Vector rate = tree.rate("momentum"), f = tree("forcing");
    EXPECT_LT(rate.norm(), of_constants * f.norm()) << n_bodies;  // each rate is a sum of terms as large as f
  }
}

}  // namespace
}  // namespace kanec::test
