// Which compiler is taken, and what is said when it does not work. Oracles: scripts in place of compilers.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/compiler.hpp"

#include "runtime/base/error.hpp"
#include "runtime/base/process.hpp"
#include "tests/compile/bench.hpp"

namespace kanec::compile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class FindCompiler : public testing::Test {
 protected:
  // A program that gives `version` for its version.
  fs::path put(const std::string& name, const std::string& version) const {
    write_script(folder_.path() / name, "#!/bin/sh\necho " + version + " \"$@\"\n");
    return folder_.path() / name;
  }
  std::string complaint(const std::string& wish) const {
    try {
      find_compiler(wish);
    } catch (const BuildError& error) {
      return error.what();
    }
    return "nothing was thrown";
  }
  fs::path folder() const { return folder_.path(); }

 private:
  Folder folder_;
  Variable path_{"PATH", folder_.path().string()};
  Variable kanec_cxx_{"KANEC_CXX", std::nullopt};
  Variable cxx_{"CXX", std::nullopt};
};

TEST_F(FindCompiler, wish_comes_first_then_the_variables_then_the_usual_names) {
  for (const char* name : {"wished", "own", "general", "clang++", "c++", "g++"}) put(name, name);
  const Variable own("KANEC_CXX", "own"), general("CXX", "general");
  EXPECT_EQ(find_compiler("wished").path, folder() / "wished");
  EXPECT_EQ(find_compiler("").path, folder() / "own");
  const Variable no_own("KANEC_CXX", "");
  EXPECT_EQ(find_compiler("").path, folder() / "general");
  const Variable no_general("CXX", std::nullopt);
  for (const char* name : {"clang++", "c++", "g++"}) {
    EXPECT_EQ(find_compiler("").path, folder() / name);
    fs::remove(folder() / name);
  }
}

TEST_F(FindCompiler, lanes_have_the_usual_names_the_other_way_round) {
  for (const char* name : {"clang++", "c++", "g++"}) put(name, name);
  for (const char* name : {"g++", "c++", "clang++"}) {
    EXPECT_EQ(find_compiler("", Code::lanes).path, folder() / name);
    fs::remove(folder() / name);
  }
}

TEST_F(FindCompiler, version_is_what_it_answers) {
  put("c++", "compiler 3.1");
  EXPECT_EQ(find_compiler("").version, "compiler 3.1 --version\n");
}

TEST_F(FindCompiler, arguments_after_blanks_belong_to_it) {
  put("ccache", "cached");
  const Compiler compiler = find_compiler("ccache  g++ -m64");
  EXPECT_EQ(compiler.path, folder() / "ccache");
  EXPECT_THAT(compiler.arguments, ElementsAre("g++", "-m64"));
  EXPECT_EQ(compiler.version, "cached g++ -m64 --version\n");
  EXPECT_THAT(command_line(compiler, {"-O3", "-g"}, "/x/a.cpp", "/x/a.so"),
              ElementsAre((folder() / "ccache").string(), "g++", "-m64", "-std=c++17", "-fPIC", "-shared",
                          "-fvisibility=hidden", "-O3", "-g", "/x/a.cpp", "-o", "/x/a.so"));
}

TEST_F(FindCompiler, blank_in_its_path_is_no_separator) {
  const fs::path path = put("my compiler", "1");
  EXPECT_EQ(find_compiler(path.string()).path, path);
  EXPECT_THAT(find_compiler(path.string()).arguments, IsEmpty());
}

TEST_F(FindCompiler, all_that_were_tried_are_named) {
  EXPECT_EQ(complaint(""),
            "no C++ compiler found; tried clang++, c++, g++; install one (Debian: apt install g++) or name one in "
            "KANEC_CXX");
  const Variable general("CXX", "icpx -m64");
  EXPECT_THAT(complaint(""), StartsWith("no C++ compiler found; tried icpx -m64 ($CXX), clang++, c++, g++; install"));
}

TEST_F(FindCompiler, one_asked_for_by_name_is_not_replaced) {
  put("c++", "1");
  EXPECT_EQ(complaint("g++-99"), "no C++ compiler found; tried g++-99");
  const Variable own("KANEC_CXX", "/opt/none/g++");
  EXPECT_EQ(complaint(""), "no C++ compiler found; tried /opt/none/g++ ($KANEC_CXX)");
}

