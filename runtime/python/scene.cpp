// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/python/scene.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kanec/kanec.hpp"
#include "runtime/python/arrays.hpp"
#include "runtime/python/errors.hpp"
#include "runtime/python/latex.hpp"
#include "runtime/python/model.hpp"
#include "runtime/python/motion.hpp"
#include "runtime/python/table.hpp"

namespace kanec::python {
namespace {

using Path = std::optional<std::filesystem::path>;
using Unlocked = py::call_guard<py::gil_scoped_release>;

constexpr int most_rows = 100;  // in a notebook
constexpr int most_bodies = 32;

// None, one name, or some.
std::vector<std::string> names_of(const py::object& functions) {
  if (functions.is_none()) return {};
  if (PyUnicode_Check(functions.ptr())) return {functions.cast<std::string>()};
  std::vector<std::string> names;
  try {
    for (const py::handle name : functions) names.push_back(py::cast<std::string>(name));
    return names;
  } catch (const py::cast_error&) {
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_TypeError)) throw;
  }
  refuse("functions", std::string(py::repr(functions)), "None, a name, or a list of names");
}

Emission emission_of(const py::object& functions, std::string optimize, std::string algorithm, bool taylor) {
  Emission emission;
  emission.functions = names_of(functions);
  emission.optimize = std::move(optimize);
  emission.algorithm = std::move(algorithm);
  emission.taylor = taylor;
  return emission;
}

Compilation compilation_of(std::string compiler, std::string flags, const Path& cache, bool use_cache) {
  Compilation compilation;
  compilation.compiler = std::move(compiler);
  compilation.flags = std::move(flags);
  compilation.cache = cache.value_or(std::filesystem::path());
  compilation.use_cache = use_cache;
  return compilation;
}

template <class Work>
auto unlocked(Work work) {
  const py::gil_scoped_release release;
  return work();
}

// What `make` makes, and then a warning for each remark of reading.
template <class Make>
Scene remarked(Make make) {
  std::vector<std::string> remarks;
  Scene scene = unlocked([&] {
    Scene made = make();
    remarks = made.remarks();
    return made;
  });
  warn(remarks);
  return scene;
}

// Notes of the generator, told once the work is done.
struct Notes {
  std::vector<std::string> texts = {};
  void hear(Emission& emission) {
    emission.tell = [this](const std::string& note) { texts.push_back(note); };
  }
};

py::dict generated(const Scene& self, const py::object& functions, std::string language, std::string optimize,
                   std::string algorithm, bool taylor, bool abi) {
  Emission emission = emission_of(functions, std::move(optimize), std::move(algorithm), taylor);
  emission.language = std::move(language);
  emission.abi = abi;
  Notes notes;
  notes.hear(emission);
  const std::vector<File> files = unlocked([&] { return self.generate(emission); });
  warn(notes.texts);
  py::dict dict;
  for (const File& file : files) dict[py::str(file.name)] = file.text;
  return dict;
}

py::object compiled(const Scene& self, const py::object& functions, std::string optimize, std::string algorithm,
                    bool taylor, std::string compiler, std::string flags, const Path& cache, bool use_cache,
                    int threads) {
  if (threads < 0) refuse("threads", std::to_string(threads), "0, one a processor, or more");
  Emission emission = emission_of(functions, std::move(optimize), std::move(algorithm), taylor);
  Compilation compilation = compilation_of(std::move(compiler), std::move(flags), cache, use_cache);
  const Emission kept = emission;
  const Compilation kept_compilation = compilation;
  Notes notes;
  notes.hear(emission);
  compilation.poll = watch_for_signals();
  const Model model = unlocked([&] { return self.compile(emission, compilation); });
  warn(notes.texts);
  return make_model(self, model, kept, kept_compilation, threads);
}

std::vector<Agreed> checked(const Scene& self, const py::object& functions, int states, std::uint64_t seed,
                            std::string optimize, std::string algorithm, std::string compiler, std::string flags,
                            const Path& cache, bool use_cache) {
  const Emission emission = emission_of(functions, std::move(optimize), std::move(algorithm), false);
  Compilation compilation = compilation_of(std::move(compiler), std::move(flags), cache, use_cache);
  compilation.poll = watch_for_signals();
  return unlocked([&] { return self.check(emission, compilation, states, seed); });
}

Scene with_values(const Scene& self, const py::object& given, const py::kwargs& keywords) {
  std::vector<Quantity> values;
  for (const py::object& dict : {given, py::object(keywords)}) {
    if (dict.is_none()) continue;
    if (!PyDict_Check(dict.ptr())) refuse("values", description(dict.ptr()), "a dict of numbers by name");
    for (const auto& [name, value] : py::reinterpret_borrow<py::dict>(dict)) {
      if (!PyUnicode_Check(name.ptr())) refuse("values", "the key " + std::string(py::repr(name)), "names");
      const auto word = name.cast<std::string>();
      values.push_back({word, number(value.ptr(), word)});
    }
  }
  return self.with(values);
}

