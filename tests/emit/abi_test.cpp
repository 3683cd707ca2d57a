// The source that puts a header's functions behind the ABI, compiled and loaded. Oracles: the scene, the ledger, and
// the program evaluated operation by operation.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>

#include "generator/pipeline.hpp"
#include "generator/program/ledger.hpp"
#include "generator/read/read.hpp"
#include "generator/scene/entry_names.hpp"
#include "runtime/abi/solver.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/process.hpp"
#include "tests/base/folder.hpp"
#include "tests/emit/every_node.hpp"
#include "tests/lower/sample.hpp"

namespace kanec::test {
namespace {

// Compiled with strict warnings and loaded; unloaded with this.
class Loaded {
 public:
  explicit Loaded(const Generated& generated) {
    const std::filesystem::path source = folder_.path() / (generated.name + "_abi.cpp");
    const std::string library = (folder_.path() / "model.so").string();
    write_file(folder_.path() / (generated.name + ".hpp"), generated.header);
    write_file(source, generated.abi);
    const ProcessResult result =
        run_process({"g++", "-std=c++17", "-O0", "-ffp-contract=off", "-DKANEC_LIBM_COS_SIN", "-Wall", "-Wextra",
                     "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror", "-shared", "-fPIC",
                     "-I" KANEC_SOURCE_DIR "/runtime/abi", source.string(), "-o", library});
    if (result.status != 0 || !result.output.empty()) throw std::runtime_error(result.output);
    handle_ = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr) throw std::runtime_error(::dlerror());
  }
  ~Loaded() {
    if (handle_ != nullptr) ::dlclose(handle_);
  }
  Loaded(const Loaded&) = delete;
  Loaded& operator=(const Loaded&) = delete;

  const kanec_model& model() const { return *reinterpret_cast<kanec_entry>(::dlsym(handle_, KANEC_ENTRY))(); }

 private:
  Folder folder_;
  void* handle_ = nullptr;
};

class Abi : public testing::TestWithParam<const char*> {
 protected:
  const scene::Scene scene = scene::read(std::string(KANEC_SOURCE_DIR "/models/") + GetParam() + "/scene.toml");
  const Generated generated = generate(scene);
  const Loaded loaded{generated};
  const kanec_model& model = loaded.model();

  static void expect_named(const char* const* names, const double* defaults,
                           const std::vector<scene::Named>& expected) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(names[i], expected[i].name);
      EXPECT_EQ(defaults[i], expected[i].value);
    }
  }
};

// What programs were compiled with. Oracle: the layout of version 5, written down; another one is another version.
TEST(AbiLayout, is_that_of_its_version) {
  static_assert(KANEC_ABI_VERSION == 5u);
  if (sizeof(void*) != 8) GTEST_SKIP() << "written down for pointers of eight bytes";
  EXPECT_EQ(sizeof(kanec_function), 48u);
  EXPECT_EQ(offsetof(kanec_function, n_out), 8u);
  EXPECT_EQ(offsetof(kanec_function, other_functions), 32u);
  EXPECT_EQ(offsetof(kanec_function, reads), 36u);
  EXPECT_EQ(offsetof(kanec_function, evaluate), 40u);
  EXPECT_EQ(sizeof(kanec_attitude), 8u);
  EXPECT_EQ(sizeof(kanec_pattern), 40u);
  EXPECT_EQ(sizeof(kanec_taylor), 56u);
  EXPECT_EQ(offsetof(kanec_model, struct_size), 4u);
  EXPECT_EQ(offsetof(kanec_model, n_bodies), 24u);
  EXPECT_EQ(offsetof(kanec_model, parameter_names), 48u);
  EXPECT_EQ(offsetof(kanec_model, prepared_size), 80u);
  EXPECT_EQ(offsetof(kanec_model, functions), 96u);
  EXPECT_EQ(offsetof(kanec_model, attitudes), 128u);
  EXPECT_EQ(offsetof(kanec_model, patterns), 160u);
  EXPECT_EQ(sizeof(kanec_model), 168u);
  EXPECT_EQ(sizeof(kanec_states), 96u);
  EXPECT_EQ(sizeof(kanec_group), 64u);
  EXPECT_EQ(sizeof(kanec_batch), 72u);
}

INSTANTIATE_TEST_SUITE_P(Models, Abi, testing::Values("free_body", "six_body"));

