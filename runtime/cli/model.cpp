// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/model.hpp"

#include <fmt/format.h>

#include <map>
#include <sstream>

#include "generator/candidates.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/cli/interrupt.hpp"
#include "runtime/cli/output.hpp"
#include "runtime/lanes/files.hpp"

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
  compile::Source source{generated.name,
                         generated.hash,
                         n_coordinates(scene),
                         n_speeds(scene),
                         {{generated.name + ".hpp", generated.header}, {main, generated.abi}},
                         main};
  if (generated.taylor.empty()) return source;
  source.files.push_back({generated.name + "_taylor.hpp", generated.taylor});
  source.flags = {"-DKANEC_TAYLOR"};
  return source;
}

compile::Source batch_source_of(const Generated& generated, const scene::Scene& scene, const LaneArguments& lanes) {
  compile::Source source = source_of(generated, scene);
  source.main = generated.name + "_batch.cpp";
  source.files = lane_files();
  source.files.push_back({generated.name + ".hpp", generated.header});
  source.files.push_back({source.main, generated.batch});
  source.flags = lane_flags(lanes.scalar, lanes.lanes);
  source.is_batch = true;
  return source;
}

const std::map<std::string, emit::Optimize>& goals() {
  using emit::Optimize;
  static const std::map<std::string, Optimize> all = {
      {"speed", Optimize::speed}, {"size", Optimize::size}, {"line", Optimize::line}, {"loops", Optimize::loops}};
  return all;
}

// `source` makes what is to be compiled of what was generated.
template <class SourceOf>
CompiledModel build(const scene::Scene& scene, GenerateOptions options, const BuildArguments& arguments,
                    const std::string& what, SourceOf source) {
  const Interrupts interrupts;
  options.tell = [](const std::string& note) { remark("note: " + note); };
  Generated generated = generate(scene, options);
  interrupts.poll();
  compile::Options compiling = compile_options(arguments);
  compiling.poll = [&interrupts] { interrupts.poll(); };
  compile::Model library = [&] {
    try {
      return compile::build(source(generated), compiling);
    } catch (const BuildError&) {
      interrupts.poll();  // a compiler that the same Ctrl-C ended
      throw;
    }
  }();
  interrupts.poll();
  for (const std::string& note : library.notes()) remark("note: " + note);
  remark(library.from_cache() ? what + ": from the cache"
                              : fmt::format("{}: compiled in {:.2g} s", what, library.compile_seconds()));
  return {std::move(generated), std::move(library), options.functions.empty() ? scene.functions : options.functions};
}

}  // namespace

void add_build(CLI::App& command, BuildArguments& arguments) {
  const std::string group = "Compiling";
  add_algorithm(command, arguments.algorithm);
  add_optimize(command, arguments.optimize);
  command
      .add_option("--compiler", arguments.compiler,
                  "C++ compiler; else $KANEC_CXX, $CXX, clang++, c++ or g++ (lanes: g++ first)")
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

std::string build_text(const BuildArguments& arguments) {
  std::string text;
  if (arguments.algorithm) text += " --algorithm " + name(*arguments.algorithm);
  for (const auto& [goal, optimize] : goals())
    if (optimize == arguments.optimize && optimize != BuildArguments().optimize) text += " --optimize " + goal;
  if (!arguments.compiler.empty()) text += " --compiler " + fit::shell(arguments.compiler);
  if (arguments.flags_given) text += " --flags " + fit::shell(arguments.flags);
  return text;
}

compile::Options compile_options(const BuildArguments& arguments) {
  return {.compiler = arguments.compiler,
          .flags = words(arguments.flags),
          .flags_given = arguments.flags_given,
          .cache = arguments.cache,
          .use_cache = !arguments.no_cache,
          .tell = [](const std::string& text) { remark("note: " + text); }};
}

CompiledModel build(const scene::Scene& scene, const std::vector<std::string>& functions,
                    const BuildArguments& arguments, bool with_taylor) {
  GenerateOptions options{functions, arguments.algorithm, arguments.optimize};
  options.with_taylor = with_taylor;
  return build(scene, options, arguments, scene.name,
               [&](const Generated& generated) { return source_of(generated, scene); });
}

CompiledModel build_batch(const scene::Scene& scene, const std::vector<std::string>& functions,
                          const BuildArguments& arguments, const LaneArguments& lanes) {
  // lanes take instructions in less often a state: straight lines pay up to here, but take seconds to compile
  constexpr int longest_line = 20'000;
  return build(scene, {functions, arguments.algorithm, arguments.optimize, longest_line}, arguments,
               scene.name + " in lanes",
               [&](const Generated& generated) { return batch_source_of(generated, scene, lanes); });
}

void add_algorithm(CLI::App& command, std::optional<symbolic::Algorithm>& algorithm) {
  using symbolic::Algorithm;
  const auto set = [&algorithm](const std::string& text) {
    algorithm.reset();
    for (const Algorithm known : {Algorithm::composite, Algorithm::articulated})
      if (text == name(known)) algorithm = known;
  };
  command
      .add_option_function<std::string>("--algorithm", set,
                                        "of accelerations: A by composite bodies and L D L^T, or joint by joint (auto: "
                                        "whichever takes fewer operations)")
      ->check(CLI::IsMember(std::vector<std::string>{"auto", name(Algorithm::composite), name(Algorithm::articulated)}))
      ->option_text("auto|composite|articulated");
}

void add_optimize(CLI::App& command, emit::Optimize& optimize) {
  const auto set = [&optimize](const std::string& text) { optimize = goals().at(text); };
  command
      .add_option_function<std::string>(
          "--optimize", set,
          "loops over bodies: where they are no slower (speed, the default), where they take less code (size), never "
          "(line), always (loops)")
      ->check(CLI::IsMember({"speed", "size", "line", "loops"}))
      ->option_text("speed|size|line|loops");
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
