// The kinds of joints and what each is made of. Not: where one stands (read_joint.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace kanec::scene {

struct JointKind {
  std::string name;
  bool ball = false;              // rotation by Euler parameters and absolute ω
  int turns = 0;                  // else by so many successive angles
  int slides = 0;                 // translations
  std::vector<std::string> keys;  // of [[body]], beside "joint" and those that every body has

  bool takes(const std::string& key) const;
  bool has_one_coordinate() const { return !ball && turns + slides == 1; }
  std::vector<std::string> initial_keys() const;  // of [body.initial]
  std::vector<std::string> motion_keys() const;   // of [body.motion]
};

// All kinds, "free" first.
const std::vector<JointKind>& joint_kinds();

// The kind of that name, which must be one.
const JointKind& joint_kind(const std::string& name);

// Every key that some joint takes.
const std::vector<std::string>& joint_keys();

}  // namespace kanec::scene
