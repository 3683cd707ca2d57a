// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/model.hpp"

#include <fmt/format.h>

#include <sstream>

#include "runtime/base/error.hpp"
#include "runtime/cli/interrupt.hpp"
#include "runtime/cli/output.hpp"

namespace kanec::cli {
namespace {

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> list;
  for (std::string word; stream >> word;) list.push_back(word);
  return list;
}

compile::Source source_of(const Generated& generated, const scene::Scene& scene) {
  const std::string main = generated.name + "_abi.cpp";
  return {generated.name,
          generated.hash,
          n_coordinates(scene),
          n_speeds(scene),
          {{generated.name + ".hpp", generated.header}, {main, generated.abi}},
          main};
}

}  // namespace

void add_build(CLI::App& command, BuildArguments& arguments) {
  const std::string group = "Compiling";
  command.add_option("--compiler", arguments.compiler, "C++ compiler; else $KANEC_CXX, $CXX, clang++, c++ or g++")
      ->option_text("PROGRAM")
      ->group(group);
  command
      .add_option("--flags", arguments.flags,
                  "in place of the default optimisation flags (bench shows them) or $KANEC_CXXFLAGS")
      ->option_text("\"...\"")
      ->each([&arguments](const std::string&) { arguments.flags_given = true; })
      ->group(group);
  command.add_option("--cache", arguments.cache, "folder of compiled models; else $KANEC_CACHE or ~/.cache/kanec")
      ->option_text("DIR")
      ->group(group);
  command.add_flag("--no-cache", arguments.no_cache, "compile anew, keep nothing")->group(group);
}

compile::Options compile_options(const BuildArguments& arguments) {
  return {arguments.compiler, words(arguments.flags), arguments.flags_given, arguments.cache, !arguments.no_cache};
}

CompiledModel build(const scene::Scene& scene, const std::vector<std::string>& functions,
                    const BuildArguments& arguments) {
  const Interrupts interrupts;
  Generated generated = generate(scene, {functions});
  interrupts.poll();
  compile::Model library = [&] {
    try {
      return compile::build(source_of(generated, scene), compile_options(arguments));
    } catch (const BuildError&) {
      interrupts.poll();  // a compiler that the same Ctrl-C ended
      throw;
    }
  }();
  interrupts.poll();
  for (const std::string& note : library.notes()) remark("note: " + note);
  remark(library.from_cache() ? scene.name + ": from the cache"
                              : fmt::format("{}: compiled in {:.2g} s", scene.name, library.compile_seconds()));
  return {std::move(generated), std::move(library), functions.empty() ? scene.functions : functions};
}

void add_functions(CLI::App& command, std::vector<std::string>& functions) {
  command
      .add_option("--functions", functions,
                  "these alone; a+b: both in one call (those of the scene, or the usual ones)")
      ->delimiter(',')
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false)
      ->option_text("a,b+c,...");
}

}  // namespace kanec::cli