TEST_P(Abi, describes_the_model_and_evaluates_its_program) {
  EXPECT_EQ(model.abi_version, KANEC_ABI_VERSION);
  EXPECT_EQ(model.struct_size, sizeof(kanec_model));
  EXPECT_EQ(model.name, scene.name);
  EXPECT_EQ(model.hash, generated.hash);
  EXPECT_EQ(model.n_bodies, size(scene));
  EXPECT_EQ(model.nx, n_coordinates(scene));
  EXPECT_EQ(model.ny, n_speeds(scene));
  ASSERT_EQ(static_cast<std::size_t>(model.n_parameters), scene.parameters.size());
  ASSERT_EQ(static_cast<std::size_t>(model.n_inputs), scene.inputs.size());
  expect_named(model.parameter_names, model.parameter_defaults, scene.parameters);
  expect_named(model.input_names, model.input_defaults, scene.inputs);

  Random random(15);
  const Sample sample = sample_of(scene, random);
  Solver solver(model);
  solver.set_parameters(sample.parameters);
  solver.set_inputs(sample.inputs);
  const program::Arguments<double> at{sample.parameters, sample.state.x, sample.state.y, sample.state.ydot,
                                      sample.inputs};
  const std::vector<program::Function>& functions = generated.program.functions;
  ASSERT_EQ(static_cast<std::size_t>(model.n_functions), functions.size());
  for (const program::Function& function : functions) {
    SCOPED_TRACE(function.name);
    const kanec_function* record = solver.find(function.name);
    ASSERT_NE(record, nullptr);
    EXPECT_EQ(record->n_out, function.n_out);
    EXPECT_EQ((program::Ledger{record->adds, record->multiplies, record->divides, record->square_roots,
                               record->trigonometric, record->other_functions}),
              program::ledger(generated.program, function));
    std::vector<double> out(static_cast<std::size_t>(function.n_out), 12345.0);
    solver.evaluate(*record, 0, at.x.data(), at.y.data(), at.ydot.data(), out.data());
    EXPECT_EQ(out, evaluate(generated.program, function, at));
  }
}

TEST_P(Abi, names_the_state_and_says_where_attitudes_stand) {
  const std::vector<std::string> coordinates = in_words(scene, coordinate_names(scene)),
                                 speeds = in_words(scene, speed_names(scene));
  for (std::size_t i = 0; i < coordinates.size(); ++i) EXPECT_EQ(model.coordinate_names[i], coordinates[i]);
  for (std::size_t i = 0; i < speeds.size(); ++i) EXPECT_EQ(model.speed_names[i], speeds[i]);
  const std::vector<std::string> words = body_words(scene);
  ASSERT_EQ(model.n_attitudes, size(scene));  // every joint is free
  for (int k = 0; k < model.n_attitudes; ++k) {
    EXPECT_EQ(coordinates[static_cast<std::size_t>(model.attitudes[k].eps)],
              "eps_" + words[static_cast<std::size_t>(k)] + "_1");
    EXPECT_EQ(speeds[static_cast<std::size_t>(model.attitudes[k].omega)],
              "omega_" + words[static_cast<std::size_t>(k)] + "_1");
  }
}

// Oracle: the values. A is full where bodies move each other, and has no entry twice in its pattern.
TEST_P(Abi, patterns_are_of_the_entries_that_are_not_0) {
  Random random(15);
  const Sample sample = sample_of(scene, random);
  Solver solver(model);
  const kanec_pattern* pattern = solver.find_pattern("mass_matrix");
  ASSERT_NE(pattern, nullptr);
  EXPECT_EQ(pattern->rows, model.ny);
  EXPECT_EQ(pattern->columns, model.ny);
  const kanec_function& function = *solver.find("mass_matrix");
  std::vector<double> A(static_cast<std::size_t>(function.n_out));
  solver.evaluate(function, 0, sample.state.x.data(), nullptr, nullptr, A.data());
  std::ptrdiff_t nonzeros = 0;
  for (int k = 0; k < pattern->nonzeros; ++k) {
    double& entry = A[static_cast<std::size_t>(pattern->row_of[k] * pattern->columns + pattern->column_of[k])];
    nonzeros += entry != 0.0;
    entry = 0.0;
  }
  EXPECT_EQ(nonzeros, pattern->nonzeros);
  for (const double entry : A) EXPECT_EQ(entry, 0.0);
  EXPECT_EQ(solver.find_pattern("kinematics"), nullptr);
}

// Time goes through, parameters and inputs that nothing reads are no part of the model, results of a combined function
// stand one after another. Oracle: the program.
TEST(AbiOfEveryNode, evaluates_its_program_at_a_time_with_what_it_reads) {
  const Sample sample = every_node_sample();
  const Generated generated = every_node_model(sample.scene);
  const Loaded loaded(generated);
  const kanec_model& model = loaded.model();
  ASSERT_EQ(model.n_parameters, 2);
  EXPECT_STREQ(model.parameter_names[1], "b");
  ASSERT_EQ(model.n_inputs, 1);
  EXPECT_STREQ(model.input_names[0], "drive");
  Solver solver(model);
  solver.set_parameters(std::vector{sample.parameters[0], sample.parameters[2]});
  solver.set_inputs(std::vector{sample.inputs[1]});
  program::Arguments<double> at = arguments<double>(sample);
  at.time = 0.3;
  for (const program::Function& function : generated.program.functions) {
    std::vector<double> out(static_cast<std::size_t>(function.n_out), 12345.0);
    solver.evaluate(*solver.find(function.name), at.time, at.x.data(), at.y.data(), at.ydot.data(), out.data());
    EXPECT_EQ(out, evaluate(generated.program, function, at)) << function.name;
    EXPECT_EQ(solver.find(function.name)->other_functions, ledger(generated.program, function).functions);
  }
}

}  // namespace
}  // namespace kanec::test
