// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/python/latex.hpp"

#include <string_view>

namespace kanec::python {
namespace {

// Their titles begin so.
constexpr std::string_view sections[] = {"Equations of motion", "Blocks of A", "f, with"};

bool is_wanted(std::string_view title) {
  for (const std::string_view wanted : sections)
    if (title.starts_with(wanted)) return true;
  return false;
}

// What stands in the braces that open at `at`; `at` moves behind them.
std::string_view in_braces(std::string_view text, std::size_t& at) {
  const std::size_t begin = at + 1;
  int depth = 0;
  for (; at < text.size(); ++at) {
    if (text[at] == '\\')
      ++at;
    else if (text[at] == '{')
      ++depth;
    else if (text[at] == '}' && --depth == 0)
      return text.substr(begin, at++ - begin);
  }
  return text.substr(begin);
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// Without the document's own breaks; underscores of names outside of text, where renderers know them.
std::string plain(std::string_view formula) {
  std::string text(formula);
  for (const std::string_view breaks : {"\\brkfac ", "\\brkin ", "\\brk "}) replace_all(text, breaks, "");
  for (std::size_t at = text.find("\\text{"); at != text.npos; at = text.find("\\text{", at + 1)) {
    std::size_t end = at + 5;
    std::string inside(in_braces(text, end));
    const std::size_t size = inside.size();
    replace_all(inside, "\\_", "}\\_\\text{");
    text.replace(at + 6, size, inside);
    at += inside.size();
  }
  return text;
}

}  // namespace

std::string display_of(const std::string& document, int most_rows) {
  static constexpr std::string_view section = "\\subsection*", row = "\\row{";
  const std::string_view text = document;
  std::string rows;
  int n = 0;
  bool wanted = false;
  for (std::size_t at = text.find("\\begin{document}"); (at = text.find('\\', at)) < text.size();) {
    if (text.substr(at).starts_with(section)) {
      at += section.size();
      wanted = is_wanted(in_braces(text, at));
    } else if (wanted && text.substr(at).starts_with(row)) {
      at += row.size() - 1;
      const std::string left = plain(in_braces(text, at)), right = plain(in_braces(text, at));
      if (++n <= most_rows) rows += left + " &= " + right + " \\\\\n";
    } else {
      ++at;
    }
  }
  if (n > most_rows) rows += "&\\;\\;\\vdots\n";
  return "$$\\begin{aligned}\n" + rows + "\\end{aligned}$$";
}

}  // namespace kanec::python
