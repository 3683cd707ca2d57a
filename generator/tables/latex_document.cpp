// A page of plain paragraphs, one an equation, so that TeX itself breaks long ones into lines where breaks are allowed.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cctype>
#include <string_view>

#include "generator/tables/formula.hpp"
#include "generator/tables/grids.hpp"
#include "generator/tables/tables.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/base/text.hpp"

namespace kanec::emit {
namespace {

// \row: left sides end where the widest of the table does, further lines begin a little behind that.
constexpr auto preamble = R"(\documentclass[a4paper]{article}
\usepackage{amsmath}
\usepackage{array}
\usepackage{longtable}
\usepackage{multicol}
\usepackage[margin=20mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\lineskiplimit}{2pt}
\setlength{\lineskip}{2pt}
\newlength{\lefts}
\newcommand{\brk}{\penalty0 }
\newcommand{\brkin}{\penalty400 }
\newcommand{\brkfac}{\penalty800 }
\newenvironment{rows}[1]{\settowidth{\lefts}{$#1$}%
  \ifdim\lefts>0.4\linewidth\setlength{\lefts}{0.4\linewidth}\fi
  \setlength{\parskip}{2pt plus 1pt minus 1pt}\setlength{\rightskip}{0pt plus 6em}%
  \relpenalty=10000 \binoppenalty=10000 \tolerance=9999 \hbadness=10000 \emergencystretch=2em
  \clubpenalty=0 \widowpenalty=0 \interlinepenalty=50 }{\par}
\newcommand{\row}[2]{\par\hangindent=\dimexpr\lefts+2em\relax\hangafter=1
  \leavevmode\setbox0=\hbox{$#1$}%
  \ifdim\wd0<\lefts\hbox to\lefts{\hfil\box0}\else\box0\fi$\displaystyle{}=#2$}
\setlength{\LTleft}{0pt}
\setlength{\multicolsep}{0pt}
\raggedcolumns
\setlength{\tabcolsep}{4pt}
\begin{document}
)";

// How many letters and signs stand in a line, about: commands count one, braces and what raises or lowers none.
std::size_t about_as_wide_as(const std::string& formula) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    if (formula[i] == '\\')
      while (i + 1 < formula.size() && std::isalpha(static_cast<unsigned char>(formula[i + 1]))) ++i;
    width += std::string_view("{}_^ ").find(formula[i]) == std::string_view::npos;
  }
  return width;
}

// Into how many columns, so that nearly all of the rows are a line each.
int columns_for(const Table& table) {
  constexpr std::size_t line = 95, gap = 6;
  std::vector<std::size_t> widths;
  for (const auto& [left, right] : table.rows) widths.push_back(about_as_wide_as(left) + about_as_wide_as(right) + gap);
  std::sort(widths.begin(), widths.end());
  const std::size_t usual = widths[widths.size() * 9 / 10];
  return widths.size() < 4 || usual * 2 > line ? 1 : usual * 3 > line ? 2 : 3;
}

std::string latex_of(const Table& table) {
  const auto wider = [](const Row& a, const Row& b) { return about_as_wide_as(a.first) < about_as_wide_as(b.first); };
  const auto widest = std::max_element(table.rows.begin(), table.rows.end(), wider);
  const int columns = columns_for(table);
  std::string text = "\\subsection*{" + table.title + "}\n";
  if (columns > 1) text += "\\begin{multicols}{" + std::to_string(columns) + "}\n";
  text += "\\begin{rows}{" + widest->first + "}\n";
  for (const auto& [left, right] : table.rows) text += "\\row{" + left + "}{" + latex_breaks(right) + "}\n";
  return text + "\\end{rows}\n" + (columns > 1 ? "\\end{multicols}\n" : "");
}

std::string latex_of(const Grid& grid) {
  if (grid.lines.empty()) return "";
  std::string form, heads;
  for (const Column& column : grid.columns) {
    form += ">{\\raggedright\\arraybackslash}p{" + shortest(column.share) + "\\linewidth}";
    heads += (heads.empty() ? "" : " & ") + column.head;
  }
  std::string text = "\\subsection*{" + grid.title + "}\n" + (grid.note.empty() ? "" : grid.note + "\n") +
                     "{\\small\\relpenalty=10000 \\binoppenalty=10000 \\hbadness=10000\n\\begin{longtable}{@{}" + form +
                     "@{}}\n" + heads + " \\\\ \\hline\\noalign{\\vspace{2pt}}\\endhead\n";
  for (const std::vector<std::string>& line : without_repetition(grid)) {
    for (std::size_t i = 0; i < line.size(); ++i) text += (i > 0 ? " & " : "") + line[i];
    text += " \\\\\n";
  }
  return text + "\\end{longtable}}\n";
}

}  // namespace

std::string latex_document(const symbolic::Equations& equations) {
  std::string text = preamble;
  text += "\\section*{" + fit::latex(equations.scene.name) + ": " + std::to_string(size(equations.scene)) +
          (size(equations.scene) == 1 ? " body" : " bodies") +
          "}\n$\\tilde a b = a \\times b$; $R_K$ takes inertial components to those in body $K$.\n";
  text += latex_of(body_grid(equations, symbolic::Style::latex));
  for (const Table& table : tables(equations, symbolic::Style::latex)) text += latex_of(table);
  return text + latex_of(load_grid(equations, symbolic::Style::latex)) + "\\end{document}\n";
}

}  // namespace kanec::emit
