// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/python/batches.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "runtime/python/errors.hpp"

namespace kanec::python {
namespace {

std::vector<int> numbers_of(const std::vector<Quantity>& some, const std::vector<Quantity>& all, int first) {
  std::vector<int> numbers;
  for (const Quantity& one : some)
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].name == one.name) numbers.push_back(first + static_cast<int>(i));
  return numbers;
}

const Given* given_for(const Values& values, int number) {
  for (const Given& given : values.given)
    if (given.number == number) return &given;
  return nullptr;
}

// For all states: the default, or the number that was given.
std::vector<double> common(const Values& values, const std::vector<int>& numbers) {
  const std::span<const double> parameters = values.defaults->parameters(), inputs = values.defaults->inputs();
  std::vector<double> list;
  for (const int number : numbers) {
    const auto k = static_cast<std::size_t>(number);
    const Given* given = given_for(values, number);
    list.push_back(given != nullptr        ? given->value
                   : k < parameters.size() ? parameters[k]
                                           : inputs[k - parameters.size()]);
  }
  return list;
}

bool any_each(const Values& values, const std::vector<int>& numbers) {
  return std::any_of(numbers.begin(), numbers.end(), [&](int number) {
    const Given* given = given_for(values, number);
    return given != nullptr && given->each.data() != nullptr;
  });
}

// For each state its own, as `order` says.
template <class Real>
std::vector<Real> own(const Values& values, const std::vector<int>& numbers, std::size_t count, Order order) {
  const std::vector<double> all = common(values, numbers);
  const std::size_t n = numbers.size();
  std::vector<Real> table(count * n);
  for (std::size_t i = 0; i < n; ++i) {
    const Given* given = given_for(values, numbers[i]);
    const bool each = given != nullptr && given->each.data() != nullptr;
    for (std::size_t j = 0; j < count; ++j)
      table[order == Order::states ? j * n + i : i * count + j] = static_cast<Real>(each ? given->each[j] : all[i]);
  }
  return table;
}

}  // namespace

Batches::Batches(Scene scene, Emission emission, Compilation compilation, int threads)
    : scene_(std::move(scene)),
      emission_(std::move(emission)),
      compilation_(std::move(compilation)),
      threads_(threads) {
  emission_.taylor = false;
}

Batches::Slot& Batches::slot(const std::string& request, bool in_float, const Model& model) {
  std::unique_ptr<Slot>& slot = slots_[{request, in_float}];
  if (slot) return *slot;
  Emission emission = emission_;
  emission.functions = {request};
  Compilation compilation = compilation_;
  compilation.poll = watch_for_signals();
  Batch batch = scene_.compile_batch(emission, compilation, threads_, in_float ? "float" : "double");
  Function function = batch.model().function(request);
  const std::vector<Quantity> parameters = model.parameters();
  std::vector<int> of_parameters = numbers_of(batch.model().parameters(), parameters, 0);
  std::vector<int> of_inputs = numbers_of(batch.model().inputs(), model.inputs(), static_cast<int>(parameters.size()));
  slot = std::make_unique<Slot>(
      Slot{std::move(batch), std::move(function), std::move(of_parameters), std::move(of_inputs)});
  return *slot;
}

template <class Real>
void Batches::evaluate(const std::string& request, StatesView<Real> states, const Values& values, std::span<Real> out) {
  const std::scoped_lock turn(turn_);
  Slot& at = slot(request, std::is_same_v<Real, float>, values.defaults->model());
  const auto count = static_cast<std::size_t>(states.count);
  if (count == 0) return;
  if (any_each(values, at.parameters))
    at.batch.set_parameters_each(states.count, own<double>(values, at.parameters, count, states.order), states.order);
  else
    at.batch.set_parameters(common(values, at.parameters));
  std::vector<Real> inputs;
  if (any_each(values, at.inputs))
    inputs = own<Real>(values, at.inputs, count, states.order);
  else
    at.batch.set_inputs(common(values, at.inputs));
  states.inputs = inputs;
  at.batch.evaluate(at.function, states, out);
}

template void Batches::evaluate(const std::string&, StatesView<double>, const Values&, std::span<double>);
template void Batches::evaluate(const std::string&, StatesView<float>, const Values&, std::span<float>);

}  // namespace kanec::python
