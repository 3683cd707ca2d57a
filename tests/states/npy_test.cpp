// Headers of .npy files: those that NumPy writes, and what is none.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/states/npy.hpp"

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "tests/base/folder.hpp"

namespace kanec::test {
namespace {

using testing::HasSubstr;

class Npy : public testing::Test {
 protected:
  NpyTable read(const std::string& bytes) const {
    write_file(folder_.path() / "a.npy", bytes);
    FileReader file((folder_.path() / "a.npy").string());
    return read_npy_header(file);
  }
  void refuses(const std::string& bytes, const std::string& message) const {
    try {
      read(bytes);
      ADD_FAILURE() << "read: " << message;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
  }

  // As numpy.save writes it, version 1.
  static std::string file(const std::string& dictionary, std::size_t data) {
    const std::string header = dictionary + "\n";
    return std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(header.size()) + '\0' + header +
           std::string(data, 'x');
  }

 private:
  Folder folder_;
};

TEST_F(Npy, header_is_read_as_it_is_written) {
  const NpyTable table = read(npy_header(3, 2) + std::string(48, 'x'));
  EXPECT_EQ(table.rows, 3);
  EXPECT_EQ(table.columns, 2);
  EXPECT_EQ(table.number_size, 8);
  EXPECT_FALSE(table.by_columns);
  EXPECT_EQ(table.begin % 64, 0u);
}

TEST_F(Npy, of_numpy_in_its_forms) {
  const NpyTable fortran = read(file("{'descr': '<f4', 'fortran_order': True, 'shape': (5, 2), }", 40));
  EXPECT_TRUE(fortran.by_columns);
  EXPECT_EQ(fortran.number_size, 4);
  const NpyTable column = read(file("{'descr': '<f8', 'fortran_order': False, 'shape': (5,), }", 40));
  EXPECT_EQ(column.rows, 5);
  EXPECT_EQ(column.columns, 1);
  EXPECT_EQ(read(file("{'descr': '<f8', 'fortran_order': False, 'shape': (0, 7), }", 0)).rows, 0);
}

TEST_F(Npy, that_is_none_is_refused) {
  refuses("", "no .npy file");
  refuses("theta_2,s_1\n0,0\n", "no .npy file");
  refuses(std::string("\x93NUMPY\x09\0\0\0", 10), "version 9");
  refuses(std::string("\x93NUMPY\x01\0\x40\0", 10), "ends in its header");
  refuses(std::string("\x93NUMPY\x02\0\xff\xff\xff\x7f", 12), "header of 2147483647 bytes");
  refuses(file("{'descr': '<c16', 'fortran_order': False, 'shape': (1, 1), }", 16), "'<c16'");
  refuses(file("{'descr': '>f8', 'fortran_order': False, 'shape': (1, 1), }", 8), "little endian");
  refuses(file("{'descr': [('a', '<f8')], 'fortran_order': False, 'shape': (1,), }", 8), "kind");
  refuses(file("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, 2), }", 64), "3 dimensions");
  refuses(file("{'descr': '<f8', 'fortran_order': False, 'shape': (), }", 8), "0 dimensions");
  refuses(file("{'fortran_order': False, 'shape': (1, 1), }", 8), "without descr");
  refuses(file("{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999999999999, 1), }", 8), "shape");
  refuses(file("{'descr': '<f8', 'fortran_order': False, 'shape': (1099511627776, 1048576), }", 8),
          "its header announces");
  refuses(file("{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }", 47), "its header announces");
  refuses(file("{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }", 49), "its header announces");
}

}  // namespace
}  // namespace kanec::test
