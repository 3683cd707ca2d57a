// The README's example, against what the generator makes of it. Oracle: none; a document must not go stale.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>

#include <sstream>
#include <string>

#include "generator/pipeline.hpp"
#include "generator/read/read.hpp"
#include "runtime/base/files.hpp"

namespace kanec {
namespace {

// The text between the first "```language" and the next "```".
std::string block(const std::string& document, const std::string& language) {
  const std::string fence = "```" + language + "\n";
  const std::size_t begin = document.find(fence) + fence.size();
  return document.substr(begin, document.find("```", begin) - begin);
}

TEST(Readme, shows_lines_that_its_scene_really_gives) {
  const std::string readme = read_file(KANEC_SOURCE_DIR "/README.md");
  const Generated generated = generate(scene::parse(block(readme, "toml"), "README.md"));
  std::istringstream shown(block(readme, "cpp"));
  int compared = 0;
  for (std::string line; std::getline(shown, line);) {
    if (line == "  ...") continue;
    EXPECT_THAT(generated.header, testing::HasSubstr(line + "\n"));
    ++compared;
  }
  EXPECT_GE(compared, 5);
}

}  // namespace
}  // namespace kanec
