// kanec derive: the tables of the derivation.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <optional>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/cli/arguments.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/scene_argument.hpp"
#include "runtime/model/equations.hpp"
#include "runtime/model/reductions.hpp"
#include "runtime/terminal/output.hpp"
#include "runtime/text/json.hpp"

namespace kanec::cli {
namespace {

constexpr auto derive_footer = R"(Example: the source's six bodies, on paper
  kanec derive --connection 0,1,2,2,1,5 --format latex -o six.tex && pdflatex six.tex

Prints the bodies, the connection array, u(K), the state vectors, the kinematical equations, rotations, positions,
velocities, partial velocities and their time derivatives, block by block and one matrix a body, A, f and the loads;
R1^T is R_1 transposed, a~ the skew matrix of a.

  kanec derive models/arm_6 --reduction --functions accelerations

prints instead what was left out of the scene before its equations, and the operations that each reduction saves.)";

struct DeriveArguments {
  SceneArgument scene;
  std::string format = "text";
  bool json = false;
  bool reduction = false;
  std::vector<std::string> functions;
  std::string output;
};

std::string reduction_document(const scene::Scene& scene, const std::vector<std::string>& functions, bool json) {
  const std::vector<Reduction> list = reductions(scene, functions);
  return json ? json_text(reductions_json(scene.name, list)) : reductions_text(scene.name, list);
}

int derive(const DeriveArguments& options) {
  const scene::Scene scene = load(options.scene);
  const std::string format = options.json ? "json" : options.format;
  if (!options.functions.empty() && !options.reduction) throw InputError("--functions goes with --reduction");
  if (options.reduction && format == "latex")
    throw InputError("--reduction: found --format latex; allowed: text, json");
  std::optional<AtomicFile> file;
  if (!options.output.empty()) file.emplace(options.output);
  const std::string text = options.reduction ? reduction_document(scene, options.functions, format == "json")
                                             : equations_text(scene, format);
  if (file) {
    file->write(text);
    file->commit();
  } else {
    print(text);
  }
  return 0;
}

}  // namespace

void add_derive(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, "derive", "Kane's equations of a scene, symbolically, block by block", derive_footer, &derive);
  add_scene(*command, options->scene);
  command->add_option("--format", options->format, "how to print them (text)")
      ->option_text("text|latex|json")
      ->check(CLI::IsMember({"text", "latex", "json"}));
  command->add_flag("--json", options->json, "the same as --format json");
  command->add_flag("--reduction", options->reduction, "what was left out of the scene, and what that saves");
  add_functions(*command, options->functions);
  command->add_option("-o,--output", options->output, "into this file; - is standard output")->option_text("FILE");
}

}  // namespace kanec::cli
