// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/c_file.hpp"

#include <vector>

#include "generator/emit/angles.hpp"
#include "generator/emit/calls.hpp"
#include "generator/emit/language.hpp"
#include "runtime/base/error.hpp"
#include "runtime/lanes/files.hpp"

namespace kanec::emit {
namespace {

constexpr const char* scalar = R"(// the scalar, and whether it is double (1) or float (2)
#if defined(KANEC_REAL)
#define kanec_real KANEC_REAL
#else
#define kanec_real double
#endif
#define KANEC_JOINED_(a, b) a##b
#define KANEC_JOINED(a, b) KANEC_JOINED_(a, b)
#define KANEC_KIND_double 1
#define KANEC_KIND_float 2
#define KANEC_KIND_long 0 *
#define KANEC_KIND KANEC_JOINED(KANEC_KIND_, kanec_real)
#if KANEC_KIND != 1 && KANEC_KIND != 2
#error "KANEC_REAL is neither float nor double"
#endif
)";

constexpr const char* apart_text = R"(
// by itself, however many call it
#if defined(__GNUC__)
#define KANEC_APART static __attribute__((noinline, unused))
#else
#define KANEC_APART static
#endif
)";

// Functions of <math.h> that the program calls, by their names in C++.
std::vector<std::string> library_functions(const program::Program& program) {
  std::vector<std::string> list;
  for (const std::string& function : functions_called(program))
    if (function != "min" && function != "max") list.push_back(function);
  return list;
}

std::string defines(const std::vector<std::string>& functions, const std::string& suffix) {
  std::string text;
  for (const std::string& function : functions)
    text += "#define kanec_" + function + " " + (function == "abs" ? "fabs" : function) + suffix + "\n";
  return text;
}

std::string library(const std::vector<std::string>& functions) {
  if (functions.empty()) return "";
  return "#if KANEC_KIND == 1\n" + defines(functions, "") + "#else\n" + defines(functions, "f") + "#endif\n";
}

// The statements of cos_sin_of() in runtime/lanes/cos_sin.hpp, which are C as well.
std::string arithmetic() {
  const std::string file = cos_sin_text(), open = " noexcept {\n";
  const std::size_t function = file.find("void cos_sin_of(");
  const std::size_t begin = file.find(open, function), end = file.find("\n}\n", function);
  if (function == std::string::npos || begin > end) throw InternalError("emit: no arithmetic of cosines and sines");
  return file.substr(begin + open.size(), end + 1 - begin - open.size());
}

// As cos_sin() of C++, bit for bit.
std::string cos_sin(const Syntax& syntax) {
  const std::string vector = syntax.global("cos_sin_vector"), bits = syntax.global("cos_sin_bits");
  const std::string parameters = "(\n    const kanec_real* a, int n, kanec_real* c, kanec_real* s)";
  return R"(
#if KANEC_KIND == 1 && defined(__GNUC__) && (defined(__x86_64__) || defined(__aarch64__)) && \
    !(defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(KANEC_LIBM_COS_SIN))
#define KANEC_VECTORS
// Lanes of a vector of doubles with |a| <= 4096. Errors below 0.95 ulps.
// a = n pi/2 + r + e with |r| <= pi/4 (Cody and Waite 1980), then minimax polynomials of r^2.
typedef double )" + vector + R"( __attribute__((vector_size(32)));
typedef __UINT64_TYPE__ )" + bits + R"( __attribute__((vector_size(32)));
static inline __attribute__((always_inline))
void )" + syntax.global("cos_sin_of") + "(\n    const " + vector + "* angles,\n    " + vector + "* cosines,\n    " + vector +
         R"(* sines) {
  typedef )" + vector + R"( Vector;
  typedef )" + bits + R"( Bits;
  const Vector a = *angles;
  Vector c, s;
)" + arithmetic() + R"(  *cosines = c;
  *sines = s;
}
#endif

// c = cos(a), s = sin(a) for n angles. In double four at once; large ones and what is no number by the library.
static inline
void )" + syntax.call("cos_sin") + parameters + R"( {
#if defined(KANEC_VECTORS)
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += fabs(a[i]);
  if (sum <= 4096) {
    for (int i = 0; i < n; i += 4) {
      const int first = n < 4 ? 0 : i < n - 4 ? i : n - 4, last = n - 1 - first;
      const double* const from = a + first;
      const int second = last < 1 ? last : 1, third = last < 2 ? last : 2, fourth = last < 3 ? last : 3;
      const )" + vector + R"( group = {
          from[0], from[second], from[third], from[fourth]};
      )" + vector + R"( cosines, sines;
      )" + syntax.global("cos_sin_of") + R"((&group, &cosines, &sines);
      for (int j = 0; j < 4 && j < n; ++j) {
        c[first + j] = cosines[j];
        s[first + j] = sines[j];
      }
    }
    return;
  }
#endif
  for (int i = 0; i < n; ++i) {
    c[i] = kanec_cos(a[i]);
    s[i] = kanec_sin(a[i]);
  }
}
)";
}

}  // namespace

std::string c_beginning(const Model& model, const program::Program& program, bool apart) {
  const Syntax syntax(model);
  const std::string guard = "KANEC_C_" + model.scene->name, included = includes(program, syntax);
  return "#ifndef " + guard + "\n#define " + guard + "\n\n" + included + (included.empty() ? "" : "\n") + scalar +
         library(library_functions(program)) + (apart ? apart_text : "") +
         (takes_turns(model, program) && model.optimize != Optimize::size ? cos_sin(syntax) : "") + "\n";
}

std::string c_end(const program::Program& program, bool apart) {
  std::string text = "\n";
  for (const std::string& function : library_functions(program)) text += "#undef kanec_" + function + "\n";
  for (const char* name : {"kanec_real", "KANEC_JOINED_", "KANEC_JOINED", "KANEC_KIND_double", "KANEC_KIND_float",
                           "KANEC_KIND_long", "KANEC_KIND", "KANEC_VECTORS"})
    text += "#undef " + std::string(name) + "\n";
  return text + (apart ? "#undef KANEC_APART\n" : "") + "#endif\n";
}

}  // namespace kanec::emit
