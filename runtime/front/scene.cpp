// SPDX-License-Identifier: GPL-2.0-or-later
#include "kanec/scene.hpp"

#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "generator/choice/candidates.hpp"
#include "generator/read/read.hpp"
#include "generator/scene/place.hpp"
#include "generator/scene/states.hpp"
#include "runtime/base/text.hpp"
#include "runtime/model/equations.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/model/model.hpp"
#include "runtime/model/products.hpp"
#include "runtime/model/result_layout.hpp"
#include "runtime/model/scene_files.hpp"
#include "runtime/model/scene_text.hpp"
#include "runtime/model/settings.hpp"
#include "runtime/model/state_layout.hpp"
#include "runtime/run/integration_options.hpp"
#include "runtime/run/needed_functions.hpp"
#include "runtime/verify/agreement.hpp"
#include "runtime/verify/samples.hpp"

namespace kanec {

struct Scene::Data {
  scene::Scene as_read;  // what a model is generated from
  scene::Scene scene;    // with the values of with()
};

namespace {

using Turn = std::scoped_lock<std::recursive_mutex>;

Shape shape_of(const Layout& layout) {
  Shape shape{layout.name, {}, layout.rows, layout.columns, 0};
  for (const Block& block : layout.blocks) {
    const int size = static_cast<int>(block.size());
    shape.parts.push_back({block.name, block.shape, block.unit, shape.size, size});
    shape.size += size;
  }
  return shape;
}

std::vector<Quantity> quantities_of(const std::vector<scene::Named>& list) {
  std::vector<Quantity> result;
  for (const scene::Named& named : list) result.push_back({named.name, named.value});
  return result;
}

template <class Choice>
Choice chosen(const char* what, const std::string& found, const std::vector<std::pair<std::string, Choice>>& known) {
  std::vector<std::string> names;
  for (const auto& [name, choice] : known) {
    if (name == found) return choice;
    names.push_back(name);
  }
  throw InputError(std::string(what) + ": found " + scene::in_quotes(found) +
                   "; allowed: " + scene::one_of(names, found));
}

emit::Optimize optimize_of(const Emission& emission) {
  const auto& goals = optimize_goals();
  return chosen<emit::Optimize>("optimize", emission.optimize, {goals.begin(), goals.end()});
}

std::optional<symbolic::Algorithm> algorithm_of(const Emission& emission) {
  using symbolic::Algorithm;
  return chosen<std::optional<Algorithm>>("algorithm", emission.algorithm,
                                          {{"auto", std::nullopt},
                                           {name(Algorithm::composite), Algorithm::composite},
                                           {name(Algorithm::articulated), Algorithm::articulated}});
}

Products products_of(const Emission& emission) {
  const Products products{
      chosen<emit::Language>("language", emission.language, {{"cpp", emit::Language::cpp}, {"c", emit::Language::c}}),
      emission.abi, emission.taylor};
  check_products(products);
  return products;
}

// Its lines of what becomes of the model are for a terminal; notes begin with "note: ".
BuildOptions build_options(const Emission& emission, const Compilation& compilation) {
  BuildOptions options;
  options.algorithm = algorithm_of(emission);
  options.optimize = optimize_of(emission);
  options.compiler = compilation.compiler;
  options.flags = compilation.flags;
  options.flags_given = !compilation.flags.empty();
  options.no_cache = !compilation.use_cache;
  options.cache = compilation.cache.string();
  static constexpr std::string_view note = "note: ";
  if (emission.tell)
    options.tell = [tell = emission.tell](const std::string& text) {
      if (text.rfind(note, 0) == 0) tell(text.substr(note.size()));
    };
  if (compilation.poll) options.watch = [poll = compilation.poll] { return poll; };
  return options;
}

std::vector<std::string> requests_of(const scene::Scene& scene, const Emission& emission) {
  const Turn turn(derivation_turn());
  return Functions(scene).chosen(emission.functions);
}

CompiledModel compiled(const scene::Scene& scene, const Emission& emission, const Compilation& compilation) {
  if (emission.language != "cpp" || emission.abi)
    throw InputError("a compiled model: found language " + scene::in_quotes(emission.language) +
                     (emission.abi ? " with abi" : "") + "; allowed: cpp without abi, which it has by itself");
  return build(scene, requests_of(scene, emission), build_options(emission, compilation), emission.taylor);
}

scene::Simulation simulation_of(const Run& run) {
  scene::Simulation simulation;
  simulation.duration = run.duration;
  simulation.output_step = run.output_step;
  simulation.integrator = run.integrator;
  simulation.step = run.step;
  simulation.longest_step = run.longest_step;
  simulation.relative_tolerance = run.relative_tolerance;
  simulation.absolute_tolerance = run.absolute_tolerance;
  simulation.order = run.order;
  simulation.jacobian = run.jacobian;
  return simulation;
}

WatchedEvent watched(const integrate::Event& from) {
  using Direction = integrate::Event::Direction;
  WatchedEvent event{from.name, 0, from.stops, from.has_row, {}};
  event.direction = from.direction == Direction::up ? 1 : from.direction == Direction::down ? -1 : 0;
  for (const integrate::Event::Setting& setting : from.settings)
    event.settings.push_back({setting.input, setting.value});
  return event;
}

// Parameters and inputs.
std::vector<Quantity> quantities_of(const scene::Scene& scene) {
  std::vector<Quantity> values = quantities_of(scene.parameters);
  for (const Quantity& input : quantities_of(scene.inputs)) values.push_back(input);
  return values;
}

}  // namespace

Scene::Scene(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

Scene Scene::read(const std::filesystem::path& path) {
  const scene::Scene scene = scene::read(scene_file(path.string()));
  return Scene(std::make_shared<Data>(Data{scene, scene}));
}

Scene Scene::parse(std::string_view text, const std::string& origin) {
  const scene::Scene scene = scene::parse(text, origin);
  return Scene(std::make_shared<Data>(Data{scene, scene}));
}

Scene Scene::build(const Table& table) { return parse(toml_text(table), "built scene"); }

Scene Scene::tree(const std::vector<int>& lower) {
  const scene::Scene scene = scene::from_connection(lower);
  return Scene(std::make_shared<Data>(Data{scene, scene}));
}

std::string Scene::name() const { return data_->scene.name; }
std::string Scene::text() const { return scene_text(data_->scene); }

std::vector<std::string> Scene::remarks() const {
  std::vector<std::string> list = data_->scene.notes;
  list.insert(list.end(), data_->scene.warnings.begin(), data_->scene.warnings.end());
  return list;
}

std::vector<std::string> Scene::bodies() const {
  std::vector<std::string> names;
  for (const scene::Body& body : data_->scene.bodies) names.push_back(body.name);
  return names;
}

std::vector<int> Scene::connection() const { return data_->scene.lower; }
int Scene::nx() const { return n_coordinates(data_->scene); }
int Scene::ny() const { return n_speeds(data_->scene); }
Shape Scene::x() const { return shape_of(coordinates_layout(data_->scene)); }
Shape Scene::y() const { return shape_of(speeds_layout(data_->scene)); }
Shape Scene::ydot() const { return shape_of(speed_rates_layout(data_->scene)); }
std::vector<Quantity> Scene::parameters() const { return quantities_of(data_->scene.parameters); }
std::vector<Quantity> Scene::inputs() const { return quantities_of(data_->scene.inputs); }
std::vector<double> Scene::initial_x() const { return initial_coordinates(data_->scene); }
std::vector<double> Scene::initial_y() const { return initial_speeds(data_->scene); }

Run Scene::run() const {
  const scene::Simulation& from = data_->scene.simulation;
  const integrate::Options options = integration_options(data_->scene, from);
  Run run{from.duration,
          from.output_step,
          from.integrator,
          from.step,
          from.longest_step,
          from.relative_tolerance,
          from.absolute_tolerance,
          from.order,
          from.jacobian,
          options.has_kinks,
          {}};
  for (const integrate::Event& event : options.events) run.events.push_back(watched(event));
  return run;
}

Scene Scene::with(const std::vector<Quantity>& values) const {
  scene::Scene set = data_->scene;
  for (const Quantity& quantity : values) {
    if (!std::isfinite(quantity.value))
      throw InputError(quantity.name + ": found " + shortest(quantity.value) + "; allowed: a finite number");
    std::vector<std::string> names;
    bool found = false;
    for (auto* list : {&set.parameters, &set.inputs})
      for (scene::Named& named : *list) {
        names.push_back(named.name);
        if (named.name != quantity.name) continue;
        named.value = quantity.value;
        found = true;
      }
    if (!found)
      throw InputError(
          set.name + ": found " + scene::in_quotes(quantity.name) + "; allowed: " +
          (names.empty() ? "none, it has neither parameters nor inputs" : scene::one_of(names, quantity.name)));
  }
  check_defaults(set, set.name);
  return Scene(std::make_shared<Data>(Data{data_->as_read, std::move(set)}));
}

std::vector<Offer> Scene::functions() const {
  const scene::Scene& scene = data_->scene;
  const Turn turn(derivation_turn());
  const Functions functions(scene);
  std::vector<Offer> list;
  for (const Available& from : functions.all()) {
    const program::Signature& reads = from.signature;
    list.push_back({from.name, from.meaning, shape_of(result_layouts(scene, from.name).front()), reads_time(scene),
                    reads.x, reads.y, reads.ydot, reads.inputs && !scene.inputs.empty(), from.usual});
  }
  return list;
}

std::vector<Shape> Scene::results(const std::string& request) const {
  const Turn turn(derivation_turn());
  Functions(data_->scene).check(request);
  std::vector<Shape> shapes;
  for (const Layout& layout : result_layouts(data_->scene, request)) shapes.push_back(shape_of(layout));
  return shapes;
}

std::string Scene::derive(const std::string& format) const {
  const Turn turn(derivation_turn());
  return equations_text(data_->scene, format);
}

std::vector<File> Scene::generate(const Emission& emission) const {
  const scene::Scene& scene = data_->as_read;
  const Products products = products_of(emission);
  GenerateOptions options{requests_of(scene, emission), algorithm_of(emission), optimize_of(emission)};
  options.language = products.language;
  options.with_taylor = emission.taylor;
  options.tell = emission.tell ? emission.tell : [](const std::string&) {};
  const Turn turn(derivation_turn());
  if (emission.taylor) options.functions = functions_with_rates(scene, options.functions, options.tell);
  const std::vector<std::string> names = product_names(scene.name, products);
  const std::vector<std::string> texts = product_texts(kanec::generate(scene, options), products);
  std::vector<File> files;
  for (std::size_t i = 0; i < names.size(); ++i) files.push_back({names[i], texts[i]});
  return files;
}

Model Scene::compile(const Emission& emission, const Compilation& compilation) const {
  const auto owner = std::make_shared<const CompiledModel>(compiled(data_->as_read, emission, compilation));
  return Model(owner->library.abi(), owner).with(quantities_of(data_->scene));
}

Batch Scene::compile_batch(const Emission& emission, const Compilation& compilation, int threads,
                           const std::string& scalar, int lanes) const {
  chosen<int>("scalar", scalar, {{"double", 0}, {"float", 0}});
  if (lanes < 0 || lanes > 64 || (lanes & (lanes - 1)) != 0)
    throw InputError("lanes: found " + std::to_string(lanes) + "; allowed: 0, or a power of two up to 64");
  if (emission.taylor || emission.language != "cpp" || emission.abi)
    throw InputError("a batch: found language c, abi or taylor; allowed: cpp without them");
  const auto owner = std::make_shared<const CompiledModel>(build_batch(
      data_->as_read, requests_of(data_->as_read, emission), build_options(emission, compilation), {scalar, lanes}));
  const kanec_batch& batch = owner->library.batch();
  return {batch, Model(*batch.model, owner).with(quantities_of(data_->scene)), threads};
}

std::vector<Agreed> Scene::check(const Emission& emission, const Compilation& compilation, int states,
                                 std::uint64_t seed) const {
  if (states < 1) throw InputError("states: found " + std::to_string(states) + "; allowed: 1 or more");
  const CompiledModel model = compiled(data_->as_read, emission, compilation);
  const Turn turn(derivation_turn());
  std::vector<Agreed> list;
  const Bounds bounds;
  for (const Agreement& a : agreements(data_->scene, model, samples(data_->scene, states, seed), [&](double) {
         if (compilation.poll) compilation.poll();
       }))
    list.push_back(
        {a.function, a.largest_ulps, a.median_ulps, a.generic, a.generic_double, a.undefined, bounds.hold(a)});
  return list;
}

std::vector<std::string> Scene::functions_to_simulate(const Run& run) const {
  const Turn turn(derivation_turn());
  integrate::Options options = integration_options(data_->scene, simulation_of(run));
  std::vector<std::string> list = functions_to_integrate(data_->scene, options);
  list.emplace_back("energy");
  return list;
}

Motion Scene::simulate(const Run& run, const Compilation& compilation, const Progress& progress) const {
  Emission emission;
  emission.functions = functions_to_simulate(run);
  emission.taylor = needs_taylor(run);
  return kanec::simulate(Evaluator(compile(emission, compilation)), initial_x(), initial_y(), run, progress);
}

std::string library_version() { return version(); }

}  // namespace kanec
