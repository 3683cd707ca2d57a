// A cache that took damage: rebuilt without a word, once. Oracles: the counting compiler, the toy's closed form.
// SPDX-License-Identifier: BSD-3-Clause
#include <functional>

#include "kanec_abi_text.hpp"
#include "runtime/base/hash.hpp"
#include "runtime/base/process.hpp"
#include "tests/compile/bench.hpp"

namespace kanec::compile::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

class Damage : public Bench {
 protected:
  void expect_rebuilt_after(const std::function<void(const fs::path& entry)>& damage) const {
    damage(make_entry());
    const Model rebuilt = build(toy(), options);
    EXPECT_FALSE(rebuilt.from_cache());
    EXPECT_EQ(evaluate(rebuilt), -12.0);
    EXPECT_THAT(rebuilt.notes(), IsEmpty());
    EXPECT_EQ(runs(), 2);
    EXPECT_TRUE(build(toy(), options).from_cache());
    EXPECT_EQ(runs(), 2);
    EXPECT_THAT(entries(), SizeIs(1));
  }

  // Puts another library in, with the seal that belongs to it.
  static void put_library(const fs::path& entry, const std::string& library) {
    write_file(entry / "model.so", library);
    write_file(entry / "seal", std::to_string(library.size()) + " " + fingerprint(library) + "\n");
  }

  // What a kanec of another ABI version would have made of the toy.
  std::string library_of_another_abi() const {
    const fs::path at = root() / "other";
    fs::create_directory(at);
    const std::string version = "#define KANEC_ABI_VERSION ";
    write_file(at / "abi.h", replaced(abi_text, version, version + "1000u + "));
    for (const auto& [name, text] : toy().files) write_file(at / name, text);
    const fs::path library = at / "model.so";
    make_library(command_line(find_compiler(""), {}, at / "toy_abi.cpp", library), library, at);
    return read_file(library);
  }
};

TEST_F(Damage, truncated_library_is_rebuilt) {
  expect_rebuilt_after(
      [](const fs::path& entry) { fs::resize_file(entry / "model.so", fs::file_size(entry / "model.so") / 2); });
}

TEST_F(Damage, empty_library_is_rebuilt) {
  expect_rebuilt_after([](const fs::path& entry) { fs::resize_file(entry / "model.so", 0); });
}

TEST_F(Damage, library_with_one_bit_changed_is_rebuilt) {
  expect_rebuilt_after([](const fs::path& entry) {
    std::string library = read_file(entry / "model.so");
    library[library.size() / 2] = static_cast<char>(library[library.size() / 2] ^ 1);
    write_file(entry / "model.so", library);
  });
}

TEST_F(Damage, missing_library_is_rebuilt) {
  expect_rebuilt_after([](const fs::path& entry) { fs::remove(entry / "model.so"); });
}

TEST_F(Damage, altered_key_is_rebuilt) {
  expect_rebuilt_after(
      [](const fs::path& entry) { write_file(entry / "key", replaced(read_file(entry / "key"), "-O0", "-O1")); });
}

TEST_F(Damage, shortened_key_is_rebuilt) {
  expect_rebuilt_after([](const fs::path& entry) { fs::resize_file(entry / "key", fs::file_size(entry / "key") - 1); });
}

TEST_F(Damage, missing_seal_is_rebuilt) {
  expect_rebuilt_after([](const fs::path& entry) { fs::remove(entry / "seal"); });
}

TEST_F(Damage, garbage_in_place_of_the_files_is_rebuilt) {
  expect_rebuilt_after([](const fs::path& entry) {
    for (const char* name : {"model.so", "key", "seal"}) write_file(entry / name, "garbage\n");
  });
}

TEST_F(Damage, garbage_in_place_of_the_entry_is_rebuilt) {
  expect_rebuilt_after([](const fs::path& entry) {
    fs::remove_all(entry);
    write_file(entry, "garbage\n");
  });
}

TEST_F(Damage, link_to_nowhere_in_place_of_the_entry_is_rebuilt) {
  expect_rebuilt_after([](const fs::path& entry) {
    fs::remove_all(entry);
    fs::create_symlink(entry.string() + ".none", entry);
  });
}

TEST_F(Damage, emptied_entry_is_rebuilt) {
  expect_rebuilt_after([](const fs::path& entry) {
    fs::remove_all(entry);
    fs::create_directory(entry);
  });
}

// The next two pass the seal, so that loading and the descriptor are what finds them.
TEST_F(Damage, sealed_file_that_is_no_library_is_rebuilt) {
  expect_rebuilt_after([](const fs::path& entry) { put_library(entry, "not a library\n"); });
}

TEST_F(Damage, sealed_library_of_another_abi_version_is_rebuilt) {
  const std::string library = library_of_another_abi();
  expect_rebuilt_after([&](const fs::path& entry) { put_library(entry, library); });
}

}  // namespace
}  // namespace kanec::compile::test
