// Text that strangers chose (names of files and folders, texts of scenes, words of compilers, variables of the
// environment) made fit for where it is printed. Not: numbers, nor names that are C++ identifiers already.
//
// A character that is obeyed rather than shown (controls, line ends, marks of direction) and a byte that is no UTF-8
// never gets through; letters of all scripts do. Where nothing else is said they stand as \x1b, \u202e.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace kanec::fit {

// One line for a terminal.
std::string line(std::string_view text);

// Several, as a compiler writes them: line feeds and tabs stay.
std::string lines(std::string_view text);

// Part of a C++ comment of either kind, also at its end, in every standard: printable ASCII without backslashes,
// trigraphs, ends and beginnings of comments, where each other character is one '_'.
std::string comment(std::string_view text);

// Text of a LaTeX document, outside of formulas.
std::string latex(std::string_view text);

// A string of gnuplot's, quotes included, in which nothing is substituted: a path or, where the terminal is not
// enhanced, a title.
std::string gnuplot(std::string_view text);

// Content or an attribute's value of XML: SVG.
std::string xml(std::string_view text);

// Text within a line or a table's cell of a Markdown page.
std::string markdown(std::string_view text);

// The same as code, backquotes included; not in tables, where a bar would end the cell.
std::string code(std::string_view text);

// The target of a Markdown link or picture: a path relative to the page.
std::string link(std::string_view path);

// One word of a command that is typed into a shell, which hands on exactly this text. What is not printable stands
// in $'...', which bash, zsh and ksh know.
std::string shell(std::string_view word);

// A field of a CSV file (RFC 4180), on one line.
std::string csv(std::string_view field);

// A whole JSON text whose strings are UTF-8: the same values, what is obeyed as \uXXXX.
std::string json(std::string_view text);

// A basic string of TOML, quotes included, with this value; a byte that is no UTF-8 becomes U+FFFD.
std::string toml(std::string_view text);

}  // namespace kanec::fit
