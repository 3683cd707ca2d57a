// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/choice/reductions.hpp"

#include <utility>

#include "generator/choice/candidates.hpp"
#include "generator/choice/requests.hpp"
#include "generator/program/ledger.hpp"
#include "generator/scene/entry_names.hpp"
#include "runtime/base/text.hpp"

namespace kanec {
namespace {

using scene::Number;

void append(std::string& list, const std::string& item) { list += (list.empty() ? "" : ", ") + item; }

bool is_massless(const scene::Body& body) {
  const scene::Symmetric& m = body.inertia;
  return body.mass.is_zero() && m.xx.is_zero() && m.yy.is_zero() && m.zz.is_zero() && m.xy.is_zero() &&
         m.xz.is_zero() && m.yz.is_zero();
}

// A scene in which numbers that were constants are parameters of the same value.
class Loosened {
 public:
  explicit Loosened(const scene::Scene& scene) : scene_(scene) {}

  Loosened& gravity() { return vector(scene_.gravity, true); }

  // Masses and inertias of bodies that have none.
  Loosened& massless_bodies() {
    for (scene::Body& body : scene_.bodies)
      if (is_massless(body)) inertial(body, true);
    return *this;
  }

  // All but zeros, of bodies and loads.
  Loosened& constants() {
    for (scene::Body& body : scene_.bodies) {
      inertial(body, false);
      for (scene::Vector* v : {&body.r, &body.q, &body.force, &body.moment}) vector(*v, false);
    }
    for (scene::Load& load : scene_.loads) {
      for (scene::Vector* v : {&load.point.r, &load.other.r, &load.vector}) vector(*v, false);
      for (Number* n : {&load.effort, &load.stiffness, &load.damping, &load.rest}) number(*n, false);
    }
    vector(scene_.gravity, false);
    return *this;
  }

  const scene::Scene& scene() const { return scene_; }
  int n_changed() const { return changed_; }

 private:
  void number(Number& n, bool zeros_too) {
    if (n.kind != Number::Kind::constant || (n.value == 0 && !zeros_too)) return;
    scene_.parameters.push_back({"loosened_" + std::to_string(++changed_), n.value});
    n = Number::parameter(static_cast<int>(scene_.parameters.size()) - 1);
  }

  Loosened& vector(scene::Vector& v, bool zeros_too) {
    for (Number& n : v) number(n, zeros_too);
    return *this;
  }

  // One parameter stands in both halves of the matrix by construction.
  void inertial(scene::Body& body, bool zeros_too) {
    number(body.mass, zeros_too);
    scene::Symmetric& m = body.inertia;
    for (Number* n : {&m.xx, &m.yy, &m.zz, &m.xy, &m.xz, &m.yz}) number(*n, zeros_too);
  }

  scene::Scene scene_;
  int changed_ = 0;
};

class Reducing {
 public:
  Reducing(const scene::Scene& scene, const std::vector<std::string>& functions)
      : scene_(scene),
        names_(requested_functions(scene, functions)),
        program_(optimized(scene, {})),
        cost_(cost(program_)) {}

  std::vector<Reduction> all() {
    add("welded bodies", welds(), scene_, {.merge_welds = false});
    add("locked coordinates", locks(), scene_, {.drop_locks = false});
    add("massless bodies", massless(), Loosened(scene_).massless_bodies().scene(), {});
    if (scene::is_zero(scene_.gravity)) add("gravity", "none in the scene", Loosened(scene_).gravity().scene(), {});
    const Loosened loose = std::move(Loosened(scene_).constants());
    if (loose.n_changed() > 0)
      add("constant numbers", std::to_string(loose.n_changed()) + " folded into the code", loose.scene(), {});
    add_unread();
    return std::move(result_);
  }

 private:
  program::Program optimized(const scene::Scene& scene, const symbolic::Reductions& reductions) const {
    return cheapest_program(scene, names_, {}, reductions);
  }

  static long cost(const program::Program& program) {
    long sum = 0;
    for (const program::Ledger& ledger : program::ledgers(program)) sum += ledger.operations();
    return sum;
  }

  void add(const std::string& name, const std::string& what, const scene::Scene& undone,
           const symbolic::Reductions& reductions) {
    if (!what.empty()) result_.push_back({name, what, cost(optimized(undone, reductions)) - cost_});
  }

  std::string welds() const {
    const symbolic::Mechanism mechanism = symbolic::mechanism(scene_, {});
    std::string text;
    for (int k = 1; k <= size(scene_); ++k) {
      const int link = mechanism.body(k).link;
      if (link > 0 && mechanism.link(link).body == k) continue;
      const std::string& body = scene_.bodies[static_cast<std::size_t>(k - 1)].name;
      append(text, body + " is part of " +
                       (link == 0 ? "the ground"
                                  : scene_.bodies[static_cast<std::size_t>(mechanism.link(link).body - 1)].name));
    }
    return text;
  }

  std::string locks() const {
    std::string text;
    const auto list = [&](const std::vector<scene::Coordinate>& coordinates, const std::string& letter, int k) {
      for (std::size_t i = 0; i < coordinates.size(); ++i) {
        if (coordinates[i].motion != scene::Coordinate::Motion::locked) continue;
        const std::string component = coordinates.size() > 1 ? "_" + std::to_string(i + 1) : "";
        append(text, letter + "_" + std::to_string(k) + component + " = " + shortest(coordinates[i].value));
      }
    };
    for (int k = 1; k <= size(scene_); ++k) {
      const scene::Joint& joint = scene_.bodies[static_cast<std::size_t>(k - 1)].joint;
      if (joint.ball && joint.held) append(text, "eps_" + std::to_string(k) + " held");
      if (!joint.ball) list(joint.turns, "theta", k);
      list(joint.slides, "s", k);
    }
    return text;
  }

  std::string massless() const {
    std::string text;
    for (const scene::Body& body : scene_.bodies)
      if (is_massless(body)) append(text, body.name);
    return text;
  }

  // Parameters, inputs and coordinates that nothing asked for depends on.
  void add_unread() {
    const std::vector<bool> used = program::reachable(program_);
    std::vector<std::vector<bool>> read(5);
    const auto& names = program_.names;
    const std::vector<const std::vector<std::string>*> lists = {&names.parameters, &names.x, &names.y, &names.ydot,
                                                                &names.inputs};
    for (std::size_t group = 0; group < lists.size(); ++group) read[group].resize(lists[group]->size());
    for (std::size_t i = 0; i < used.size(); ++i)
      if (const auto* variable = std::get_if<program::Variable>(&program_.nodes[i]))
        if (used[i] && variable->group != program::Group::time)
          read[static_cast<std::size_t>(variable->group)][static_cast<std::size_t>(variable->index)] = true;
    const auto unread = [&](std::size_t group, const std::vector<std::string>& list) {
      std::string text;
      for (std::size_t i = 0; i < list.size(); ++i)
        if (!read[group][i]) append(text, list[i]);
      return text;
    };
    for (const auto& [name, text] :
         {std::pair{"parameters not read", unread(0, *lists[0])}, std::pair{"inputs not read", unread(4, *lists[4])},
          std::pair{"coordinates not read", unread(1, in_words(scene_, coordinate_names(scene_)))}})
      if (!text.empty()) result_.push_back({name, text, 0});
  }

  const scene::Scene& scene_;
  std::vector<std::string> names_;
  program::Program program_;
  long cost_;
  std::vector<Reduction> result_;
};

}  // namespace

std::vector<Reduction> reductions(const scene::Scene& scene, const std::vector<std::string>& functions) {
  return Reducing(scene, functions).all();
}

}  // namespace kanec
