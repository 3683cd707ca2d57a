// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/states/evaluate_many.hpp"

#include <memory>

#include "generator/scene/entry_names.hpp"
#include "runtime/base/error.hpp"
#include "runtime/model/evaluate.hpp"
#include "runtime/model/settings.hpp"
#include "runtime/model/sound_parameters.hpp"
#include "runtime/model/unit_norm.hpp"

namespace kanec {
namespace {

void check_values(const scene::Scene& scene, const State& state, const std::string& place) {
  if (surely_sound(scene, state.parameters)) return;
  scene::Scene changed = scene;
  for (std::size_t i = 0; i < state.parameters.size(); ++i) changed.parameters[i].value = state.parameters[i];
  check_defaults(changed, place);
}

// What a compiled function is called with, from one state to the next.
struct CompiledFunction {
  Solver solver;
  const kanec_function* function;
  std::vector<double> parameters, inputs, out;
};

}  // namespace

std::function<const std::vector<double>&(const State&)> compiled_function(const kanec_model& model,
                                                                          const scene::Scene& scene,
                                                                          const std::string& function) {
  const auto call = std::make_shared<CompiledFunction>(CompiledFunction{Solver(model), nullptr, {}, {}, {}});
  call->function = call->solver.find(function);
  if (call->function == nullptr) throw InternalError("no function " + function + " in the compiled model");
  call->out.resize(static_cast<std::size_t>(call->function->n_out));
  return [call, &model, &scene](const State& state) -> const std::vector<double>& {
    if (state.parameters != call->parameters) {
      call->solver.set_parameters(read_parameters(model, scene, state.parameters));
      call->parameters = state.parameters;
    }
    if (state.inputs != call->inputs) {
      call->solver.set_inputs(read_inputs(model, scene, state.inputs));
      call->inputs = state.inputs;
    }
    call->solver.evaluate(*call->function, state.t, state.x.data(), state.y.data(), state.ydot.data(),
                          call->out.data());
    return call->out;
  };
}

ManyStates evaluate_many(const scene::Scene& scene, StateSource& states, ResultSink& results,
                         const std::function<const std::vector<double>&(const State&)>& evaluate,
                         const std::function<void(double)>& progress) {
  ManyStates many;
  const scene::Layout layout(scene);
  const bool has_values = states.has_values() && !scene.parameters.empty();
  State state = initial_state(scene);
  while (states.next(state)) {
    const UnitNorm norm = to_unit_norm(layout, state.x);
    if (norm.zero > 0)
      throw InputError(states.place() + ": eps_" + scene::body_words(scene)[static_cast<std::size_t>(norm.zero - 1)] +
                       ": found norm 0; allowed: Euler parameters, of which one is not zero");
    many.normalised += norm.off.empty() ? 0 : 1;
    if (has_values) check_values(scene, state, states.place());
    results.add(evaluate(state));
    constexpr std::int64_t between_looks = 1024;
    if (++many.count % between_looks == 0) progress(states.share());
  }
  if (many.count == 0) throw InputError(states.place() + ": found no state; allowed: one at least");
  return many;
}

}  // namespace kanec
