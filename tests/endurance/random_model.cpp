// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/endurance/random_model.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "generator/choice/requests.hpp"
#include "tests/support/random_expression.hpp"
#include "tests/support/random_scene.hpp"

namespace kanec::test {
namespace {

// Letters of the derivation, arguments, arrays and structs of emitted code.
constexpr std::array words = {
    "U1",    "omegadot1_1", "minus_U1_11", "t1_1",     "b2_1",    "z1_1",    "c0_1",  "x",       "y",
    "ydot",  "xdot",        "c",           "p",        "u",       "k",       "row",   "own",     "of_L",
    "K",     "L",           "J1",          "frames",   "frame",   "shared",  "block", "cosines", "sines",
    "place", "places",      "inputs",      "prepared", "A",       "f",       "r",     "S",       "B",
    "F",     "N1",          "G2",          "select",   "piece_1", "cos_sin", "now",   "v",       "s",
    "z",     "zdot",        "n",           "i",        "j",       "model",   "at",    "steps",   "step",
    "D1",    "phi1",        "alpha1",      "r_load_1", "F_1",     "M_1",     "g_1"};

class Names {
 public:
  explicit Names(Random& random) : random_(random) {}

  // One of the words that nothing of the scene bears, or the name as it is.
  std::string other(const std::string& name) {
    if (!random_.chance(0.4)) return taken(name);
    return taken(words[static_cast<std::size_t>(random_.below(static_cast<int>(words.size())))]);
  }

 private:
  std::string taken(const std::string& name) {
    std::string result = name;
    for (int i = 2; !names_.insert(result).second; ++i) result = name + "_" + std::to_string(i) + "n";
    return result;
  }

  Random& random_;
  std::set<std::string> names_;
};

RandomSceneOptions some_of_everything(Random& random) {
  RandomSceneOptions options = everything();
  options.gravity = random.chance(0.9);
  options.loads = random.chance(0.7);
  options.springs = random.chance(0.5);
  options.point_loads = random.chance(0.5);
  options.points = random.below(3);
  for (double* share : {&options.parameter_share, &options.input_share, &options.zero_share, &options.locked_share,
                        &options.prescribed_share, &options.expression_share})
    if (random.chance(0.5)) *share = 0;
  return options;
}

bool may_change(const scene::Expression& expression) {
  using Kind = scene::ExpressionNode::Kind;
  return std::any_of(expression.nodes.begin(), expression.nodes.end(), [](const scene::ExpressionNode& node) {
    return node.kind == Kind::coordinate || node.kind == Kind::speed || node.kind == Kind::time;
  });
}

void add_events(Random& random, scene::Scene& scene) {
  for (int i = random.below(3); i > 0; --i) {
    scene::Event event;
    event.name = "event_" + std::to_string(i);
    event.expression.kind = scene::Number::Kind::expression;
    event.expression.index = static_cast<int>(scene.expressions.size());
    const scene::Expression expression = random_expression(random, scene, 1.0);
    if (!may_change(expression)) continue;
    scene.expressions.push_back(expression);
    event.direction = static_cast<scene::Event::Direction>(random.below(3));
    if (!scene.inputs.empty() && random.chance(0.5)) {
      event.action = scene::Event::Action::set;
      event.settings = {{random.below(static_cast<int>(scene.inputs.size())), random.uniform(-2, 2)}};
    }
    event.row = random.chance(0.5);
    scene.events.push_back(event);
  }
}

// Bodies, points, loads and events under other names; all that refers to them does so by number.
void rename(Random& random, scene::Scene& scene) {
  Names bodies(random), points(random), loads(random), events(random);
  for (scene::Body& body : scene.bodies) body.name = bodies.other(body.name);
  for (scene::Point& point : scene.points) point.name = points.other(point.name);
  for (scene::Load& load : scene.loads) load.name = loads.other(load.name);
  for (scene::Event& event : scene.events) event.name = events.other(event.name);
}

std::vector<std::string> words_in_any_order(Random& random) {
  std::vector<std::string> list(words.begin(), words.end());
  for (std::size_t i = list.size(); i > 1; --i)
    std::swap(list[i - 1], list[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  list.resize(list.size() / 2);
  return list;
}

// What files cannot say: a moment has no place, a load no reaction on its own body, a held attitude no rate; and a
// spring's length is not negative where it begins.
void make_sayable(scene::Scene& scene) {
  for (scene::Load& load : scene.loads) {
    if (load.kind == scene::Load::Kind::moment) load.point.r = {};
    if (load.reaction == load.point.body) load.reaction = -1;
    const bool is_spring = load.kind == scene::Load::Kind::spring;
    if (is_spring && load.rest.kind == scene::Number::Kind::expression) load.rest = scene::Number::constant(0.3);
  }
  for (scene::Body& body : scene.bodies)
    if (body.joint.held) body.initial.omega = {};
}

// Of 12³, by number.
std::vector<std::string> triple(int number) {
  const std::vector<std::string> kinds = every_joint();
  const auto n = static_cast<int>(kinds.size());
  const auto kind = [&](int i) { return kinds[static_cast<std::size_t>(i % n)]; };
  return {kind(number), kind(number / n), kind(number / n / n)};
}

}  // namespace

scene::Scene random_model(std::uint64_t seed, int number) {
  Random random(seed * 1'000'003 + static_cast<std::uint64_t>(number));
  RandomSceneOptions options = some_of_everything(random);
  if (random.chance(0.5)) options.names = words_in_any_order(random);
  scene::Scene scene;
  if (is_triple(number)) {
    options.joints = triple(static_cast<int>((static_cast<std::uint64_t>(number / 2) + 577 * seed) % 1728));
    options.in_order = true;
    scene = random_scene(random, random.chance(0.5) ? std::vector{0, 1, 2} : std::vector{0, 1, 1}, options);
  } else {
    const int bodies = 1 + random.below(random.chance(0.2) ? 12 : 6);
    scene = random_scene(random, random_connection(random, bodies), options);
  }
  scene.name = "soak_" + std::to_string(number);
  add_events(random, scene);
  rename(random, scene);
  make_sayable(scene);
  return scene;
}

bool is_triple(int number) { return number % 2 == 0; }

std::vector<std::string> random_functions(Random& random, const scene::Scene& scene, int most) {
  std::vector<std::string> all;
  for (const Available& available : available_functions(scene)) all.push_back(available.name);
  const auto any = [&] { return all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))]; };
  std::set<std::string> chosen = {"accelerations"};
  for (int i = 0; i < most; ++i) {
    const std::string one = any(), other = any();
    chosen.insert(one == other || random.chance(0.5) ? one : one + "+" + other);
  }
  return {chosen.begin(), chosen.end()};
}

}  // namespace kanec::test
