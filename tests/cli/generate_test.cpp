// Oracle: the compiler, and that a scene dumped and read again gives the same code.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstring>

#include "runtime/compile/compiler.hpp"
#include "tests/base/small_disk.hpp"
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

using Names = std::vector<std::string>;

class Generate : public Program {
 protected:
  std::string compiler() const { return compile::find_compiler("").path.string(); }
};

TEST_F(Generate, header_goes_where_it_is_wanted) {
  const std::string scene = model("free_body");
  EXPECT_EQ(kanec({"generate", scene}).status, 0);
  EXPECT_EQ(names(work()), Names{"free_body.hpp"});
  const std::string header = read_file(work() / "free_body.hpp");
  EXPECT_THAT(header, HasSubstr("namespace kanec::free_body"));
  EXPECT_EQ(kanec({"generate", scene, "-o", "other.hpp"}).status, 0);
  EXPECT_EQ(read_file(work() / "other.hpp"), header);
  fs::create_directory(work() / "folder");
  EXPECT_EQ(kanec({"generate", scene, "-o", "folder", "--abi"}).status, 0);
  EXPECT_EQ(names(work() / "folder"), (Names{"abi.h", "free_body.hpp", "free_body_abi.cpp"}));
  EXPECT_EQ(read_file(work() / "folder" / "free_body.hpp"), header);
}

TEST_F(Generate, new_folder_is_made_where_its_name_ends_so) {
  EXPECT_EQ(kanec({"generate", model("free_body"), "-o", "new/", "--abi"}).status, 0);
  EXPECT_EQ(names(work() / "new"), (Names{"abi.h", "free_body.hpp", "free_body_abi.cpp"}));
  refuses({"generate", model("free_body"), "-o", "far/away/"}, "far/away/: No such file or directory", {"new"});
}

TEST_F(Generate, standard_output_takes_the_header_and_nothing_else) {
  const Answer answer = kanec({"generate", model("free_body"), "-o", "-"});
  EXPECT_EQ(answer.status, 0);
  EXPECT_EQ(kanec({"generate", model("free_body")}).status, 0);
  EXPECT_EQ(answer.out, read_file(work() / "free_body.hpp"));
  EXPECT_THAT(answer.err, HasSubstr("accelerations"));  // the report
  EXPECT_EQ(kanec({"generate", model("free_body"), "-o", "-"}, "", ">redirected.hpp").status, 0);
  EXPECT_EQ(read_file(work() / "redirected.hpp"), answer.out);
  const Names there = {"free_body.hpp", "redirected.hpp"};
  refuses({"generate", model("free_body"), "-o", "-", "--json"}, "--json: found it beside --output -", there);
  refuses({"generate", model("free_body"), "-o", "-", "--abi"}, "allowed with --abi: a folder", there);
}

TEST_F(Generate, taylor_series_stand_beside_the_header_and_use_its_names) {
  EXPECT_EQ(kanec({"generate", model("t_handle"), "-o", "new/", "--taylor"}).status, 0);
  EXPECT_EQ(names(work() / "new"), (Names{"t_handle.hpp", "t_handle_taylor.hpp"}));
  EXPECT_THAT(read_file(work() / "new" / "t_handle.hpp"), HasSubstr("void kinematics_and_accelerations("));
  write_file(work() / "new" / "main.cpp", R"(
#include "t_handle_taylor.hpp"
int main() {
  namespace model = kanec::t_handle;
  static model::Taylor<double, 20> series;
  double z[21 * model::Taylor<double, 20>::size] = {0, 0, 0, 1};  // x, y; then coefficients 1 ... 20
  z[model::nx] = 2;  // about a principal axis: omega stays, eps_1 = sin t
  series.coefficients(model::prepare(model::Parameters<double>{}), 0.0, 20, z);
  const double* third = z + 3 * model::Taylor<double, 20>::size;
  return third[0] + 1.0 / 6 < 1e-15 && third[0] + 1.0 / 6 > -1e-15 ? 0 : 1;
}
)");
  const std::string program = (work() / "new" / "a.out").string();
  EXPECT_EQ(run_process({compiler(), "-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow",
                         "-Werror", (work() / "new" / "main.cpp").string(), "-o", program})
                .status,
            0);
  EXPECT_EQ(run_process({program}).status, 0);
  refuses({"generate", model("t_handle"), "-o", "a.hpp", "--taylor"}, "allowed with --taylor: a folder", {"new"});
}

