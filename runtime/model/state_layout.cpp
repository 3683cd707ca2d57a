// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/state_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "generator/scene/entry_names.hpp"

namespace kanec {
namespace {

using scene::Coordinate;

// What the numbers of one kind are called, and their unit.
struct Letter {
  std::string name, unit;
};

// Of attitudes (so many numbers each), angles, translations.
struct Letters {
  Letter ball, turn, slide;
  int ball_width;
};

bool is_free(const Coordinate& coordinate) { return coordinate.motion == Coordinate::Motion::free; }
bool is_given(const Coordinate& coordinate) { return !is_free(coordinate); }

void append(std::vector<Block>& blocks, const std::vector<Coordinate>& coordinates, bool (*wanted)(const Coordinate&),
            const std::string& name, const std::string& unit) {
  const auto n = static_cast<int>(coordinates.size());
  if (n == 1 && wanted(coordinates[0])) blocks.push_back({name, {}, unit});
  if (n < 2) return;
  if (std::all_of(coordinates.begin(), coordinates.end(), wanted)) {
    blocks.push_back({name, {n}, unit});
    return;
  }
  for (int i = 0; i < n; ++i)
    if (wanted(coordinates[static_cast<std::size_t>(i)]))
      blocks.push_back({fmt::format("{}_{}", name, i + 1), {}, unit});
}

// Rotations of all bodies, then their translations. `in_state`: what is in the state, else what is not.
std::vector<Block> blocks(const scene::Scene& scene, const Letters& letters, bool in_state) {
  std::vector<Block> result;
  const auto name = [](const Letter& letter, int k) { return fmt::format("{}_{}", letter.name, k); };
  const auto wanted = in_state ? is_free : is_given;
  for (int k = 1; k <= size(scene); ++k) {
    const scene::Joint& joint = scene.bodies[static_cast<std::size_t>(k - 1)].joint;
    if (!joint.ball)
      append(result, joint.turns, wanted, name(letters.turn, k), letters.turn.unit);
    else if (joint.held != in_state)
      result.push_back({name(letters.ball, k), {letters.ball_width}, letters.ball.unit});
  }
  for (int k = 1; k <= size(scene); ++k)
    append(result, scene.bodies[static_cast<std::size_t>(k - 1)].joint.slides, wanted, name(letters.slide, k),
           letters.slide.unit);
  const std::vector<std::string> words = scene::body_words(scene);
  for (Block& block : result) {
    block.numbered = block.name;
    block.name = scene::in_words(block.name, words);
  }
  return result;
}

Layout of_state(const scene::Scene& scene, const std::string& name, const Letters& letters) {
  return {name, blocks(scene, letters, true)};
}

// "eps" and "12" of "eps_12", "hub" of "eps_hub"; components stay with the body: "s" and "2_1" of "s_2_1".
std::pair<std::string, std::string> split(const std::string& name) {
  const std::size_t at = name.find('_');
  return {name.substr(0, at), name.substr(at + 1)};
}

// Blocks that differ by their bodies alone.
struct Group {
  std::string letter;
  std::size_t width;
  std::vector<std::string> bodies;
};

std::vector<Group> groups(const Layout& layout) {
  std::vector<Group> list;
  for (const Block& block : layout.blocks) {
    const auto [letter, body] = split(block.name);
    const auto same = std::find_if(list.begin(), list.end(), [&, &name = letter](const Group& group) {
      return group.letter == name && group.width == block.size();
    });
    if (same == list.end())
      list.push_back({letter, block.size(), {body}});
    else
      same->bodies.push_back(body);
  }
  return list;
}

// "from 1 to 6" where they are numbers that follow one another, else all of them.
std::string range(const std::vector<std::string>& bodies) {
  const bool number = bodies[0].find_first_not_of("0123456789") == std::string::npos;
  for (std::size_t i = 1; i < bodies.size(); ++i)
    if (!number || bodies[i] != std::to_string(std::stoi(bodies[0]) + static_cast<int>(i)))
      return fmt::format("= {}", fmt::join(bodies, ", "));
  return "from " + bodies.front() + " to " + bodies.back();
}

}  // namespace

Layout coordinates_layout(const scene::Scene& scene) {
  return of_state(scene, "x", {{"eps", ""}, {"theta", "rad"}, {"s", "m"}, 4});
}

Layout speeds_layout(const scene::Scene& scene) {
  return of_state(scene, "y", {{"omega", "rad/s"}, {"thetadot", "rad/s"}, {"sdot", "m/s"}, 3});
}

Layout speed_rates_layout(const scene::Scene& scene) {
  return of_state(scene, "ydot", {{"omegadot", "rad/s^2"}, {"thetaddot", "rad/s^2"}, {"sddot", "m/s^2"}, 3});
}

Layout coordinate_rates_layout(const scene::Scene& scene) {
  return of_state(scene, "xdot", {{"epsdot", "1/s"}, {"thetadot", "rad/s"}, {"sdot", "m/s"}, 4});
}

Layout along_speeds_layout(const scene::Scene& scene, const std::string& name) {
  return of_state(scene, name, {{"omega", "N m"}, {"thetadot", "N m"}, {"sdot", "N"}, 3});
}

Layout driving_loads_layout(const scene::Scene& scene) {
  return {"driving_loads", blocks(scene, {{"phi", "N m"}, {"theta", "N m"}, {"s", "N"}, 3}, false)};
}

std::string summary_of(const Layout& layout) {
  std::vector<std::string> words;
  for (const Group& group : groups(layout)) {
    const bool one = group.bodies.size() == 1;
    words.push_back(fmt::format("{}_{} ({} {}){}", group.letter, one ? group.bodies[0] : "K", group.width,
                                group.width == 1 ? "number" : "numbers", one ? "" : ", K " + range(group.bodies)));
  }
  return words.empty() ? "nothing" : fmt::format("{}", fmt::join(words, "; "));
}

std::vector<std::string> tangent_names(const scene::Scene& scene) {
  std::vector<std::string> names;
  for (const std::string& speed : speed_names(scene)) {
    const auto [letter, rest] = split(speed);
    names.push_back((letter == "omega" ? "phi_" : letter == "thetadot" ? "theta_" : "s_") + rest);
  }
  return in_words(scene, std::move(names));
}

}  // namespace kanec
