// A small file system mounted on a folder for one test, to be filled up. Only root can; others ask error() and skip.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/mount.h>

#include <cerrno>
#include <filesystem>
#include <string>

namespace kanec::test {

class SmallDisk {
 public:
  // `size` as mount(8) writes it: "64k".
  SmallDisk(const std::filesystem::path& path, const std::string& size) : path_(path) {
    const std::string options = "mode=700,size=" + size;
    error_ = ::mount("kanec-test", path_.c_str(), "tmpfs", 0, options.c_str()) == 0 ? 0 : errno;
  }
  ~SmallDisk() {
    if (error_ == 0) ::umount2(path_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  int error() const { return error_; }

 private:
  std::filesystem::path path_;
  int error_;
};

}  // namespace kanec::test