py::object simulate_scene(const Scene& self, const py::object& x, const py::object& y, std::optional<double> duration,
                          std::optional<double> output_step, std::optional<std::string> integrator,
                          std::optional<double> step, std::optional<double> longest_step, std::optional<double> rtol,
                          std::optional<double> atol, std::optional<int> order, std::optional<std::string> jacobian,
                          std::string compiler, std::string flags, const Path& cache, bool use_cache,
                          const py::kwargs& values) {
  const Scene scene = values.empty() ? self : with_values(self, py::none(), values);
  Run run = scene.run();
  apply({duration, output_step, step, longest_step, rtol, atol, std::move(integrator), std::move(jacobian), order},
        run);
  return simulated(scene, x, y, run, compilation_of(std::move(compiler), std::move(flags), cache, use_cache));
}

py::object in_notebook(const Scene& self) {
  if (self.bodies().size() > most_bodies) return py::none();
  return py::str(display_of(unlocked([&] { return self.derive("latex"); }), most_rows));
}

py::dict offers(const Scene& self) {
  py::dict dict;
  for (Offer& offer : unlocked([&] { return self.functions(); })) {
    const py::str name(offer.name);
    dict[name] = std::move(offer);
  }
  return dict;
}

py::object row(const std::vector<double>& numbers) {
  auto array = py::reinterpret_steal<py::object>(new_array({static_cast<npy_intp>(numbers.size())}, NPY_DOUBLE));
  std::copy(numbers.begin(), numbers.end(), static_cast<double*>(PyArray_DATA(array_of(array))));
  return array;
}

std::string scene_representation(const Scene& self) {
  return "<kanec.Scene " + self.name() + ": " + std::to_string(self.bodies().size()) + " bodies, nx " +
         std::to_string(self.nx()) + ", ny " + std::to_string(self.ny()) + ">";
}

void bind_ways_in(py::module_& module) {
  module.def(
      "read", [](const std::filesystem::path& path) { return remarked([&] { return Scene::read(path); }); },
      py::arg("path"), R"(A scene out of a scene.toml, or the folder of one.

Raises SceneError, FileError; what is remarkable in it is a warning of the category kanec.Note.)");
  module.def(
      "parse",
      [](const std::string& text, const std::string& origin) {
        return remarked([&] { return Scene::parse(text, origin); });
      },
      py::arg("text"), py::arg("origin") = "scene",
      R"(A scene out of TOML; `origin` only names the text in messages. Raises SceneError.)");
  module.def(
      "build",
      [](const py::dict& scene) {
        const Table table = table_of(scene);
        return remarked([&] { return Scene::build(table); });
      },
      py::arg("scene"), R"(A scene out of a dict with the keys of a scene file.

Values are bool, int, float, str, lists, tuples, arrays and dicts. Raises InputError for anything else, with the key;
SceneError as read().)");
  module.def(
      "tree", [](const std::vector<int>& lower) { return remarked([&] { return Scene::tree(lower); }); },
      py::arg("lower"),
      R"(The all-symbolic system of a connection array: lower[k] is the body that k + 1 stands on, 0 the
inertial frame. Raises SceneError.)");
}

void bind_agreed(py::module_& module) {
  py::class_<Agreed>(module, "Agreed", "How far a function's compiled code is from independent computations of it.")
      .def_readonly("function", &Agreed::function, "Its name.")
      .def_readonly("largest_ulps", &Agreed::largest_ulps, "From 50-digit arithmetic.")
      .def_readonly("median_ulps", &Agreed::median_ulps, "From 50-digit arithmetic.")
      .def_readonly("generic", &Agreed::generic, "Relative, from the generic numeric path in long double.")
      .def_readonly("generic_double", &Agreed::generic_double, "Of the generic path in double from that.")
      .def_readonly("undefined", &Agreed::undefined, "States without a result.")
      .def_readonly("passed", &Agreed::passed, "Whether that is as near as rounding explains.")
      .def("__repr__", [](const Agreed& self) {
        return "<kanec.Agreed " + self.function + ": " + (self.passed ? "passed>" : "failed>");
      });
}

using SceneClass = py::class_<Scene>;

