// The page on embedding in C, block by block as a reader would take it: files are written, commands typed, their output
// compared with what the page shows. Oracle: the page; a document must not go stale.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <filesystem>

#include "runtime/base/files.hpp"
#include "runtime/base/process.hpp"
#include "tests/base/folder.hpp"
#include "tests/generated/page.hpp"

namespace kanec::test {
namespace {

namespace fs = std::filesystem;

// "cart.c" of a block that begins with "// cart.c: one second of ..." or "# load.py".
std::string file_name(const std::string& text) {
  const std::size_t begin = text.find(' ') + 1;
  return text.substr(begin, text.find_first_of(":\n", begin) - begin);
}

TEST(PageOnEmbedding, shows_what_its_examples_give) {
  Folder folder;
  fs::create_directory_symlink(KANEC_SOURCE_DIR "/models", folder.path() / "models");
  const bool has_python = find_program("python3").has_value();
  std::string said;
  int shown = 0;
  for (const Block& block : blocks(read_file(KANEC_SOURCE_DIR "/docs/embed_c.md"))) {
    const bool is_of_python = block.text.find("python3") != std::string::npos;
    if (block.language == "c" || block.language == "python") {
      write_file(folder.path() / file_name(block.text), block.text);
    } else if (block.language == "sh") {
      if (is_of_python && !has_python) {
        GTEST_LOG_(INFO) << "python3 is not installed: its example is not run";
        break;
      }
      const ProcessResult result = run_process(
          {"/bin/sh", "-ec", "cd '" + folder.path().string() + "'\nPATH='" KANEC_BINARY_DIR "':$PATH\n" + block.text});
      ASSERT_EQ(result.status, 0) << block.text << result.output;
      said = result.output;
    } else if (block.language == "text") {
      EXPECT_EQ(said, block.text);
      ++shown;
    }
  }
  EXPECT_EQ(shown, has_python ? 3 : 2);
}

}  // namespace
}  // namespace kanec::test