TEST_F(FindCompiler, broken_one_is_shown_with_what_it_says) {
  write_script(folder() / "c++", "#!/bin/sh\necho licence expired >&2\nexit 7\n");
  EXPECT_EQ(complaint(""), "the C++ compiler does not tell its version: status 7\n  command: " +
                               (folder() / "c++").string() + " --version\nlicence expired\n");
  write_script(folder() / "c++", "no program\n");
  EXPECT_EQ(complaint(""), "the C++ compiler cannot be started: " + (folder() / "c++").string() +
                               ": Exec format error\n  command: " + (folder() / "c++").string() + " --version");
}

TEST(DefaultFlags, are_those_of_the_environment_or_ours) {
  const Variable none("KANEC_CXXFLAGS", std::nullopt);
  EXPECT_THAT(default_flags(), ElementsAre("-O2", "-march=native", "-fno-math-errno", "-fno-tree-slp-vectorize"));
  const Variable some("KANEC_CXXFLAGS", " -O3  -g ");
  EXPECT_THAT(default_flags(), ElementsAre("-O3", "-g"));
  const Variable empty("KANEC_CXXFLAGS", "");
  EXPECT_THAT(default_flags(), IsEmpty());
}

class FailingCompiler : public Bench {
 protected:
  BuildError failure(const Source& source) const {
    try {
      build(source, options);
    } catch (const BuildError& error) {
      return error;
    }
    return {"nothing was thrown", "", ""};
  }
};

TEST_F(FailingCompiler, its_output_and_command_are_shown) {
  const BuildError error = failure(toy_with("parameters[0]", "parameters[0] + undeclared_name"));
  EXPECT_THAT(error.what(),
              StartsWith("the C++ compiler ended with status 1\n  command: '" + compiler() + "' -std=c++17"));
  EXPECT_THAT(error.what(), HasSubstr("undeclared_name"));
  EXPECT_THAT(error.output(), AllOf(HasSubstr("toy_abi.cpp:4:"), HasSubstr("error:"), HasSubstr("undeclared_name")));
  EXPECT_THAT(error.command(), AllOf(HasSubstr(" -O0 "), HasSubstr("toy_abi.cpp -o ")));
  EXPECT_THAT(entries(), IsEmpty());
}

TEST_F(FailingCompiler, its_failure_is_not_kept) {
  write_compiler("test -e '" + (root() / "repaired").string() + "' || exit 1");
  EXPECT_THAT(failure(toy()).what(), StartsWith("the C++ compiler ended with status 1"));
  write_file(root() / "repaired", "");
  EXPECT_EQ(evaluate(build(toy(), options)), -12.0);
}

TEST_F(FailingCompiler, its_death_is_told) {
  write_compiler("kill -SEGV $$");
  EXPECT_THAT(failure(toy()).what(), StartsWith("the C++ compiler ended with status 139\n"));
}

TEST_F(FailingCompiler, that_makes_nothing_is_told) {
  write_compiler("echo nothing to do; exit 0");
  EXPECT_THAT(failure(toy()).what(), StartsWith("the C++ compiler made no library\n"));
  EXPECT_EQ(failure(toy()).output(), "nothing to do\n");
}

TEST_F(FailingCompiler, its_temporary_files_go_with_the_workplace) {
  write_compiler("echo \"$TMPDIR\" > '" + (root() / "where").string() + "'; echo x > \"$TMPDIR/left.s\"; exit 1");
  failure(toy());
  EXPECT_THAT(read_file(root() / "where"), StartsWith((cache() / "tmp" / "toy-").string()));
  EXPECT_THAT(names(cache() / "tmp"), IsEmpty());
}

TEST_F(FailingCompiler, odd_names_of_the_workplace_are_no_obstacle) {
  write_compiler("");
  options.cache = root() / "a 'b' \"c\" $d;e:f\n*";
  for (const char* name : {"g++", "clang++"}) {
    if (!find_program(name)) continue;
    options.compiler = name;
    EXPECT_EQ(evaluate(build(toy(), options)), -12.0) << name;
  }
  EXPECT_THAT(names(options.cache / "tmp"), IsEmpty());
}

TEST_F(FailingCompiler, no_shell_sees_its_arguments) {
  options.flags = {"-O0", "-DTOY_TEXT=\"$(touch " + (root() / "made_by_a_shell").string() + ")\""};
  const Source source =
      toy_with("namespace {", "const char text[] = TOY_TEXT;\nstatic_assert(sizeof text > 10);\nnamespace {");
  EXPECT_EQ(evaluate(build(source, options)), -12.0);
  EXPECT_FALSE(fs::exists(root() / "made_by_a_shell"));
}

}  // namespace
}  // namespace kanec::compile::test