TEST_F(Generate, language_c_gives_a_header_of_its_own_and_refuses_what_c_has_not) {
  const std::string scene = model("cart_pole");
  EXPECT_EQ(kanec({"generate", scene, "--language", "c"}).status, 0);
  EXPECT_EQ(names(work()), Names{"cart_pole.h"});
  EXPECT_EQ(kanec({"generate", scene, "--language", "c", "-o", "-"}).out, read_file(work() / "cart_pole.h"));
  const Names there = {"cart_pole.h"};
  refuses({"generate", scene, "--language", "c", "--abi", "-o", "new/"}, "language c: found it beside abi", there);
  refuses({"generate", scene, "--language", "c", "--taylor", "-o", "new/"}, "language c: found it beside taylor",
          there);
  refuses({"generate", scene, "--language", "c", "--dump", "program"}, "--language c: found it beside --dump program",
          there);
  refuses({"generate", scene, "--language", "ada"}, "--language", there);
}

TEST_F(Generate, code_is_made_for_what_is_asked) {
  const std::string scene = model("bench_cr32");
  EXPECT_EQ(kanec({"generate", scene, "--functions", "residual", "--optimize", "size", "-o", "size.hpp"}).status, 0);
  const std::string header = read_file(work() / "size.hpp");
  EXPECT_THAT(header, HasSubstr("; for size; functions residual"));
  EXPECT_THAT(header,
              HasSubstr("// functions written as loops over bodies; bytes in double, estimated:\n//   residual: "));
  EXPECT_THAT(header, HasSubstr("namespace residual_sections {"));
  EXPECT_EQ(kanec({"generate", scene, "--functions", "residual", "-o", "speed.hpp"}).status, 0);
  EXPECT_GT(fs::file_size(work() / "speed.hpp"), 1.5 * static_cast<double>(header.size()));
  refuses({"generate", scene, "--optimize", "weight"}, "--optimize", {"size.hpp", "speed.hpp"});
}

TEST_F(Generate, report_counts_every_function) {
  const json report = json_of({"generate", model("bench_s6f"), "--json"});
  EXPECT_EQ(report.at("nx"), 42);
  EXPECT_EQ(report.at("files").at(0).at("bytes"), fs::file_size(work() / "bench_s6f.hpp"));
  EXPECT_EQ(report.at("functions").size(), 11u);
  for (const json& function : report.at("functions")) {
    EXPECT_EQ(
        function.at("operations").get<int>(),
        function.at("adds").get<int>() + function.at("multiplies").get<int>() + function.at("divides").get<int>());
    EXPECT_GT(function.at("operations"), 0);
  }
  const Answer text = kanec({"generate", model("bench_s6f")});
  EXPECT_THAT(text.out, HasSubstr("6 bodies, 42 coordinates, 36 speeds"));
  EXPECT_THAT(text.out, HasSubstr(report.at("hash").get<std::string>()));
  EXPECT_THAT(text.out, HasSubstr("wrote bench_s6f.hpp"));
}

TEST_F(Generate, a_function_that_the_scene_lacks_is_refused_with_the_reason_and_its_line) {
  refuses({"generate", model("free_body"), "--functions", "accelerations_u"},
          "accelerations_u, which a scene without inputs does not have");
  refuses({"generate", model("free_body"), "--functions", "driving_loads"},
          "driving_loads, which a scene without locked or prescribed coordinates does not have");
  refuses({"generate", model("free_body"), "--functions", "energy,energy"}, "\"energy\" twice");
  write("scene.toml",
        "name = 'a'\nconnection = [0]\nfunctions = [\n  'energy',\n  'poses+enerty']\n[[body]]\nmass = 1\n"
        "inertia = [1, 1, 1]\n");
  refuses({"generate", "scene.toml"}, "scene.toml:5: functions[2]: found \"enerty\"; allowed: ", {"scene.toml"});
}

TEST_F(Generate, chosen_functions_alone_are_emitted) {
  const json report = json_of({"generate", model("free_body"), "--functions", "energy,poses", "--json"});
  EXPECT_EQ(report.at("functions").size(), 2u);
  refuses({"generate", model("free_body"), "--functions", "energy,acceleration"}, "(did you mean accelerations?)",
          {"free_body.hpp"});
  refuses({"generate", model("free_body"), "--functions", "power"}, "a scene without applied loads does not have",
          {"free_body.hpp"});
}

