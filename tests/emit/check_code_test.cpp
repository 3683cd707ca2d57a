// What is found when emitted code is read again. Oracle: what a C++ compiler refuses, or would take for something else.
// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/check_code.hpp"

#include <gmock/gmock.h>

#include "runtime/base/error.hpp"

namespace kanec::emit {
namespace {

std::string function(const std::string& body) {
  return "template <class T>\nvoid f(const Prepared<T>& c, T t, const T* x, T* out) noexcept {\n" + body + "}\n";
}

std::string found(const std::string& code) {
  try {
    check_code(code, {"Prepared"});
  } catch (const InternalError& error) {
    return error.what();
  }
  return "";
}

TEST(CodeReadAgain, passes_where_every_name_is_declared_once_and_before_its_use) {
  EXPECT_EQ(found(function("  using std::sin, std::cos;\n"
                           "  const T theta_1 = x[0], theta_2 = x[1];\n"
                           "  const T a = c.p.m_1 * sin(theta_1) - T(1e-05) * t, b = -a;  // a b c\n"
                           "  T cosines[2], sines[2];\n"
                           "  for (int i = 0; i < 2; ++i) out[i] = T(0);\n"
                           "  for (int i = 0; i < 2; ++i) {\n    const T twice = T(2) * a;\n    out[i] = twice;\n  }\n"
                           "  static constexpr int places[][2] = {\n    {0,1}, {1,0},\n  };\n"
                           "  for (const auto& place : places) out[place[1]] = b + cos(theta_2) + cosines[0] + sines[1];\n"
                           "  const auto& [K, L] = places[0];\n  out[K] = x[L];\n")),
            "");
}

TEST(CodeReadAgain, tells_a_second_definition) {
  EXPECT_THAT(found(function("  const T a = x[0];\n  const T a = x[1];\n")), testing::HasSubstr("a second definition of a (in f)"));
  EXPECT_THAT(found(function("  const T a = x[0], b = a, a = b;\n")), testing::HasSubstr("a second definition of a"));
  EXPECT_THAT(found(function("  const T t = x[0];\n")), testing::HasSubstr("a second definition of t"));
  EXPECT_THAT(found("void f(double ydot, double ydot) {}"), testing::HasSubstr("a second definition of ydot"));
  EXPECT_THAT(found(function("") + function("")), testing::HasSubstr("a second definition of f"));
}

TEST(CodeReadAgain, tells_a_use_before_the_definition) {
  EXPECT_THAT(found(function("  const T a = b;\n  const T b = x[0];\n")), testing::HasSubstr("use before the definition of b"));
  EXPECT_THAT(found(function("  const T a = a - x[0];\n")), testing::HasSubstr("use before the definition of a"));
  EXPECT_THAT(found(function("  for (int i = 0; i < 2; ++i) {\n    const T a = x[i];\n    out[i] = a;\n  }\n  out[0] = a;\n")),
              testing::HasSubstr("use before the definition of a"));
  EXPECT_THAT(found("struct F { enum : int { a, b, count }; };\nconst int n = F::c;\n"),
              testing::HasSubstr("use before the definition of F::c"));
}

std::string pieces(const std::string& first, const std::string& second) {
  return "namespace f_pieces {\ntemplate <class T>\nstruct Shared {\n  T a, b;\n};\n"
         "template <class T>\nvoid piece_1(const T* x, Shared<T>& shared) noexcept {\n" +
         first + "}\ntemplate <class T>\nvoid piece_2(T* out, Shared<T>& shared) noexcept {\n" + second +
         "}\n}  // namespace f_pieces\n"
         "template <class T>\nvoid f(const T* x, T* out) noexcept {\n  f_pieces::Shared<T> shared;\n"
         "  f_pieces::piece_1(x, shared);\n  f_pieces::piece_2(out, shared);\n}\n";
}

TEST(CodeReadAgain, follows_results_from_piece_to_piece) {
  const std::string makes = "  const T a = x[0];\n  shared.a = a;\n", takes = "  const T a = shared.a;\n  out[0] = a;\n";
  EXPECT_EQ(found(pieces(makes, takes)), "");
  EXPECT_THAT(found(pieces("", takes)), testing::HasSubstr("read before it is set: shared.a"));
  EXPECT_THAT(found(pieces(takes, "")), testing::HasSubstr("read before it is set: shared.a"));
  EXPECT_THAT(found(pieces(makes + "  shared.a = a;\n", takes)), testing::HasSubstr("set twice: shared.a"));
  EXPECT_THAT(found(pieces(makes, takes + "  const T a = shared.a;\n")), testing::HasSubstr("a second definition of a"));
  EXPECT_EQ(found(pieces(makes, takes) + "namespace g {\n" + pieces(makes, takes) + "}\n"), "");
}

// Whatever is missing, reading ends.
TEST(CodeReadAgain, tells_code_that_ends_too_early) {
  const std::string code = "struct F { enum : int { a, count }; };\ntemplate <class T>\nvoid f(const T* x, T* out) noexcept {\n"
                           "  for (int i = 0; i < 2; ++i) out[i] = T(0);\n  const T a[2] = {x[0], x[F::a]};\n  out[0] = a[1];\n}";
  EXPECT_EQ(found(code), "");
  for (std::size_t length = code.find("void f") + 6; length < code.size(); ++length)
    EXPECT_NE(found(code.substr(0, length)), "") << code.substr(0, length);
  EXPECT_NE(found("struct F { enum : int { a"), "");
}

TEST(CodeReadAgain, reads_no_comment_and_no_text) {
  EXPECT_EQ(found(function("  // a = b\n  /* c = d */\n  const char* const a = \"e = f\";\n")), "");
}

}  // namespace
}  // namespace kanec::emit
