// The fenced blocks of a Markdown page, in order. Not: what is done with them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace kanec::test {

struct Block {
  std::string language, text;  // "sh"
};

inline std::vector<Block> blocks(const std::string& page) {
  std::vector<Block> list;
  const std::string fence = "```";
  for (std::size_t at = page.find(fence); at != std::string::npos;) {
    const std::size_t line = page.find('\n', at), end = page.find("\n" + fence, line);
    if (end == std::string::npos) break;
    list.push_back({page.substr(at + fence.size(), line - at - fence.size()), page.substr(line + 1, end - line)});
    at = page.find(fence, end + 1 + fence.size());
  }
  return list;
}

}  // namespace kanec::test
