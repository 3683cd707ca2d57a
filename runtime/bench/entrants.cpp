// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/bench/entrants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/base/error.hpp"
#include "runtime/bench/code_size.hpp"
#include "runtime/generic/evaluate.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/model/tangent.hpp"
#include "runtime/verify/agreement.hpp"
#include "runtime/verify/paths.hpp"
#include "runtime/verify/samples.hpp"

namespace kanec {
namespace {

constexpr int pool_size = 256;
constexpr std::uint64_t seed = 1;
constexpr int compared_states = 4;        // of emitted code, in 50 digits as well
constexpr std::size_t peer_states = 16;   // compared
constexpr double most_difference = 1e-9;  // engines in double reach 1e-14 to 1e-10; a wrong term is 1e-3 and more

// States with the parameters that peers and the timed calls have, the defaults.
std::vector<State> pool(const scene::Scene& scene) {
  std::vector<State> states = samples(scene, pool_size, seed);
  for (State& state : states) state.parameters = default_parameters(scene);
  return states;
}

// Calls with the states of the pool in turn.
template <class Call>
void run(benchmark::State& loop, std::size_t n_states, Call call) {
  std::size_t at = 0;
  for (auto _ : loop) {
    call(at);
    at = at + 1 == n_states ? 0 : at + 1;
    benchmark::ClobberMemory();
  }
}

std::vector<double> differences(const scene::Scene& scene, const CompiledModel& model) {
  const Bounds bounds{.ulps = 1e5,
                      .generic = most_difference};  // long chains of balls take some hundred ulps; wrong is 1e9
  std::vector<double> list;
  for (const Agreement& a : agreements(scene, model, samples(scene, compared_states, seed), [](double) {})) {
    if (!bounds.hold(a))
      throw InputError(
          fmt::format("{}: emitted and generic differ by {:.2g}, rounding is {:.4g} ulps: not timed; "
                      "kanec check tells more",
                      a.function, a.generic, a.largest_ulps));
    list.push_back(a.generic);
  }
  return list;
}

// The largest error of a component over some states, beside the largest component there or its median over the states
// where that is more: a result that happens to cancel is judged by its usual size.
class Deviation {
 public:
  template <class Real>
  void add(const std::vector<Real>& found, const std::vector<Real>& expected) {
    Real error = 0, size = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      error = std::isfinite(found[i]) ? std::max(error, std::fabs(found[i] - expected[i])) : Real(INFINITY);
      size = std::max(size, std::fabs(expected[i]));
    }
    errors_.push_back(static_cast<double>(error));
    sizes_.push_back(static_cast<double>(size));
  }

  double largest() const {
    std::vector<double> sorted = sizes_;
    std::sort(sorted.begin(), sorted.end());
    double most = 0.0;
    for (std::size_t i = 0; i < errors_.size(); ++i)
      if (errors_[i] != 0.0) most = std::max(most, errors_[i] / std::max(sizes_[i], sorted[sorted.size() / 2]));
    return most;
  }

 private:
  std::vector<double> errors_, sizes_;
};

State accelerated(const scene::Scene& scene, State state) {
  const std::vector<long double> ydot = generic_path<long double>(scene, {"accelerations"}, state);
  std::transform(ydot.begin(), ydot.end(), state.ydot.begin(),
                 [](long double rate) { return static_cast<double>(rate); });
  return state;
}

}  // namespace

Entrants::Entrants(const scene::Scene& scene, const ContestOptions& options)
    : scene_(scene), functions_(options.functions), pool_(pool(scene)), generic_(scene, default_parameters(scene)) {
  for (const Variant& variant : options.variants) build(variant);
  const Generated& generated = built_.front().model.generated();
  contest.model = scene.name;
  contest.hash = generated.hash;
  for (const program::Function& function : generated.program.functions) add_function(function, options);
}

void Entrants::build(const Variant& variant) {
  if (variant.lanes) {
    CompiledModel model = build_batch(scene_, functions_, variant.build, *variant.lanes);
    std::unique_ptr<BatchRun> batch = batch_run(model.library.batch(), pool_);
    built_.push_back({variant.name, std::move(model), nullptr, std::move(batch)});
    return;
  }
  CompiledModel model = kanec::build(scene_, functions_, variant.build);
  std::vector<double> difference = differences(scene_, model);
  auto solver = std::make_unique<Solver>(model.library.abi());
  built_.push_back({variant.name, std::move(model), std::move(solver), nullptr, std::move(difference)});
}

void Entrants::add_function(const program::Function& function, const ContestOptions& options) {
  for (const Built& built : built_) add_emitted(built, function.name);
  add_generic(function.name);
  if (function.name != "accelerations") return;
  for (const Peer& peer : options.peers) add_peer(peer);
}

