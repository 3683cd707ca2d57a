// Two builds have one key only if nothing that matters differs. Oracle: texts written by hand.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/key.hpp"

#include <set>

#include "tests/compile/bench.hpp"

namespace kanec::compile::test {
namespace {

const Compiler compiler{"/usr/bin/none", {}, "none 1.0\n"};

TEST(Key, is_the_same_for_the_same) {
  EXPECT_EQ(cache_key(toy(), compiler, {"-O2"}), cache_key(toy(), compiler, {"-O2"}));
}

TEST(Key, tells_apart_whatever_differs) {
  const std::vector<std::string> flags = {"-O2", "-g"};
  Source hash = toy(), nx = toy(), ny = toy(), name = toy(), main = toy(), text = toy(), file = toy(), more = toy();
  hash.hash += "1";
  nx.nx = 2;
  ny.ny = 2;
  name.name += "2";
  main.main = "toy.hpp";
  text.files[0].second += ' ';
  file.files[0].first = "boy.hpp";
  more.files.emplace_back("a.hpp", "");
  std::set<std::string> keys;
  for (const Source& source : {toy(), hash, nx, ny, name, main, text, file, more})
    keys.insert(cache_key(source, compiler, flags));
  EXPECT_EQ(keys.size(), 9u);
  keys.insert(cache_key(toy(), {"/usr/bin/other", {}, "none 1.0\n"}, flags));
  keys.insert(cache_key(toy(), {"/usr/bin/none", {"-m32"}, "none 1.0\n"}, flags));
  keys.insert(cache_key(toy(), {"/usr/bin/none", {}, "none 1.1\n"}, flags));
  keys.insert(cache_key(toy(), compiler, {"-g", "-O2"}));
  keys.insert(cache_key(toy(), compiler, {"-O2 -g"}));
  keys.insert(cache_key(toy(), compiler, {"-O2"}));
  const Variable path("CPATH", "/none");
  keys.insert(cache_key(toy(), compiler, flags));
  EXPECT_EQ(keys.size(), 16u);
}

// A text that looks like what follows it in the key must not stand for it.
TEST(Key, no_text_passes_for_the_next_field) {
  Source one = toy(), two = toy();
  one.files = {{"a", "x\nb 1\ny"}};
  two.files = {{"a", "x"}, {"b", "y"}};
  EXPECT_NE(cache_key(one, compiler, {}), cache_key(two, compiler, {}));
}

TEST(Processor, is_its_kind_and_abilities_and_not_its_clock) {
  const std::string cpuinfo =
      "processor\t: 0\nvendor_id\t: GenuineIntel\ncpu family\t: 6\nmodel\t\t: 85\nmodel name\t: Xeon\n"
      "cpu MHz\t\t: 2300.1\nflags\t\t: fpu avx512f\nbogomips\t: 4600\n\nprocessor\t: 1\nmodel name\t: Second\n";
  EXPECT_EQ(processor(cpuinfo),
            "vendor_id\t: GenuineIntel\ncpu family\t: 6\nmodel\t\t: 85\nmodel name\t: Xeon\nflags\t\t: fpu avx512f\n");
}

TEST(Processor, of_other_makes_is_known_too) {
  EXPECT_EQ(processor("processor : 0\nBogoMIPS : 50\nFeatures : fp asimd\nCPU part : 0xd0c"),
            "Features : fp asimd\nCPU part : 0xd0c\n");
  EXPECT_EQ(processor(""), "");
}

}  // namespace
}  // namespace kanec::compile::test
