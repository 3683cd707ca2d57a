// What the entries of x, y and ydot, the parameters and the inputs are called, by the number and by the name of a body.
// Not: what expressions call them, which know more (expression_names.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec::scene {

struct Entry {
  enum class Among { x, y, ydot, parameters, inputs };
  Among among = Among::x;
  int index = 0;
};

class EntryNames {
 public:
  explicit EntryNames(const Scene& scene);

  // "theta_3", "theta_elbow", "omegadot_1_2", "m_payload". None of what is no entry, and of a name that two bodies make
  // alike (theta_arm_2 of bodies arm and arm_2).
  std::optional<Entry> find(const std::string& name) const;

  // One name an entry, as it is printed (body_words()).
  const std::vector<std::string>& printed(Entry::Among among) const {
    return printed_[static_cast<std::size_t>(among)];
  }
  // All that find() knows among these.
  std::vector<std::string> known(const std::vector<Entry::Among>& among) const;

 private:
  void add(const std::string& name, const Entry& entry);

  std::map<std::string, std::optional<Entry>> entries_;
  std::vector<std::string> printed_[5], numbered_[5], by_body_[5];
};

// "theta_elbow" of "theta_3", "eps_hub_4" of "eps_1_4", "s_cart" of "s_1": a name whose first number is a body's, with
// the body's name for it.
std::string name_by_body(const Scene& scene, const std::string& name);

// What stands for each body in names that are printed: its own name; its number where it has none, and where entries of
// two bodies would have one name.
std::vector<std::string> body_words(const Scene& scene);

// "theta_elbow" of "theta_3", "R_elbow" of "R_3": a name whose first number is a body's, with its word.
std::string in_words(const std::string& name, const std::vector<std::string>& words);
std::vector<std::string> in_words(const Scene& scene, std::vector<std::string> names);

}  // namespace kanec::scene
