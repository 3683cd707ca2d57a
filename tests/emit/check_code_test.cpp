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
  EXPECT_EQ(
      found(function("  using std::sin, std::cos;\n"
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
  EXPECT_THAT(found(function("  const T a = x[0];\n  const T a = x[1];\n")),
              testing::HasSubstr("a second definition of a (in f)"));
  EXPECT_THAT(found(function("  const T a = x[0], b = a, a = b;\n")), testing::HasSubstr("a second definition of a"));
  EXPECT_THAT(found(function("  const T t = x[0];\n")), testing::HasSubstr("a second definition of t"));
  EXPECT_THAT(found("void f(double ydot, double ydot) {}"), testing::HasSubstr("a second definition of ydot"));
  EXPECT_THAT(found(function("") + function("")), testing::HasSubstr("a second definition of f"));
}

TEST(CodeReadAgain, tells_a_use_before_the_definition) {
  EXPECT_THAT(found(function("  const T a = b;\n  const T b = x[0];\n")),
              testing::HasSubstr("use before the definition of b"));
  EXPECT_THAT(found(function("  const T a = a - x[0];\n")), testing::HasSubstr("use before the definition of a"));
  EXPECT_THAT(
      found(function("  for (int i = 0; i < 2; ++i) {\n    const T a = x[i];\n    out[i] = a;\n  }\n  out[0] = a;\n")),
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
  const std::string makes = "  const T a = x[0];\n  shared.a = a;\n",
                    takes = "  const T a = shared.a;\n  out[0] = a;\n";
  EXPECT_EQ(found(pieces(makes, takes)), "");
  EXPECT_THAT(found(pieces("", takes)), testing::HasSubstr("read before it is set: shared.a"));
  EXPECT_THAT(found(pieces(takes, "")), testing::HasSubstr("read before it is set: shared.a"));
  EXPECT_THAT(found(pieces(makes + "  shared.a = a;\n", takes)), testing::HasSubstr("set twice: shared.a"));
  EXPECT_THAT(found(pieces(makes, takes + "  const T a = shared.a;\n")),
              testing::HasSubstr("a second definition of a"));
  EXPECT_EQ(found(pieces(makes, takes) + "namespace g {\n" + pieces(makes, takes) + "}\n"), "");
}

// Whatever is missing, reading ends.
TEST(CodeReadAgain, tells_code_that_ends_too_early) {
  const std::string code =
      "struct F { enum : int { a, count }; };\ntemplate <class T>\nvoid f(const T* x, T* out) noexcept {\n"
      "  for (int i = 0; i < 2; ++i) out[i] = T(0);\n  const T a[2] = {x[0], x[F::a]};\n  out[0] = a[1];\n}";
  EXPECT_EQ(found(code), "");
  for (std::size_t length = code.find("void f") + 6; length < code.size(); ++length)
    EXPECT_NE(found(code.substr(0, length)), "") << code.substr(0, length);
  EXPECT_NE(found("struct F { enum : int { a"), "");
}

TEST(CodeReadAgain, reads_no_comment_and_no_text) {
  EXPECT_EQ(found(function("  // a = b\n  /* c = d */\n  const char* const a = \"e = f\";\n")), "");
}

std::string found_in_c(const std::string& code) {
  try {
    check_code(code, {"kanec_real", "kanec_sin"});
  } catch (const InternalError& error) {
    return error.what();
  }
  return "";
}

const std::string c_types =
    "enum { m_nx = 2, m_ny = 2 };\nstatic const int m_rows[] = {0, 1};\n"
    "typedef struct m_Prepared {\n  kanec_real a, b;\n} m_Prepared;\n"
    "static inline m_Prepared m_defaults(void) {\n  m_Prepared list;\n  list.a = (kanec_real)1;\n  return list;\n}\n";

std::string c_function(const std::string& body) {
  return c_types + "static inline void m_f(const m_Prepared* c, const kanec_real* x, kanec_real* out) {\n  (void)c;\n" +
         body + "}\n";
}

TEST(CReadAgain, passes_where_every_name_is_declared_once_and_before_its_use) {
  EXPECT_EQ(found_in_c(c_function("  const kanec_real a = c->a * kanec_sin(x[0]) - (kanec_real)1e-05, b = -a;\n"
                                  "  static const unsigned char places[][2] = {\n    {0,1}, {1,0},\n  };\n"
                                  "  for (int i = 0; i < m_nx; ++i) out[places[i][0]] = b + x[m_rows[i]];\n")),
            "");
}

TEST(CReadAgain, tells_second_definitions_and_uses_before_the_definition) {
  using testing::HasSubstr;
  EXPECT_THAT(found_in_c(c_function("  const kanec_real a = x[0];\n  const kanec_real a = x[1];\n")),
              HasSubstr("a second definition of a (in m_f)"));
  EXPECT_THAT(found_in_c(c_function("  out[0] = (kanec_real)2 * a;\n")),
              HasSubstr("use before the definition of a (in m_f)"));
  EXPECT_THAT(found_in_c(c_function("  out[m_nz] = x[0];\n")), HasSubstr("use before the definition of m_nz"));
  EXPECT_THAT(found_in_c(c_function("  (void)d;\n")), HasSubstr("use before the definition of d"));
  EXPECT_THAT(found_in_c(c_function("") + "enum { m_nx = 3 };\n"), HasSubstr("a second definition of m_nx"));
  EXPECT_THAT(found_in_c(c_types + "static inline void m_f(kanec_real* out) {\n  *out = 1;"),
              HasSubstr("a brace is open"));
}

TEST(CReadAgain, follows_results_from_piece_to_piece) {
  const auto pieces = [](const std::string& first, const std::string& second) {
    return "typedef struct m_f_pieces_Shared {\n  kanec_real a;\n} m_f_pieces_Shared;\n"
           "KANEC_APART void m_f_pieces_piece_1(const kanec_real* x, m_f_pieces_Shared* shared) {\n" +
           first + "}\nKANEC_APART void m_f_pieces_piece_2(kanec_real* out, m_f_pieces_Shared* shared) {\n" + second +
           "}\nstatic inline void m_f(const kanec_real* x, kanec_real* out) {\n  m_f_pieces_Shared shared;\n"
           "  m_f_pieces_piece_1(x, &shared);\n  m_f_pieces_piece_2(out, &shared);\n}\n";
  };
  const std::string makes = "  const kanec_real a = x[0];\n  shared->a = a;\n";
  const std::string takes = "  const kanec_real a = shared->a;\n  out[0] = a;\n";
  EXPECT_EQ(found_in_c(pieces(makes, takes)), "");
  EXPECT_THAT(found_in_c(pieces("", takes)), testing::HasSubstr("read before it is set: shared.a"));
  EXPECT_THAT(found_in_c(pieces(makes + "  shared->a = a;\n", takes)), testing::HasSubstr("set twice: shared.a"));
}

}  // namespace
}  // namespace kanec::emit
