// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/model.hpp"

#include <fmt/format.h>

#include <map>
#include <sstream>

#include "generator/choice/candidates.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/lanes/files.hpp"
#include "runtime/model/origin.hpp"

namespace kanec {
namespace {

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> list;
  for (std::string word; stream >> word;) list.push_back(word);
  return list;
}

// Before anything is derived.
compile::Source source_of(const scene::Scene& scene, const GenerateOptions& options) {
  compile::Source source;
  source.name = scene.name;
  source.nx = n_coordinates(scene);
  source.ny = n_speeds(scene);
  source.main = scene.name + "_abi.cpp";
  source.origin = origin_of(scene, options);
  return source;
}

void fill(compile::Source& source, const Generated& generated) {
  source.hash = generated.hash;
  source.files.push_back({generated.name + ".hpp", generated.header});
  if (source.is_batch) {
    source.files.push_back({source.main, generated.batch});
    for (const auto& file : lane_files()) source.files.push_back(file);
    return;
  }
  source.files.push_back({source.main, generated.abi});
  if (generated.taylor.empty()) return;
  source.files.push_back({generated.name + "_taylor.hpp", generated.taylor});
  source.flags = {"-DKANEC_TAYLOR"};
}

CompiledModel build(const scene::Scene& scene, GenerateOptions options, const BuildOptions& build_options,
                    const std::string& what, compile::Source source) {
  const auto poll = build_options.watch ? build_options.watch() : std::function<void()>([] {});
  const auto tell = [&](const std::string& text) {
    if (build_options.tell) build_options.tell(text);
  };
  options.tell = [&](const std::string& note) { tell("note: " + note); };
  std::optional<Generated> generated;
  source.make = [&](compile::Source& unfinished) {
    generated = generate(scene, options);
    poll();
    fill(unfinished, *generated);
  };
  compile::Options compiling = compile_options(build_options);
  compiling.poll = poll;
  compile::Model library = [&] {
    try {
      return compile::build(source, compiling);
    } catch (const BuildError&) {
      poll();  // a compiler that the same Ctrl-C ended
      throw;
    }
  }();
  poll();
  for (const std::string& note : library.notes()) tell("note: " + note);
  tell(library.from_cache() ? what + ": from the cache"
                            : fmt::format("{}: compiled in {:.2g} s", what, library.compile_seconds()));
  options.tell = {};
  return {std::move(library), [scene, options] { return generate(scene, options); }, std::move(generated),
          options.functions.empty() ? scene.functions : options.functions};
}

}  // namespace

CompiledModel::CompiledModel(compile::Model compiled, std::function<Generated()> generate,
                             std::optional<Generated> generated, std::vector<std::string> asked_for)
    : library(std::move(compiled)),
      requests(std::move(asked_for)),
      generate_(std::move(generate)),
      generated_(std::move(generated)) {}

const Generated& CompiledModel::generated() const {
  if (!generated_) generated_ = generate_();
  return *generated_;
}

const std::map<std::string, emit::Optimize>& optimize_goals() {
  using emit::Optimize;
  static const std::map<std::string, Optimize> all = {
      {"speed", Optimize::speed}, {"size", Optimize::size}, {"line", Optimize::line}, {"loops", Optimize::loops}};
  return all;
}

std::string build_text(const BuildOptions& build_options) {
  std::string text;
  if (build_options.algorithm) text += " --algorithm " + name(*build_options.algorithm);
  for (const auto& [goal, optimize] : optimize_goals())
    if (optimize == build_options.optimize && optimize != BuildOptions().optimize) text += " --optimize " + goal;
  if (!build_options.compiler.empty()) text += " --compiler " + fit::shell(build_options.compiler);
  if (build_options.flags_given) text += " --flags " + fit::shell(build_options.flags);
  return text;
}

compile::Options compile_options(const BuildOptions& build_options) {
  return {.compiler = build_options.compiler,
          .flags = words(build_options.flags),
          .flags_given = build_options.flags_given,
          .cache = build_options.cache,
          .use_cache = !build_options.no_cache,
          .tell = [tell = build_options.tell](const std::string& text) {
            if (tell) tell("note: " + text);
          }};
}

CompiledModel build(const scene::Scene& scene, const std::vector<std::string>& functions,
                    const BuildOptions& build_options, bool with_taylor) {
  GenerateOptions options{functions, build_options.algorithm, build_options.optimize};
  options.with_taylor = with_taylor;
  return build(scene, options, build_options, scene.name, source_of(scene, options));
}

CompiledModel build_batch(const scene::Scene& scene, const std::vector<std::string>& functions,
                          const BuildOptions& build_options, const LaneArguments& lanes) {
  // lanes take instructions in less often a state: straight lines pay up to here, but take seconds to compile
  constexpr int longest_line = 20'000;
  const GenerateOptions options{functions, build_options.algorithm, build_options.optimize, longest_line};
  compile::Source source = source_of(scene, options);
  source.main = scene.name + "_batch.cpp";
  source.flags = lane_flags(lanes.scalar, lanes.lanes);
  source.is_batch = true;
  return build(scene, options, build_options, scene.name + " in lanes", std::move(source));
}

}  // namespace kanec
