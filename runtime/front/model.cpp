// SPDX-License-Identifier: BSD-3-Clause
#include "kanec/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/base/text.hpp"
#include "runtime/compile/library.hpp"
#include "runtime/front/data.hpp"

namespace kanec {
namespace {

std::vector<std::string> list_of(const char* const* names, int count) { return {names, names + count}; }

std::vector<Quantity> quantities(const char* const* names, const double* values, int count) {
  std::vector<Quantity> list;
  for (int i = 0; i < count; ++i) list.push_back({names[i], values[i]});
  return list;
}

Function front_function(const kanec_model& model, int number) {
  const kanec_function& from = model.functions[number];
  const auto reads = [&](std::uint32_t flag) { return (from.reads & flag) != 0; };
  return {from.name,
          from.n_out,
          reads(KANEC_READS_T),
          reads(KANEC_READS_X),
          reads(KANEC_READS_Y),
          reads(KANEC_READS_YDOT),
          reads(KANEC_READS_U),
          number};
}

void require_size(const kanec_model& model, const Function& function, const char* what, std::size_t found, int wanted) {
  if (found == static_cast<std::size_t>(wanted)) return;
  throw InputError(std::string(model.name) + ", " + function.name + ": " + what + ": found " + std::to_string(found) +
                   " numbers; allowed: " + std::to_string(wanted));
}

}  // namespace

std::string emitted_word(std::string_view request) {
  std::string word;
  for (const char c : request) word += c == '+' ? std::string("_and_") : std::string(1, c);
  return word;
}

void require_of(const kanec_model& model, const Function& function) {
  if (function.number < 0 || function.number >= model.n_functions ||
      function.name != model.functions[function.number].name)
    throw InputError(std::string(model.name) + ": found the function " + function.name +
                     " of another model; allowed: one of its own");
}

int named(const char* what, const char* const* names, int count, std::string_view name) {
  for (int i = 0; i < count; ++i)
    if (name == names[i]) return i;
  const std::vector<std::string> known = list_of(names, count);
  std::string all;
  for (const std::string& one : known) all += (all.empty() ? "" : ", ") + one;
  const std::string near = nearest(std::string(name), known);
  throw InputError(std::string(what) + ": found '" + std::string(name) + "'; allowed: " + (all.empty() ? "none" : all) +
                   (near.empty() ? "" : " (did you mean " + near + "?)"));
}

std::vector<double> values_of(const std::vector<Quantity>& list) {
  std::vector<double> values;
  for (const Quantity& one : list) values.push_back(one.value);
  return values;
}

void require_finite(const char* what, std::span<const double> values) {
  for (const double value : values)
    if (!std::isfinite(value))
      throw InputError(std::string(what) + ": found " + shortest(value) + "; allowed: finite numbers");
}

Model Model::load(const std::filesystem::path& library) {
  const auto loaded = std::make_shared<const compile::Library>(library);
  if (loaded->is_batch())
    throw LoadError("compiled model " + library.string() + ": found a batch; allowed: a model (Batch::load loads it)");
  return {loaded->model(), loaded};
}

Model::Model(const kanec_model& model, std::shared_ptr<const void> owner)
    : model_(&model),
      owner_(std::move(owner)),
      parameters_(quantities(model.parameter_names, model.parameter_defaults, model.n_parameters)),
      inputs_(quantities(model.input_names, model.input_defaults, model.n_inputs)) {}

std::string Model::name() const { return model_->name; }
std::string Model::hash() const { return model_->hash; }
int Model::n_bodies() const { return model_->n_bodies; }
int Model::nx() const { return model_->nx; }
int Model::ny() const { return model_->ny; }
std::vector<std::string> Model::coordinates() const { return list_of(model_->coordinate_names, model_->nx); }
std::vector<std::string> Model::speeds() const { return list_of(model_->speed_names, model_->ny); }

std::vector<Quantity> Model::parameters() const { return parameters_; }
std::vector<Quantity> Model::inputs() const { return inputs_; }

Model Model::with(const std::vector<Quantity>& values) const {
  Model other = *this;
  for (auto* list : {&other.parameters_, &other.inputs_})
    for (Quantity& quantity : *list)
      for (const Quantity& given : values) {
        if (given.name != quantity.name) continue;
        require_finite(given.name.c_str(), {&given.value, 1});
        quantity.value = given.value;
      }
  return other;
}

std::vector<Function> Model::functions() const {
  std::vector<Function> list;
  for (int i = 0; i < model_->n_functions; ++i) list.push_back(front_function(*model_, i));
  return list;
}

bool Model::has(std::string_view function) const {
  const std::string word = emitted_word(function);
  return std::any_of(model_->functions, model_->functions + model_->n_functions,
                     [&](const kanec_function& one) { return word == one.name; });
}

Function Model::function(std::string_view name) const {
  std::vector<const char*> names;
  for (int i = 0; i < model_->n_functions; ++i) names.push_back(model_->functions[i].name);
  const std::string where = std::string(model_->name) + ": function";
  return front_function(*model_, named(where.c_str(), names.data(), model_->n_functions, emitted_word(name)));
}

Evaluator::Evaluator(Model model) : model_(std::move(model)) {
  if (model_.abi().prepare == nullptr)
    throw InputError(model_.name() + ": found the model of a batch; allowed: one for single states");
  data_ = std::make_unique<Data>(Solver(model_.abi()));
  set_parameters(values_of(model_.parameters()));
  set_inputs(values_of(model_.inputs()));
}

Evaluator::Evaluator(const Evaluator& other) : model_(other.model_), data_(std::make_unique<Data>(*other.data_)) {}
Evaluator& Evaluator::operator=(const Evaluator& other) { return *this = Evaluator(other); }
Evaluator::Evaluator(Evaluator&&) noexcept = default;
Evaluator& Evaluator::operator=(Evaluator&&) noexcept = default;
Evaluator::~Evaluator() = default;

std::span<const double> Evaluator::parameters() const { return data_->solver.parameters(); }
std::span<const double> Evaluator::inputs() const { return data_->solver.inputs(); }

void Evaluator::set_parameters(std::span<const double> values) {
  require_finite("parameters", values);
  data_->solver.set_parameters(values);
}

void Evaluator::set_inputs(std::span<const double> values) {
  require_finite("inputs", values);
  data_->solver.set_inputs(values);
}

void Evaluator::set_parameter(std::string_view name, double value) {
  std::vector<double> values(parameters().begin(), parameters().end());
  const kanec_model& model = model_.abi();
  values[static_cast<std::size_t>(named("parameter", model.parameter_names, model.n_parameters, name))] = value;
  set_parameters(values);
}

void Evaluator::set_input(std::string_view name, double value) {
  std::vector<double> values(inputs().begin(), inputs().end());
  const kanec_model& model = model_.abi();
  values[static_cast<std::size_t>(named("input", model.input_names, model.n_inputs, name))] = value;
  set_inputs(values);
}

void Evaluator::evaluate(const Function& function, const StateView& state, std::span<double> out) const {
  const kanec_model& model = model_.abi();
  require_of(model, function);
  const kanec_function& called = model.functions[function.number];
  if ((called.reads & KANEC_READS_X) != 0) require_size(model, function, "x", state.x.size(), model.nx);
  if ((called.reads & KANEC_READS_Y) != 0) require_size(model, function, "y", state.y.size(), model.ny);
  if ((called.reads & KANEC_READS_YDOT) != 0) require_size(model, function, "ydot", state.ydot.size(), model.ny);
  require_size(model, function, "the result", out.size(), called.n_out);
  data_->solver.evaluate(called, state.t, state.x.data(), state.y.data(), state.ydot.data(), out.data());
}

std::vector<double> Evaluator::evaluate(std::string_view function, const StateView& state) const {
  const Function called = model_.function(function);
  std::vector<double> out(static_cast<std::size_t>(called.size));
  evaluate(called, state, out);
  return out;
}

}  // namespace kanec
