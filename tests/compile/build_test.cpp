// Oracles: the toy's closed form, a compiler that counts its runs, the file system.
// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>
#include <iterator>

#include "kanec_abi_text.hpp"
#include "runtime/abi/batch_solver.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/base/process.hpp"
#include "tests/compile/bench.hpp"

namespace kanec::compile::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class Build : public Bench {};

template <class Fault>
std::string message_of(const Source& source, const Options& options) {
  try {
    build(source, options);
  } catch (const Fault& error) {
    return error.what();
  }
  return "nothing was thrown";
}

std::string mapped_files() {
  std::ifstream file("/proc/self/maps");
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(Build, model_is_compiled_and_called) {
  const Model model = build(toy(), options);
  EXPECT_EQ(evaluate(model), -12.0);
  EXPECT_STREQ(model.abi().name, "toy");
  EXPECT_FALSE(model.from_cache());
  EXPECT_GT(model.compile_seconds(), 0.0);
  EXPECT_THAT(model.notes(), IsEmpty());
  EXPECT_EQ(model.library(), cache() / entries().at(0) / "model.so");
  EXPECT_EQ(runs(), 1);
}

TEST_F(Build, batch_is_compiled_and_called) {
  const Model model = build(toy_batch(), options);
  BatchSolver<double> solver(model.batch());
  const double x[] = {3.0, 1.0, -2.0};
  double ydot[3] = {};
  BatchStates<double> states;
  states.count = 3;
  states.x = x;
  solver.evaluate(*solver.find("accelerations"), states, ydot);
  EXPECT_THAT(ydot, ElementsAre(-12.0, -4.0, 8.0));
  EXPECT_TRUE(build(toy_batch(), options).from_cache());
}

TEST_F(Build, batch_and_model_of_one_scene_are_two_entries) {
  build(toy(), options);
  Source batch = toy_batch();
  batch.flags = {"-DKANEC_SCALAR=double"};
  build(batch, options);
  batch.flags = {"-DKANEC_SCALAR=float"};
  build(batch, options);
  EXPECT_THAT(entries(), SizeIs(3));
}

TEST_F(Build, flags_of_the_source_stand_before_those_that_are_asked_for) {
  Source source = toy_with("= {4.0}", "= {FACTOR}");
  source.flags = {"-DFACTOR=5.0"};
  EXPECT_EQ(evaluate(build(source, options)), -15.0);
  options.flags = {"-O0", "-UFACTOR", "-DFACTOR=6.0"};
  EXPECT_EQ(evaluate(build(source, options)), -18.0);
}

TEST_F(Build, library_without_the_batch_that_is_asked_for_is_refused) {
  Source source = toy();
  source.is_batch = true;
  EXPECT_THAT(message_of<LoadError>(source, options), HasSubstr("kanec_model_batch"));
  Source other = toy_batch();
  other.files[1].second = replaced(other.files[1].second, "sizeof(kanec_batch)", "8u");
  EXPECT_EQ(message_of<LoadError>(other, options),
            "compiled model toy: batch descriptor size is 8, expected " + std::to_string(sizeof(kanec_batch)));
  EXPECT_THROW(build(toy(), options).batch(), InternalError);
}

TEST_F(Build, second_build_compiles_nothing) {
  build(toy(), options);
  const Model model = build(toy(), options);
  EXPECT_TRUE(model.from_cache());
  EXPECT_EQ(model.compile_seconds(), 0.0);
  EXPECT_EQ(evaluate(model), -12.0);
  EXPECT_EQ(runs(), 1);
  EXPECT_THAT(entries(), SizeIs(1));
}

TEST_F(Build, entry_holds_library_key_and_seal_and_no_sources) {
  EXPECT_THAT(names(make_entry()), ElementsAre("key", "model.so", "seal"));
}

TEST_F(Build, one_model_is_loaded_twice_at_once) {
  const Model first = build(toy(), options);
  const Model second = build(toy(), options);
  EXPECT_EQ(evaluate(first), evaluate(second));
}

TEST_F(Build, moved_model_stays_loaded) {
  Model first = build(toy(), options);
  const Model second = std::move(first);
  EXPECT_EQ(evaluate(second), -12.0);
}

TEST_F(Build, library_is_unloaded_with_its_model) {
  make_entry();
  {
    const Model model = build(toy(), options);
    EXPECT_THAT(mapped_files(), HasSubstr(model.library().string()));
  }
  EXPECT_THAT(mapped_files(), Not(HasSubstr(cache().string())));
}

TEST_F(Build, changed_source_is_compiled) {
  build(toy(), options);
  const Model model = build(toy_with("{4.0}", "{5.0}"), options);
  EXPECT_FALSE(model.from_cache());
  EXPECT_EQ(evaluate(model), -15.0);
  EXPECT_EQ(runs(), 2);
}

TEST_F(Build, changed_flags_are_compiled) {
  build(toy(), options);
  options.flags = {"-O1"};
  build(toy(), options);
  EXPECT_EQ(runs(), 2);
  options.flags = {"-O0"};
  EXPECT_TRUE(build(toy(), options).from_cache());
}

TEST_F(Build, changed_compiler_version_is_compiled) {
  build(toy(), options);
  std::ofstream(root() / "version") << "counting compiler 1.1\n";
  EXPECT_FALSE(build(toy(), options).from_cache());
  EXPECT_EQ(runs(), 2);
}

TEST_F(Build, changed_compiler_file_is_compiled) {
  build(toy(), options);
  fs::last_write_time(compiler(), fs::last_write_time(compiler()) - std::chrono::hours(1));
  EXPECT_FALSE(build(toy(), options).from_cache());
  EXPECT_EQ(runs(), 2);
}

TEST_F(Build, changed_include_path_is_compiled) {
  build(toy(), options);
  const Variable path("CPATH", root().string());
  EXPECT_FALSE(build(toy(), options).from_cache());
  EXPECT_EQ(runs(), 2);
}

TEST_F(Build, flags_come_from_the_environment_unless_given) {
  const Variable flags("KANEC_CXXFLAGS", " -O0\t-DTOY_DEFAULT=7.0 ");
  const Source source = toy_with("{4.0}", "{TOY_DEFAULT}");
  options.flags_given = false;
  EXPECT_EQ(evaluate(build(source, options)), -21.0);
  options.flags = {"-O0", "-DTOY_DEFAULT=1.0"};
  options.flags_given = true;
  EXPECT_EQ(evaluate(build(source, options)), -3.0);
}

TEST_F(Build, every_installed_compiler_makes_the_model_with_the_default_flags) {
  int found = 0;
  for (const char* name : {"c++", "g++", "clang++"}) {
    if (!find_program(name)) continue;
    ++found;
    options.compiler = name;
    options.flags_given = false;
    const Model model = build(toy(), options);
    EXPECT_FALSE(model.from_cache()) << name;
    EXPECT_EQ(evaluate(model), -12.0) << name;
  }
  EXPECT_GT(found, 0);
}

TEST_F(Build, library_exports_its_entry_alone) {
  const Source source = toy_with("namespace {", "int other_symbol() { return 1; }\nnamespace {");
  const auto symbols = find_program("nm");
  if (!symbols) GTEST_SKIP() << "nm is not installed";
  const Model model = build(source, options);
  const std::string list = run_process({"nm", "-D", "--defined-only", model.library().string()}).output;
  EXPECT_THAT(list, HasSubstr("kanec_model_entry"));
  EXPECT_THAT(list, Not(HasSubstr("other_symbol")));
}

TEST_F(Build, shared_header_is_carried_to_the_letter) {
  EXPECT_EQ(std::string(abi_text), read_file(fs::path(KANEC_SOURCE_DIR) / "runtime/abi/abi.h"));
}

TEST_F(Build, model_of_another_hash_is_refused) {
  Source source = toy();
  source.hash = "fedcba9876543210";
  EXPECT_EQ(message_of<LoadError>(source, options),
            "compiled model toy: hash is 0123456789abcdef, expected fedcba9876543210");
  EXPECT_THAT(entries(), IsEmpty());
}

TEST_F(Build, model_of_other_sizes_is_refused) {
  Source source = toy();
  source.nx = 7;
  EXPECT_EQ(message_of<LoadError>(source, options), "compiled model toy: nx is 1, expected 7");
  source = toy();
  source.ny = 6;
  EXPECT_EQ(message_of<LoadError>(source, options), "compiled model toy: ny is 1, expected 6");
  EXPECT_THAT(entries(), IsEmpty());
}

TEST_F(Build, model_of_another_abi_is_refused) {
  EXPECT_EQ(message_of<LoadError>(toy_with("KANEC_ABI_VERSION", "99u"), options),
            "compiled model toy: ABI version is 99, expected " + std::to_string(KANEC_ABI_VERSION));
  EXPECT_EQ(message_of<LoadError>(toy_with("sizeof(kanec_model)", "8u"), options),
            "compiled model toy: descriptor size is 8, expected " + std::to_string(sizeof(kanec_model)));
  EXPECT_THAT(entries(), IsEmpty());
}

TEST_F(Build, library_without_a_descriptor_is_refused) {
  EXPECT_THAT(message_of<LoadError>(toy_with("kanec_model_entry", "another_entry"), options),
              HasSubstr("undefined symbol: kanec_model_entry"));
  EXPECT_EQ(message_of<LoadError>(toy_with("return &model;", "return nullptr;"), options),
            "compiled model toy: no descriptor");
  EXPECT_EQ(message_of<LoadError>(toy_with("prepare, functions,", "prepare, nullptr,"), options),
            "compiled model toy: descriptor without functions");
}

TEST_F(Build, library_with_an_undefined_symbol_is_refused) {
  const Source source = toy_with("return &model;", "extern int missing(); return missing() ? &model : nullptr;");
  EXPECT_THAT(message_of<LoadError>(source, options), HasSubstr("undefined symbol: "));
  EXPECT_THAT(entries(), IsEmpty());
}

TEST_F(Build, unsound_names_are_our_mistake) {
  const auto with_file = [](const std::string& name) {
    Source source = toy();
    source.files.emplace_back(name, "");
    return source;
  };
  for (const char* name : {"../x.hpp", "a/b", "", ".", "..", "-x", "a b", "a\n"})
    EXPECT_EQ(message_of<InternalError>(with_file(name), options), "unsound name of a source file: " + fit::line(name));
  for (const char* name : {"toy.hpp", "abi.h", "made"})
    EXPECT_EQ(message_of<InternalError>(with_file(name), options), std::string("source file given twice: ") + name);
  Source source = toy();
  source.main = "abi.h";
  EXPECT_EQ(message_of<InternalError>(source, options), "source file to compile is not given: abi.h");
  source.name = "../toy";
  EXPECT_EQ(message_of<InternalError>(source, options), "model name is no identifier: ../toy");
  EXPECT_EQ(runs(), 0);
}

}  // namespace
}  // namespace kanec::compile::test
