// SPDX-License-Identifier: BSD-3-Clause
#include "kanec/batch.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "runtime/abi/batch_solver.hpp"
#include "runtime/compile/library.hpp"
#include "runtime/front/data.hpp"

namespace kanec {

struct Batch::Data {
  Model model;
  std::variant<BatchSolver<double>, BatchSolver<float>> solver;
  std::vector<double> parameters = {}, inputs = {};
};

namespace {

std::variant<BatchSolver<double>, BatchSolver<float>> solver_for(const kanec_batch& batch, int threads) {
  if (batch.scalar_size == sizeof(float)) return BatchSolver<float>(batch, threads);
  return BatchSolver<double>(batch, threads);
}

std::int64_t stride_of(Order order, std::int64_t count) { return order == Order::states ? 1 : count; }

void require_numbers(const kanec_model& model, const std::string& what, std::size_t found, std::int64_t count, int n) {
  if (found == static_cast<std::size_t>(count) * static_cast<std::size_t>(n)) return;
  throw InputError(std::string(model.name) + ", " + what + ": found " + std::to_string(found) +
                   " numbers; allowed: " + std::to_string(count) + " times " + std::to_string(n));
}

template <class Real>
void evaluate_batch(BatchSolver<Real>& solver, const Function& function, const StatesView<Real>& states,
                    std::span<Real> out) {
  const kanec_model& model = solver.model();
  require_of(model, function);
  if (states.count < 0)
    throw InputError("states: found a count of " + std::to_string(states.count) + "; allowed: 0 or more");
  const kanec_function& called = model.functions[function.number];
  const std::string where = function.name + ": ";
  const auto require = [&](std::uint32_t flag, const char* what, std::size_t found, int n) {
    if ((called.reads & flag) != 0) require_numbers(model, where + what, found, states.count, n);
  };
  require(KANEC_READS_X, "x", states.x.size(), model.nx);
  require(KANEC_READS_Y, "y", states.y.size(), model.ny);
  require(KANEC_READS_YDOT, "ydot", states.ydot.size(), model.ny);
  if (!states.inputs.empty()) require(KANEC_READS_U, "inputs", states.inputs.size(), model.n_inputs);
  if (states.t.size() > 1) require(KANEC_READS_T, "t", states.t.size(), 1);
  require_numbers(model, where + "the result", out.size(), states.count, called.n_out);
  if (states.count == 0) return;
  const Real zero = 0;
  BatchStates<Real> batch;
  batch.count = states.count;
  batch.stride = stride_of(states.order, states.count);
  batch.one_time = states.t.size() != static_cast<std::size_t>(states.count);
  batch.t = states.t.empty() ? &zero : states.t.data();
  batch.x = states.x.data();
  batch.y = states.y.data();
  batch.ydot = states.ydot.data();
  batch.u = states.inputs.empty() ? nullptr : states.inputs.data();
  solver.evaluate(function.number, batch, out.data());
}

}  // namespace

Batch Batch::load(const std::filesystem::path& library, int threads) {
  const auto loaded = std::make_shared<const compile::Library>(library);
  if (!loaded->is_batch())
    throw LoadError("compiled model " + library.string() + ": found a model; allowed: a batch (Model::load loads it)");
  return {loaded->batch(), {*loaded->batch().model, loaded}, threads};
}

Batch::Batch(const kanec_batch& batch, Model model, int threads)
    : data_(std::make_unique<Data>(Data{std::move(model), solver_for(batch, threads)})) {
  set_parameters(values_of(data_->model.parameters()));
  set_inputs(values_of(data_->model.inputs()));
}

Batch::Batch(Batch&&) noexcept = default;
Batch& Batch::operator=(Batch&&) noexcept = default;
Batch::~Batch() = default;

const Model& Batch::model() const { return data_->model; }
bool Batch::is_float() const { return std::holds_alternative<BatchSolver<float>>(data_->solver); }

int Batch::lanes() const {
  return std::visit([](const auto& solver) { return solver.lanes(); }, data_->solver);
}

int Batch::threads() const {
  return std::visit([](const auto& solver) { return solver.workers().size(); }, data_->solver);
}

void Batch::set_parameters(std::span<const double> values) {
  require_finite("parameters", values);
  std::visit([&](auto& solver) { solver.set_parameters(values); }, data_->solver);
  data_->parameters.assign(values.begin(), values.end());
}

void Batch::set_inputs(std::span<const double> values) {
  require_finite("inputs", values);
  std::visit([&](auto& solver) { solver.set_inputs(values); }, data_->solver);
  data_->inputs.assign(values.begin(), values.end());
}

void Batch::set_parameter(std::string_view name, double value) {
  std::vector<double> values = data_->parameters;
  const kanec_model& model = data_->model.abi();
  values[static_cast<std::size_t>(named("parameter", model.parameter_names, model.n_parameters, name))] = value;
  set_parameters(values);
}

void Batch::set_input(std::string_view name, double value) {
  std::vector<double> values = data_->inputs;
  const kanec_model& model = data_->model.abi();
  values[static_cast<std::size_t>(named("input", model.input_names, model.n_inputs, name))] = value;
  set_inputs(values);
}

void Batch::set_parameters_each(std::int64_t count, std::span<const double> values, Order order) {
  require_numbers(data_->model.abi(), "parameters", values.size(), count, data_->model.abi().n_parameters);
  require_finite("parameters", values);
  std::visit(
      [&]<class Real>(BatchSolver<Real>& solver) {
        const std::vector<Real> numbers(values.begin(), values.end());
        solver.set_parameters_each(count, numbers.data(), stride_of(order, count));
      },
      data_->solver);
}

void Batch::evaluate(const Function& function, const StatesView<double>& states, std::span<double> out) {
  auto* solver = std::get_if<BatchSolver<double>>(&data_->solver);
  if (solver == nullptr) throw InputError(model().name() + ": found a batch of float; allowed: float numbers");
  evaluate_batch(*solver, function, states, out);
}

void Batch::evaluate(const Function& function, const StatesView<float>& states, std::span<float> out) {
  auto* solver = std::get_if<BatchSolver<float>>(&data_->solver);
  if (solver == nullptr) throw InputError(model().name() + ": found a batch of double; allowed: double numbers");
  evaluate_batch(*solver, function, states, out);
}

}  // namespace kanec
