// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/lanes/compiled.hpp"

#include <algorithm>
#include <stdexcept>

#include "runtime/lanes/files.hpp"

namespace kanec::test {
namespace {

// Those of `all`, values in that order, that the model names.
std::vector<double> named(const std::vector<scene::Named>& all, const std::vector<double>& values,
                          const char* const* names, int count) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) {
    const auto at = std::find_if(all.begin(), all.end(), [&](const scene::Named& n) { return n.name == names[i]; });
    if (at == all.end()) throw std::logic_error("the scene has no such name");
    result.push_back(values[static_cast<std::size_t>(at - all.begin())]);
  }
  return result;
}

}  // namespace

compile::Model compiled_in_lanes(const Generated& generated, const scene::Scene& scene, const LaneChoice& choice) {
  compile::Source batch = source(generated, scene, generated.name + "_batch.cpp", generated.batch);
  for (auto& file : lane_files()) batch.files.push_back(file);
  batch.flags = lane_flags(choice.scalar, choice.lanes);
  batch.is_batch = true;
  return compile::build(batch, compile_options());
}

std::vector<double> read_parameters(const Sample& sample, const kanec_model& model) {
  return named(sample.scene.parameters, sample.parameters, model.parameter_names, model.n_parameters);
}

std::vector<double> read_inputs(const Sample& sample, const kanec_model& model) {
  return named(sample.scene.inputs, sample.inputs, model.input_names, model.n_inputs);
}

std::vector<double> scalar_result(Solver& solver, const std::string& function, const Sample& sample) {
  solver.set_parameters(read_parameters(sample, solver.model()));
  solver.set_inputs(read_inputs(sample, solver.model()));
  const kanec_function& entry = *solver.find(function);
  std::vector<double> out(static_cast<std::size_t>(entry.n_out));
  solver.evaluate(entry, sample.t, sample.state.x.data(), sample.state.y.data(), sample.state.ydot.data(), out.data());
  return out;
}

template <class Real>
std::size_t SampleBatch<Real>::size(int n) const {
  return static_cast<std::size_t>((count + stride - 1) / stride * stride * n);
}

template <class Real>
double SampleBatch<Real>::at(const std::vector<Real>& results, int n, int i, std::int64_t j) const {
  return static_cast<double>(results[static_cast<std::size_t>((j / stride * n + i) * stride + j % stride)]);
}

template <class Real>
SampleBatch<Real>::SampleBatch(const std::vector<Sample>& samples, const kanec_model& model, std::int64_t given)
    : count(static_cast<std::int64_t>(samples.size())), stride(given == 0 ? count : given) {
  const auto place = [&](std::vector<Real>& to, std::int64_t j, const std::vector<double>& values) {
    const int n = static_cast<int>(values.size());
    to.resize(size(n));
    for (int i = 0; i < n; ++i)
      to[static_cast<std::size_t>((j / stride * n + i) * stride + j % stride)] =
          static_cast<Real>(values[static_cast<std::size_t>(i)]);
  };
  for (std::int64_t j = 0; j < count; ++j) {
    const Sample& sample = samples[static_cast<std::size_t>(j)];
    t.push_back(static_cast<Real>(sample.t));
    place(x, j, sample.state.x);
    place(y, j, sample.state.y);
    place(ydot, j, sample.state.ydot);
    place(u, j, read_inputs(sample, model));
    place(parameters, j, read_parameters(sample, model));
  }
}

template <class Real>
BatchStates<Real> SampleBatch<Real>::states() const {
  BatchStates<Real> states;
  states.count = count;
  states.stride = stride;
  states.t = t.data();
  states.x = x.data();
  states.y = y.data();
  states.ydot = ydot.data();
  states.u = u.data();
  return states;
}

template struct SampleBatch<double>;
template struct SampleBatch<float>;

}  // namespace kanec::test
