// What is installed, as a project of somebody else uses it. Slow where a project is built: each of them is small.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "runtime/base/files.hpp"
#include "runtime/base/process.hpp"
#include "tests/base/folder.hpp"

namespace kanec::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Package : public testing::Test {
 protected:
  // Installed once for all tests.
  static void SetUpTestSuite() {
    folder_ = new Folder;
    const ProcessResult installed =
        run_process({"cmake", "--install", KANEC_BINARY_DIR, "--prefix", prefix().string()});
    ASSERT_EQ(installed.status, 0) << installed.output;
  }
  static void TearDownTestSuite() { delete folder_; }

  static fs::path prefix() { return folder_->path() / "prefix"; }
  static fs::path folder_file(const std::string& name) { return folder_->path() / name; }
  static fs::path source(const std::string& project) { return fs::path(KANEC_SOURCE_DIR) / "tests/package" / project; }
  static fs::path binary(const std::string& project) { return folder_->path() / ("build-" + project); }

  static std::string run(const std::vector<std::string>& command, const Environment& variables = {}) {
    const ProcessResult result = run_process(command, {}, variables);
    EXPECT_EQ(result.status, 0) << testing::PrintToString(command) << "\n" << result.output;
    return result.output;
  }

  static void build(const std::string& project, const fs::path& from) {
    run({"cmake", "-G", "Ninja", "-S", from.string(), "-B", binary(project).string(),
         "-DCMAKE_PREFIX_PATH=" + prefix().string()});
    run({"cmake", "--build", binary(project).string()});
  }
  static void build(const std::string& project) { build(project, source(project)); }

  static std::string scene(const std::string& name) { return (fs::path(KANEC_SOURCE_DIR) / "models" / name).string(); }
  static Environment cache() { return {{"KANEC_CACHE", (folder_->path() / "cache").string()}}; }

 private:
  static inline Folder* folder_ = nullptr;
};

TEST_F(Package, has_tool_headers_libraries_and_documents) {
  for (const char* file :
       {"bin/kanec", "include/kanec/kanec.hpp", "include/kanec/abi.h", "include/kanec/rk4_step.hpp",
        "share/man/man1/kanec.1", "share/bash-completion/completions/kanec", "share/kanec/models/six_body/scene.toml"})
    EXPECT_TRUE(fs::exists(prefix() / file)) << file;
  for (const auto& entry : fs::recursive_directory_iterator(prefix() / "include")) {
    if (!entry.is_regular_file()) continue;
    EXPECT_THAT(read_file(entry.path()), testing::Not(HasSubstr("#include \"runtime/"))) << entry.path();
  }
  EXPECT_THAT(run({(prefix() / "bin/kanec").string(), "--version"}), HasSubstr("kanec "));
}

TEST_F(Package, is_found_by_cmake) {
  build("cpp");
  EXPECT_EQ(run({(binary("cpp") / "user").string(), scene("pendulum")}, cache()),
            "pendulum: 51 rows, 1 accelerations\n");
  const ProcessResult refused = run_process({(binary("cpp") / "user").string(), "/no/such/scene.toml"}, {}, cache());
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.output, HasSubstr("/no/such/scene.toml"));
}

TEST_F(Package, runtime_plays_a_compiled_model_without_the_generator) {
  build("runtime");
  const fs::path library = folder_file("model.so");
  run({(prefix() / "bin/kanec").string(), "generate", scene("pendulum"), "--functions",
       "kinematics+accelerations,energy", "--abi", "-o", folder_file("emitted/").string()});
  run({"c++", "-std=c++17", "-O1", "-fPIC", "-shared", (folder_file("emitted") / "pendulum_abi.cpp").string(), "-o",
       library.string()});
  EXPECT_EQ(run({(binary("runtime") / "player").string(), library.string()}), "pendulum: 51 rows\n");
  const std::string linked = run({"ldd", (binary("runtime") / "player").string()});
  EXPECT_THAT(linked, HasSubstr("libkanec_runtime"));
  EXPECT_THAT(linked, testing::Not(HasSubstr("ginac")));
}

TEST_F(Package, pkg_config_knows_the_libraries) {
  const Environment path = {{"PKG_CONFIG_PATH", [] {
                               for (const auto& entry : fs::recursive_directory_iterator(prefix()))
                                 if (entry.path().filename() == "kanec.pc") return entry.path().parent_path().string();
                               return std::string();
                             }()}};
  std::istringstream flags(run({"pkg-config", "--cflags", "--libs", "kanec"}, path));
  std::vector<std::string> command = {"c++", "-std=c++20", (source("cpp") / "main.cpp").string(), "-o",
                                      folder_file("user").string()};
  for (std::string flag; flags >> flag;) command.push_back(flag);
  command.push_back("-Wl,-rpath," + path[0].second + "/..");
  run(command);
  EXPECT_THAT(run({folder_file("user").string(), scene("pendulum")}, cache()), HasSubstr("pendulum: 51 rows"));
  EXPECT_THAT(run({"pkg-config", "--modversion", "kanec-runtime"}, path), HasSubstr("."));
}

// Oracle: g sin(0.5) over a length of 1 with the rod's own inertia, by hand: m g r / (m r^2 + I) = 2 9.81 / 2.5.
TEST_F(Package, kanec_generate_emits_again_where_the_scene_changed) {
  const fs::path project = folder_file("project");
  fs::copy(source("generate"), project);
  build("generate", project);
  EXPECT_EQ(run({(binary("generate") / "in_cpp").string()}), "-3.762532\n");
  EXPECT_EQ(run({(binary("generate") / "in_c").string()}), "-3.762532\n");
  EXPECT_THAT(run({"cmake", "--build", binary("generate").string()}), HasSubstr("no work to do"));
  std::string text = read_file(project / "scene.toml");
  text.replace(text.find("-9.81"), 5, "-19.62");
  write_file(project / "scene.toml", text);
  run({"cmake", "--build", binary("generate").string()});
  EXPECT_EQ(run({(binary("generate") / "in_cpp").string()}), "-7.525063\n");
  EXPECT_EQ(run({(binary("generate") / "in_c").string()}), "-7.525063\n");
  write_file(project / "scene.toml", "name = \"swing\"\n");
  const ProcessResult broken = run_process({"cmake", "--build", binary("generate").string()});
  EXPECT_NE(broken.status, 0);
  EXPECT_THAT(broken.output, HasSubstr("connection"));
}

// Configured, not built, which is the whole of kanec.
TEST_F(Package, is_a_part_of_another_project) {
  run({"cmake", "-G", "Ninja", "-S", source("part").string(), "-B", binary("part").string(),
       "-DKANEC_SOURCE=" KANEC_SOURCE_DIR});
}

}  // namespace
}  // namespace kanec::test
