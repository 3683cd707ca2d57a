// Oracle: the test vectors published with FNV-1a (RFC 9923).
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/hash.hpp"

#include <gtest/gtest.h>

#include <string>

namespace kanec {
namespace {

TEST(Hash, fingerprint_gives_the_published_vectors) {
  EXPECT_EQ(fingerprint(""), "cbf29ce484222325");
  EXPECT_EQ(fingerprint("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(fingerprint("foobar"), "85944171f73967e8");
}

TEST(Hash, fingerprint_reads_every_byte) {
  EXPECT_NE(fingerprint(std::string("a\0b", 3)), fingerprint(std::string("a\0c", 3)));
  EXPECT_NE(fingerprint(std::string("\0", 1)), fingerprint(""));
  EXPECT_NE(fingerprint("\xff"), fingerprint("\x7f"));
}

}  // namespace
}  // namespace kanec
