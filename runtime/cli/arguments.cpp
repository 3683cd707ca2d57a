// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/arguments.hpp"

#include <cstdint>
#include <memory>

#include "generator/choice/candidates.hpp"
#include "runtime/terminal/interrupt.hpp"
#include "runtime/terminal/output.hpp"

namespace kanec::cli {

void add_build(CLI::App& command, BuildOptions& options) {
  const std::string group = "Compiling";
  options.tell = [](const std::string& note) { remark(note); };
  options.watch = [] {
    auto interrupts = std::make_shared<Interrupts>();
    return [interrupts] { interrupts->poll(); };
  };
  add_algorithm(command, options.algorithm);
  add_optimize(command, options.optimize);
  command
      .add_option("--compiler", options.compiler,
                  "C++ compiler; else $KANEC_CXX, $CXX, clang++, c++ or g++ (lanes: g++ first)")
      ->option_text("PROGRAM")
      ->group(group);
  command
      .add_option("--flags", options.flags,
                  "in place of the default optimisation flags (bench shows them) or $KANEC_CXXFLAGS")
      ->option_text("\"...\"")
      ->each([&options](const std::string&) { options.flags_given = true; })
      ->group(group);
  command.add_option("--cache", options.cache, "folder of compiled models; else $KANEC_CACHE or ~/.cache/kanec")
      ->option_text("DIR")
      ->group(group);
  command.add_flag("--no-cache", options.no_cache, "compile anew, keep nothing")->group(group);
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
  const auto set = [&optimize](const std::string& text) { optimize = optimize_goals().at(text); };
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

void add_settings(CLI::App& command, std::vector<std::string>& settings) {
  command.add_option("--set", settings, "another value for a parameter or an input; may be given many times")
      ->option_text("NAME=VALUE")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_ensemble(CLI::App& command, EnsembleArguments& arguments) {
  const std::string group = "Ensemble";
  const auto whole = [&](const std::string& name, auto& value, const std::string& what, std::int64_t least) {
    command.add_option(name, value, what)
        ->option_text("N")
        ->group(group)
        ->check(CLI::Range(least, std::int64_t{10'000'000}));
  };
  command
      .add_option("--ensemble", arguments.from,
                  "a run a line of the file, whose columns are named as coordinates, speeds, parameters, inputs; or as "
                  "the scene's [ensemble] draws them")
      ->option_text("FILE.csv|scene")
      ->group(group);
  whole("--count", arguments.count, "scenarios to draw (the scene's)", 1);
  whole("--seed", arguments.seed, "of the drawing (the scene's)", 0);
  whole("--threads", arguments.threads, "results do not depend on it (one a processor)", 1);
  whole("--keep-every", arguments.keep_every, "every N-th row of each run into --csv, not its end alone", 1);
  command.add_option("--drawn", arguments.drawn, "what was drawn, as --ensemble takes it")
      ->option_text("FILE.csv")
      ->group(group);
}

}  // namespace kanec::cli
