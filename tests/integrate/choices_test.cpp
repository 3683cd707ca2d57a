// What a scene may ask for is what the integrators know: the generator, which reads scenes, has lists of its own, since
// it links no integrator.
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/read/check.hpp"
#include "runtime/base/error.hpp"
#include "runtime/integrate/options.hpp"

namespace kanec::integrate::test {
namespace {

using ::testing::ThrowsMessage;

template <class Check>
bool is_refused(const Check& check) {
  try {
    check();
  } catch (const Error&) {
    return true;
  }
  return false;
}

TEST(Choices, of_integrators_are_those_of_a_scene) { EXPECT_EQ(method_names(), scene::simulation_integrators()); }

TEST(Choices, of_jacobians_are_those_of_a_scene) {
  std::string all;
  for (const std::string& name : scene::simulation_jacobians()) all += (all.empty() ? "" : ", ") + name;
  EXPECT_THAT([] { jacobian_of(""); }, ThrowsMessage<InputError>("jacobian: found ''; allowed: " + all));
}

TEST(Choices, of_orders_are_those_of_a_scene) {
  const scene::PlaceOf place_of = [](const std::string& key) { return scene::Place{key}; };
  for (const std::string& name : method_names())
    for (int order = -1; order <= 13; ++order) {
      Options options;
      options.method = method_of(name);
      options.order = order;
      scene::Simulation simulation;
      simulation.integrator = name;
      simulation.order = order;
      EXPECT_EQ(is_refused([&] { check(options); }), is_refused([&] { scene::check_simulation(simulation, place_of); }))
          << name << " " << order;
    }
}

}  // namespace
}  // namespace kanec::integrate::test
