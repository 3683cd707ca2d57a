// What code for size takes of memory. Oracle: the compiler's own objects, of each function alone.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "generator/read/read.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/process.hpp"
#include "tests/base/folder.hpp"
#include "tests/emit/many_models.hpp"

namespace kanec::test {
namespace {

using emit::Optimize;

// Bytes of code and constants of the one function of a C header, at -Os.
class Sizes {
 public:
  Sizes(std::string compiler, std::vector<std::string> flags)
      : compiler_(std::move(compiler)), flags_(std::move(flags)) {}

  // `size_tool` in Berkeley's format: text, which holds constants, then data.
  long of(const Generated& generated, const std::string& real, const std::string& size_tool) const {
    Folder folder;
    std::string header = generated.header;
    const std::string function = "void " + generated.name + "_" + generated.program.functions[0].name + "(";
    header.erase(header.find("static inline " + function), std::string("static inline ").size());
    const std::string file = (folder.path() / "model.c").string(), object = (folder.path() / "model.o").string();
    write_file(file, "#define KANEC_REAL " + real + "\n" + header);
    std::vector<std::string> command = {compiler_, "-std=c99", "-Os", "-c", file, "-o", object};
    command.insert(command.end(), flags_.begin(), flags_.end());
    const ProcessResult made = run_process(command);
    if (made.status != 0) throw std::runtime_error(made.output);
    std::istringstream table(run_process({size_tool, object}).output);
    std::string headings;
    std::getline(table, headings);
    long text = 0, data = 0;
    table >> text >> data;
    return text + data;
  }

 private:
  std::string compiler_;
  std::vector<std::string> flags_;
};

Generated in_c(const scene::Scene& scene, const std::string& function, Optimize optimize) {
  GenerateOptions options{{function}, {}, optimize};
  options.language = emit::Language::c;
  return generate(scene, options);
}

class ForSize : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Models, ForSize, testing::Values("arm_6", "quadruped", "cart_pole", "satellite"));

// On the host, and on a Cortex-M4 where its compiler is installed.
TEST_P(ForSize, no_function_is_larger_than_for_speed) {
  const scene::Scene scene = scene::read(std::string(KANEC_SOURCE_DIR "/models/") + GetParam() + "/scene.toml");
  const Sizes host("gcc", {});
  const Sizes cortex("arm-none-eabi-gcc", {"-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"});
  const bool has_cortex = find_program("arm-none-eabi-gcc").has_value();
  for (const char* function : {"kinematics", "accelerations", "residual", "mass_matrix", "energy", "poses"}) {
    const Generated fast = in_c(scene, function, Optimize::speed), small = in_c(scene, function, Optimize::size);
    for (const std::string real : {"double", "float"}) {
      EXPECT_LE(host.of(small, real, "size"), host.of(fast, real, "size")) << function << " " << real;
      if (!has_cortex) continue;
      EXPECT_LE(cortex.of(small, real, "arm-none-eabi-size"), cortex.of(fast, real, "arm-none-eabi-size"))
          << function << " on a Cortex-M4 in " << real;
    }
  }
}

}  // namespace
}  // namespace kanec::test
