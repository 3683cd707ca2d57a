// One function of a program, section by section. Not: the file around it.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "generator/emit/form.hpp"
#include "generator/emit/model.hpp"
#include "generator/emit/statements.hpp"
#include "generator/program/ledger.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

// Fields of the Prepared struct: results that depend on parameters only, by node.
using PreparedNames = std::unordered_map<program::Index, Name>;

// What a function refers to and does not make.
struct Named {
  PreparedNames prepared;
  bool has_inputs = false;  // the model has a struct Inputs
};

// What a function calls a result of parameters: "c.Iinv2_11", "c.p.m_1".
std::string prepared_name(const program::Program& program, const Named& named, program::Index node,
                          const Syntax& syntax);

std::string emit_function(const Model& model, const program::Program& program,
                          const std::vector<program::Stage>& stages, const program::Function& function,
                          const program::Ledger& cost, const Named& named, const Form& form);

}  // namespace kanec::emit