void bind_description(SceneClass& scene) {
  scene.def_property_readonly("name", &Scene::name, "Its name, which is that of emitted code.")
      .def_property_readonly("text", &Scene::text, "TOML that reads back as the same scene.")
      .def_property_readonly("remarks", &Scene::remarks, "Notes and warnings of reading.")
      .def_property_readonly("bodies", &Scene::bodies, "Names of the bodies, in order.")
      .def_property_readonly("connection", &Scene::connection, "The lower body of each, 0 for the inertial frame.")
      .def_property_readonly("nx", &Scene::nx, "Number of coordinates.")
      .def_property_readonly("ny", &Scene::ny, "Number of speeds.")
      .def_property_readonly("x", &Scene::x, "What the coordinates are: a Shape.")
      .def_property_readonly("y", &Scene::y, "What the speeds are: a Shape.")
      .def_property_readonly("ydot", &Scene::ydot, "What the accelerations are: a Shape.")
      .def_property_readonly(
          "parameters", [](const Scene& self) { return dict_of(self.parameters()); },
          "Values by name; see with_values().")
      .def_property_readonly(
          "inputs", [](const Scene& self) { return dict_of(self.inputs()); }, "Values by name; see with_values().")
      .def_property_readonly(
          "initial_x", [](const Scene& self) { return row(self.initial_x()); }, "A new array (nx).")
      .def_property_readonly(
          "initial_y", [](const Scene& self) { return row(self.initial_y()); }, "A new array (ny).")
      .def_property_readonly(
          "run", [](const Scene& self) { return dict_of(self.run()); },
          "Its [simulate]: what simulate() takes where nothing else is given.")
      .def_property_readonly("functions", offers, "Functions that a model of it can have: an Offer for each name.")
      .def("results", &Scene::results, py::arg("request"), Unlocked(),
           R"(What a function returns: a Shape for each part of "kinematics+accelerations". Raises InputError.)")
      .def("with_values", with_values, py::arg("values") = py::none(),
           R"(The same scene with other values of parameters and inputs, given as a dict or by keyword.

Raises InputError for names it does not have, SceneError for masses and inertias that cannot be.)")
      .def("derive", &Scene::derive, py::arg("format") = "text", Unlocked(),
           R"(The equations of motion: "text", "latex" (a document) or "json". Raises InputError.)")
      .def("_repr_latex_", in_notebook, "A, f and their letters, for a notebook; None of more than 32 bodies.")
      .def("__repr__", scene_representation);
}

constexpr const char* compile_doc = R"(A compiled Model, out of the cache where it was compiled before.

functions: names, with + between those that share one call; None: those that the scene names, else the usual ones.
optimize: "speed", "size", "line" or "loops". algorithm: "auto", "composite" or "articulated". compiler, flags: "" for
the usual ones. cache: a folder; None: $KANEC_CACHE, or ~/.cache/kanec. threads: for many states at once; 0: one a
processor. Raises InputError, BuildError, LoadError; what the generator remarks is a warning of the category Note.)";

void bind_generation(SceneClass& scene) {
  scene
      .def("generate", generated, py::arg("functions") = py::none(), py::kw_only(), py::arg("language") = "cpp",
           py::arg("optimize") = "speed", py::arg("algorithm") = "auto", py::arg("taylor") = false,
           py::arg("abi") = false,
           R"(Source code: a dict of text by file name.

language: "cpp" or "c". taylor: with the Taylor series of the motion. abi: with what a shared library is made of. All
else as in compile(). Raises InputError.)")
      .def("compile", compiled, py::arg("functions") = py::none(), py::kw_only(), py::arg("optimize") = "speed",
           py::arg("algorithm") = "auto", py::arg("taylor") = false, py::arg("compiler") = "", py::arg("flags") = "",
           py::arg("cache") = py::none(), py::arg("use_cache") = true, py::arg("threads") = 0, compile_doc)
      .def("check", checked, py::arg("functions") = py::none(), py::kw_only(), py::arg("states") = 32,
           py::arg("seed") = 1, py::arg("optimize") = "speed", py::arg("algorithm") = "auto", py::arg("compiler") = "",
           py::arg("flags") = "", py::arg("cache") = py::none(), py::arg("use_cache") = true,
           R"(Compares compiled code with 50-digit arithmetic and with the generic path, in seeded random states.

Returns a list of Agreed. Compilation as in compile(). Raises InputError, BuildError, LoadError.)");
}

void bind_simulation(SceneClass& scene) {
  scene.def("simulate", simulate_scene, py::arg("x") = py::none(), py::arg("y") = py::none(), py::kw_only(),
            py::arg("duration") = py::none(), py::arg("output_step") = py::none(), py::arg("integrator") = py::none(),
            py::arg("step") = py::none(), py::arg("longest_step") = py::none(), py::arg("rtol") = py::none(),
            py::arg("atol") = py::none(), py::arg("order") = py::none(), py::arg("jacobian") = py::none(),
            py::arg("compiler") = "", py::arg("flags") = "", py::arg("cache") = py::none(), py::arg("use_cache") = true,
            R"(Integrates from x (nx) and y (ny), or from the scene's initial state: a Motion.

duration, output_step, step (of fixed steps), longest_step (of those with error control) [s]; rtol, atol: tolerances;
integrator: one of integrators(); order, jacobian: as `kanec simulate --help` has them; what is None is the scene's
(`run`). All other keywords are values of parameters and inputs, as in with_values(). Compilation as in compile().
Events of the scene are watched for. Raises InputError, SceneError, BuildError, IntegrationError.)");
}

}  // namespace

void bind_scene(py::module_& module) {
  bind_agreed(module);
  SceneClass scene(module, "Scene",
                   R"(A tree of rigid bodies, its numbers and its loads; made by read(), parse(), build() and tree().

It does not change, and may be used from several threads at once. SI units, angles in rad.)");
  bind_description(scene);
  bind_generation(scene);
  bind_simulation(scene);
  bind_ways_in(module);
}

}  // namespace kanec::python
