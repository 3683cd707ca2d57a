// Emitted headers behind headers that define macros, and constants that are prepared at compile time. Oracle: the
// compilers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/read/read.hpp"
#include "generator/scene/spelling.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/process.hpp"
#include "tests/base/folder.hpp"
#include "tests/emit/driver.hpp"

namespace kanec::test {
namespace {

// As windows.h and what it includes define them, and complex.h.
constexpr const char* macros = R"(
#include <complex.h>
#define near
#define far
#define IN
#define OUT
#define small char
#define huge
#define hyper long long
#define interface struct
#define pascal __stdcall
#define cdecl __cdecl
#define DELETE (0x00010000L)
#define ERROR 0
#define CONST const
#define VOID void
#define OPTIONAL
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define rad1 0x0420
#define None 0L
#define Success 0
#undef I
#define I 1.0iF
)";

constexpr const char* scene_text = R"(
name = "small"
connection = [0, 1]
gravity = [0, 0, -9.81]
functions = ["kinematics", "accelerations", "residual", "energy", "power", "near_position"]
[parameters]
I = 0.5
near = 0.25
far = 2.0
interface = 0.125
rad1 = 0.75
[inputs]
IN = 1.0
huge = 2.0
complex = 0.5
[[body]]
name = "near"
joint = "revolute"
axis = "x"
mass = "far"
inertia = ["I", 0.1, 0.1]
r = [0, "near", 0]
effort = "max(min(IN, huge), -huge) + interface*complex"
[[body]]
name = "far"
joint = "revolute"
axis = "y"
mass = "rad1"
inertia = [0.1, 0.1, 0.1]
r = [0.1, 0.2, 0.3]
[[point]]
name = "near"
body = "far"
r = [0, 0.1, 0]
)";

std::string said(const std::vector<std::string>& command) {
  const ProcessResult result = run_process(command);
  return result.status == 0 ? result.output : result.output + "exit status " + std::to_string(result.status);
}

// Spelled with an underscore behind, what a scene calls like a macro is reached, in both languages.
TEST(Macros, of_other_headers_do_no_harm) {
  const scene::Scene scene = scene::parse(scene_text, "small.toml");
  GenerateOptions options;
  Folder folder;
  write_file(folder.path() / "small.hpp", generate(scene, options).header);
  options.language = emit::Language::c;
  write_file(folder.path() / "small.h", generate(scene, options).header);
  const std::string cpp = (folder.path() / "main.cpp").string(), c = (folder.path() / "main.c").string(),
                    program = (folder.path() / "main").string();
  const std::string call = "  accelerations(prepared, x, y, inputs, ydot);\n";
  write_file(cpp, std::string("#include <cstdio>\n") + macros + R"(#include "small.hpp"
namespace model = kanec::small_;
int main() {
  model::Parameters<double> p;
  p.I_ = 0.25, p.near_ += 0.5, p.far_ = 3, p.interface_ = 0.5, p.rad1_ = 0.5;
  model::Inputs<double> u;
  u.IN_ = 7, u.huge_ = 5, u.complex_ = 4;
  double x[model::nx] = {}, y[model::ny] = {}, ydot[model::ny];
  x[model::at::theta_near] = 0.5, x[model::at::theta_2] = 0.25;
  model::accelerations(model::prepare(p), x, y, u, ydot);
  std::printf("%a %a", ydot[0], ydot[1]);
}
)");
  write_file(c, std::string("#include <stdio.h>\n") + macros + R"(#include "small.h"
int main(void) {
  small_Parameters p = small_default_parameters();
  p.I_ = 0.25, p.near_ += 0.5, p.far_ = 3, p.interface_ = 0.5, p.rad1_ = 0.5;
  small_Inputs u = small_default_inputs();
  u.IN_ = 7, u.huge_ = 5, u.complex_ = 4;
  double x[small_nx] = {0}, y[small_ny] = {0}, ydot[small_ny];
  x[small_at_theta_near] = 0.5, x[small_at_theta_2] = 0.25;
  const small_Prepared prepared = small_prepare(&p);
  small_accelerations(&prepared, x, y, &u, ydot);
  printf("%a %a", ydot[0], ydot[1]);
  return 0;
}
)");
  std::vector<std::string> results;
  for (const auto& [compiler, standard, file] : {std::tuple("g++", "-std=gnu++17", cpp),
                                                 {"clang++", "-std=gnu++17", cpp},
                                                 {"gcc", "-std=gnu99", c},
                                                 {"clang", "-std=c99", c}}) {
    if (!find_program(compiler)) continue;
    EXPECT_EQ(said({compiler, standard, "-O0", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", file, "-o", program,
                    "-lm"}),
              "")
        << compiler;
    results.push_back(said({program}));
    EXPECT_EQ(results.back(), results.front()) << compiler;
  }
  EXPECT_THAT(results.front(), testing::HasSubstr("0x"));
}

TEST(Macros, are_named_in_the_header) {
  const std::string header = generate(scene::parse(scene_text, "small.toml")).header;
  EXPECT_THAT(header, testing::HasSubstr("near_ for near"));
  EXPECT_THAT(header, testing::HasSubstr("complex_ for complex"));
}

TEST(Macros, leave_no_other_name_their_spelling) {
  EXPECT_EQ(scene::spelled("near"), "near_");
  EXPECT_EQ(scene::spelled("nearer"), "nearer");
  EXPECT_TRUE(scene::is_spelling("near_"));
  EXPECT_FALSE(scene::is_spelling("nearer_"));
  std::string text = scene_text;
  text.replace(text.find("far = 2.0"), 9, "I_ = 2.00");
  try {
    scene::parse(text, "small.toml");
    ADD_FAILURE() << "not refused";
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("\"I_\", which is how emitted code spells \"I\""));
  }
}

// Where no library function is needed; so a global stands among the constants.
TEST(Prepared, is_a_constant_expression_where_it_calls_nothing) {
  const Generated generated = generate(scene::read(KANEC_SOURCE_DIR "/models/cart_pole/scene.toml"));
  Folder folder;
  write_file(folder.path() / "cart_pole.hpp", generated.header);
  const std::string file = (folder.path() / "main.cpp").string(), object = (folder.path() / "main.o").string();
  write_file(file, R"(#include "cart_pole.hpp"
namespace model = kanec::cart_pole;
constexpr auto prepared = model::prepare<double>({});
constexpr auto in_float = model::prepare(model::Parameters<float>{2.0f, 0.5f});
static_assert(prepared.m_all_1 == 1.0 + 0.1 && in_float.p.m_cart == 2.0f);
extern const model::Prepared<double> kept;
const model::Prepared<double> kept = model::prepare<double>({});
)");
  for (const char* compiler : {"g++", "clang++"}) {
    if (!find_program(compiler)) continue;
    EXPECT_EQ(said({compiler, "-std=c++17", "-O0", "-Wall", "-Wextra", "-Werror", "-c", file, "-o", object}), "")
        << compiler;
    const std::string sections = said({"size", "-A", object});
    EXPECT_THAT(sections, testing::HasSubstr(".rodata"));
    EXPECT_THAT(sections, testing::Not(testing::HasSubstr(".init_array")));
  }
}

}  // namespace
}  // namespace kanec::test
