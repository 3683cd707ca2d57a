// Where two texts begin to differ, for a person to read. Not a diff: what follows an inserted line is not matched
// again.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace kanec::test {

// "line 12:" and from there up to five lines of each, those before with "- ", those after with "+ ".
inline std::string first_difference(const std::string& before, const std::string& after) {
  const auto lines = [](const std::string& text) {
    std::vector<std::string> list;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) list.push_back(line);
    return list;
  };
  const std::vector<std::string> a = lines(before);
  const std::vector<std::string> b = lines(after);
  std::size_t first = 0;
  while (first < a.size() && first < b.size() && a[first] == b[first]) ++first;
  if (first == a.size() && first == b.size()) return "the last line ends differently\n";
  std::string text = "line " + std::to_string(first + 1) + ":\n";
  for (std::size_t i = first; i < a.size() && i < first + 5; ++i) text += "- " + a[i] + "\n";
  for (std::size_t i = first; i < b.size() && i < first + 5; ++i) text += "+ " + b[i] + "\n";
  return text;
}

}  // namespace kanec::test
