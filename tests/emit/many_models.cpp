// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/emit/many_models.hpp"

#include <dlfcn.h>

#include <stdexcept>

#include "runtime/base/files.hpp"
#include "runtime/base/process.hpp"
#include "runtime/model/evaluate.hpp"
#include "tests/emit/driver.hpp"

namespace kanec::test {
namespace {

// The headers first, so that nothing of the library's is included within a namespace.
std::string translation_unit(const std::vector<std::string>& names) {
  std::string text =
      "#include <algorithm>\n#include <cmath>\n#include <cstdint>\n#include <cstring>\n#include <new>\n\n"
      "#include \"abi.h\"\n";
  for (const std::string& name : names) text += "#include \"" + name + ".hpp\"\n";
  for (const std::string& name : names)
    text += "\n#define kanec_model_entry entry_of_" + name + "\nnamespace models_" + name + " {\n#include \"" + name +
            "_abi.cpp\"\n}\n#undef kanec_model_entry\n";
  return text;
}

}  // namespace

ManyModels::~ManyModels() {
  if (handle_ != nullptr) ::dlclose(handle_);
}

void ManyModels::add(const Generated& generated) {
  write_file(folder_.path() / (generated.name + ".hpp"), generated.header);
  write_file(folder_.path() / (generated.name + "_abi.cpp"), generated.abi);
  names_.push_back(generated.name);
}

std::vector<std::string> ManyModels::command(const std::string& compiler, const std::vector<std::string>& more) const {
  const std::filesystem::path main = folder_.path() / "all.cpp";
  write_file(main, translation_unit(names_));
  std::vector<std::string> command = {compiler, "-I" KANEC_SOURCE_DIR "/runtime/abi", main.string()};
  for (const std::string& flag : strict_flags()) command.push_back(flag);
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

std::string ManyModels::complaints(const std::string& compiler) const {
  const ProcessResult result = run_process(command(compiler, {"-fsyntax-only"}));
  return result.status == 0 ? result.output : result.output + "exit status " + std::to_string(result.status);
}

void ManyModels::load(const std::string& compiler) {
  const std::string library = (folder_.path() / "all.so").string();
  const ProcessResult result =
      run_process(command(compiler, {"-O0", "-ffp-contract=off", "-shared", "-fPIC", "-o", library}));
  if (result.status != 0) throw std::runtime_error(result.output);
  handle_ = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr) throw std::runtime_error(::dlerror());
}

std::vector<double> ManyModels::result(const std::string& model, const std::string& function,
                                       const Sample& sample) const {
  const auto entry = reinterpret_cast<kanec_entry>(::dlsym(handle_, ("entry_of_" + model).c_str()));
  if (entry == nullptr) throw std::runtime_error("no model " + model);
  const kanec::State state{sample.t,          sample.state.x,    sample.state.y,
                           sample.state.ydot, sample.parameters, sample.inputs};
  return kanec::emitted(*entry(), sample.scene, function, state);
}

}  // namespace kanec::test
