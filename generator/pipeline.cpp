// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline.hpp"

#include <utility>

#include "generator/choice/candidates.hpp"
#include "generator/choice/reach.hpp"
#include "generator/choice/regular.hpp"
#include "generator/emit/header.hpp"
#include "generator/emit/taylor.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/base/hash.hpp"

namespace kanec {
namespace {

std::string options_text(const scene::Scene& scene, const GenerateOptions& options) {
  const std::vector<std::string>& named = options.functions.empty() ? scene.functions : options.functions;
  constexpr const char* goals[] = {"", "for size; ", "as straight lines; ", "as loops; "};
  std::string text = goals[static_cast<std::size_t>(options.optimize)];
  text += named.empty() ? "the usual functions" : "functions";
  for (const std::string& function : named) text += " " + function;
  return options.algorithm ? text + "; algorithm " + name(*options.algorithm) : text;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

std::string without(std::string text, const std::string& what) {
  replace_all(text, what, "");
  return text;
}

void tell(const GenerateOptions& options, const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    if (options.tell) options.tell(note);
}

}  // namespace

Generated generate(const scene::Scene& scene, const GenerateOptions& options) {
  const bool is_c = options.language == emit::Language::c;
  if (is_c && options.with_taylor)
    throw InputError("a Taylor series in C: found language c; allowed: C++, since the series is a class template");
  const std::scoped_lock turn(derivation_turn());
  check_regular(scene);
  const bool are_named = !options.functions.empty() || !scene.functions.empty();
  const Reach reach = within_reach(scene, requested_functions(scene, options.functions), are_named);
  tell(options, reach.notes);
  program::Program program = cheapest_program(scene, reach.names, options.algorithm);
  tell(options, notes_on_size(program, reach));
  // the hash is of the text that it stands in, but for where the scene was found; written first with marks in their
  // places
  const std::string mark = "@model-hash-mark";
  const std::string source = scene.source.empty() ? "" : "@model-source-mark";
  const emit::Model model{&scene,
                          version(),
                          mark,
                          options_text(scene, options),
                          source,
                          options.optimize,
                          options.longest_line,
                          options.lengths,
                          options.language};
  std::string header = emit::emit_header(model, program);
  std::string abi = is_c ? "" : emit::emit_abi(model, program);
  std::string batch = is_c ? "" : emit::emit_batch(model, program);
  std::string taylor = options.with_taylor ? emit::emit_taylor(model, program) : "";
  const std::string hash = fingerprint((source.empty() ? header : without(header, " of " + source)) + abi);
  replace_all(header, mark, hash);
  if (!source.empty()) replace_all(header, source, fit::comment(scene.source));
  for (std::string* text : {&abi, &batch, &taylor}) replace_all(*text, mark, hash);
  return {std::move(program), scene.name, hash, std::move(header), std::move(abi), std::move(batch), std::move(taylor)};
}

std::recursive_mutex& derivation_turn() {
  static std::recursive_mutex mutex;
  return mutex;
}

std::string version() { return KANEC_VERSION; }

}  // namespace kanec