TEST_F(Generate, example_of_the_help_compiles_and_runs) {
  const std::string help = kanec({"generate", "--help"}).out;
  const std::size_t begin = help.find("<<'EOF'\n") + 8, end = help.find("  EOF\n");
  ASSERT_LT(begin, end);
  write("fall.cpp", help.substr(begin, end - begin));
  EXPECT_EQ(kanec({"generate", model("six_body"), "-o", "."}).status, 0);
  const fs::path program = work() / "fall";
  const ProcessResult built =
      run_process({compiler(), "-std=c++17", "-O0", (work() / "fall.cpp").string(), "-o", program.string()});
  ASSERT_EQ(built.status, 0) << built.output;
  const ProcessResult ran = run_process({program.string()});
  EXPECT_EQ(ran.status, 0);
  // body 1 at rest with its axes inertial; the same number by the generic path
  json state = json_of({"eval", model("six_body"), "accelerations", "--template"});
  for (auto& [name, value] : state.at("x").items()) value = name[0] == 'e' ? json({0, 0, 0, 1}) : json({0, 0, 0});
  for (auto& [name, value] : state.at("y").items()) value = {0, 0, 0};
  const json result = json_of(
      {"eval", model("six_body"), "accelerations", "--input", "-", "--path", "generic", "--json"}, state.dump());
  const double expected = result.at("result").at("ydot").at("sddot_hub").at(2);
  EXPECT_NEAR(std::stod(ran.output), expected, 1e-13 * std::fabs(expected));  // some 100 roundings
}

TEST_F(Generate, dumped_scene_gives_the_same_code) {
  for (const std::vector<std::string>& scene :
       {std::vector<std::string>{model("six_body")}, {"--connection", "0,1,0"}, {model("random_12")}}) {
    SCOPED_TRACE(scene.back());
    const auto with = [&scene](std::vector<std::string> arguments) {
      arguments.insert(arguments.end(), scene.begin(), scene.end());
      return arguments;
    };
    EXPECT_EQ(kanec(with({"generate", "--dump", "scene", "-o", "scene.toml"})).status, 0);
    EXPECT_EQ(json_of(with({"generate", "--json"})).at("hash"), json_of({"generate", ".", "--json"}).at("hash"));
  }
}

TEST_F(Generate, every_stage_can_be_looked_at) {
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"scene", "connection = [0]"}, {"equations", "accelerations: "},         {"program", "out[0] = "},
      {"ledger", "square root"},     {"header", "namespace kanec::free_body"}, {"abi", "kanec_model_entry"}};
  for (const auto& [stage, text] : expected) {
    const Answer answer = kanec({"generate", model("free_body"), "--dump", stage});
    EXPECT_EQ(answer.status, 0);
    EXPECT_THAT(answer.out, HasSubstr(text));
  }
  EXPECT_THAT(names(work()), IsEmpty());
  refuses({"generate", model("free_body"), "--dump", "parse"}, "--dump");
}

TEST_F(Generate, unwritable_output_leaves_nothing) {
  const std::string scene = model("free_body");
  refuses({"generate", scene, "-o", "nowhere/free_body.hpp"}, "nowhere/free_body.hpp: No such file or directory");
  refuses({"generate", scene, "-o", "/dev/full"}, "/dev/full: No space left on device");
  refuses({"generate", scene, "-o", "a.hpp", "--abi"}, "allowed with --abi: a folder");
  fs::create_directories(work() / "abi.h");
  refuses({"generate", scene, "--abi"}, "abi.h: Is a directory", {"abi.h"});
}

TEST_F(Generate, files_on_a_full_disk_are_as_they_were) {
  const fs::path folder = work() / "folder";
  fs::create_directory(folder);
  const kanec::test::SmallDisk disk(folder, "24k");
  if (disk.error() != 0) GTEST_SKIP() << "a small disk cannot be mounted here: " << std::strerror(disk.error());
  write_file(folder / "free_body.hpp", "old");
  const Answer answer = kanec({"generate", model("free_body"), "-o", "folder", "--abi", "--taylor"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_THAT(answer.err, HasSubstr(": No space left on device"));
  EXPECT_EQ(names(folder), Names{"free_body.hpp"});
  EXPECT_EQ(read_file(folder / "free_body.hpp"), "old");
}

TEST_F(Generate, links_are_written_through) {
  fs::create_directory(work() / "far");
  fs::create_symlink("far/header", work() / "free_body.hpp");
  EXPECT_EQ(kanec({"generate", model("free_body")}).status, 0);
  EXPECT_TRUE(fs::is_symlink(work() / "free_body.hpp"));
  EXPECT_THAT(read_file(work() / "far" / "header"), HasSubstr("namespace kanec::free_body"));
}

}  // namespace
}  // namespace kanec::cli::test