Loop Entrants::single(const Solver& solver, const std::string& function) const {
  const kanec_function& call = *solver.find(function);
  return {[this, &solver, &call](benchmark::State& loop) {
    std::vector<double> out(static_cast<std::size_t>(call.n_out));
    run(loop, pool_.size(), [&](std::size_t at) {
      const State& state = pool_[at];
      solver.evaluate(call, state.t, state.x.data(), state.y.data(), state.ydot.data(), out.data());
    });
  }};
}

// All states of the pool in one turn.
Loop in_lanes(BatchRun& batch, const std::string& function) {
  return {[&batch, call = batch.find(function)](benchmark::State& loop) {
            for (auto _ : loop) {
              batch.evaluate(call);
              benchmark::ClobberMemory();
            }
          },
          pool_size};
}

void Entrants::add_emitted(const Built& built, const std::string& function) {
  const program::Program& program = built.model.generated().program;
  const auto is_it = [&](const program::Function& one) { return one.name == function; };
  const auto same = std::find_if(program.functions.begin(), program.functions.end(), is_it);
  if (same == program.functions.end()) throw InternalError("variant " + built.name + " without " + function);
  Entry entry{function, built.name};
  entry.cost = program::ledger(program, *same);
  entry.code_bytes = code_bytes(built.model.library, function);
  if (!built.model.library.from_cache()) entry.compile_seconds = built.model.library.compile_seconds();
  const auto number = static_cast<std::size_t>(same - program.functions.begin());
  if (!built.batch) {
    entry.difference = built.difference[number];
    return add(std::move(entry), single(*built.solver, function));
  }
  entry.difference = lanes_difference(*built.batch, function);
  // what the function costs in digits, one state at a time, in roundings of this scalar
  const double allowed =
      std::max(1e-12, 100.0 * built_.front().difference[number]) * (built.batch->rounding() / 0x1p-53);
  if (*entry.difference <= allowed) return add(std::move(entry), in_lanes(*built.batch, function));
  entry.note = fmt::format("differs by {:.2g}: not timed", *entry.difference);
  contest.entries.push_back(std::move(entry));
}

double Entrants::lanes_difference(BatchRun& batch, const std::string& function) const {
  const std::vector<std::string> parts = parts_of_emitted(function, built_.front().model.requests);
  const int call = batch.find(function);
  batch.evaluate(call);
  Deviation deviation;
  for (std::size_t i = 0; i < peer_states; ++i) {
    State state = pool_[i];
    state.inputs = default_inputs(scene_);  // as the batch has them
    const auto expected = comparable(scene_, parts, state.x, generic_path<long double>(scene_, parts, state));
    deviation.add(comparable(scene_, parts, state.x, batch.result(call, i)), expected);
  }
  return deviation.largest();
}

void Entrants::add_generic(const std::string& function) {
  const std::vector<std::string> parts = parts_of_emitted(function, built_.front().model.requests);
  add({function, "generic"}, {[this, parts, inputs = default_inputs(scene_)](benchmark::State& loop) {
        run(loop, pool_.size(), [&](std::size_t at) {
          const State& state = pool_[at];
          const generic::Arguments<double> arguments{state.t, state.x, state.y, state.ydot, inputs};
          for (const std::string& part : parts)
            benchmark::DoNotOptimize(generic::evaluate(generic_, part, arguments).data());
        });
      }});
}

void Entrants::add_peer(const Peer& peer) {
  Entry entry{"accelerations", peer.name()};
  try {
    prepare_peers();
    PeerSimulation& simulation = simulations_.emplace_back(peer, *relative_, relative_pool_);
    entry.note = peer.note();
    entry.difference = largest_difference(simulation);
    if (*entry.difference < most_difference)
      return add(std::move(entry), {[this, &simulation](benchmark::State& loop) {
                   run(loop, pool_.size(), [&](std::size_t at) { simulation.accelerate(at); });
                 }});
    entry.note = fmt::format("differs by {:.2g}: not timed", *entry.difference);
  } catch (const NotModelled& error) {
    entry.note = std::string("not modelled: ") + error.what();
  }
  contest.entries.push_back(std::move(entry));
}

void Entrants::prepare_peers() {
  if (relative_) return;
  RelativeModel model = relative_model(scene_);
  relative_ = std::move(model);
  const RelativeStates states(scene_, *relative_);
  for (const State& state : pool_) relative_pool_.push_back(states.of(state));
  for (std::size_t i = 0; i < peer_states; ++i) expected_.push_back(states.rates(accelerated(scene_, pool_[i])));
}

double Entrants::largest_difference(PeerSimulation& simulation) const {
  Deviation deviation;
  for (std::size_t i = 0; i < expected_.size(); ++i) deviation.add(simulation.result(i), expected_[i]);
  return deviation.largest();
}

void Entrants::add(Entry entry, Loop loop) {
  loop_of.push_back(contest.entries.size());
  contest.entries.push_back(std::move(entry));
  loops.push_back(std::move(loop));
}

}  // namespace kanec
