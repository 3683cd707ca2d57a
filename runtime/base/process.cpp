// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "runtime/base/descriptor.hpp"
#include "runtime/base/error.hpp"

namespace kanec {
namespace {

namespace fs = std::filesystem;

void require(bool success, const char* what) {
  if (!success) throw FileError(what, std::strerror(errno));
}

// Away from 0, 1 and 2, which the child's redirections overwrite; they are free here when our caller closed them.
Descriptor above_standard(Descriptor descriptor) {
  if (descriptor.get() > STDERR_FILENO) return descriptor;
  Descriptor copy(::fcntl(descriptor.get(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  require(static_cast<bool>(copy), "descriptor");
  return copy;
}

// The whole input as a file in memory: nothing to feed while the child runs, so neither a deadlock nor a broken pipe.
Descriptor input_file(std::string_view input) {
  Descriptor file(input.empty() ? ::open("/dev/null", O_RDONLY | O_CLOEXEC) : ::memfd_create("input", MFD_CLOEXEC));
  require(static_cast<bool>(file), "input of a process");
  while (!input.empty()) {
    const ssize_t n = ::write(file.get(), input.data(), input.size());
    if (n < 0 && errno == EINTR) continue;
    require(n > 0, "input of a process");
    input.remove_prefix(static_cast<std::size_t>(n));
  }
  ::lseek(file.get(), 0, SEEK_SET);
  return above_standard(std::move(file));
}

struct Pipe {
  Descriptor read_end, write_end;
};

Pipe make_pipe() {
  int ends[2];
  require(::pipe2(ends, O_CLOEXEC) == 0, "pipe");
  Pipe pipe{Descriptor(ends[0]), Descriptor(ends[1])};
  pipe.write_end = above_standard(std::move(pipe.write_end));
  return pipe;
}

class Redirections {
 public:
  Redirections() { ::posix_spawn_file_actions_init(&actions_); }
  ~Redirections() { ::posix_spawn_file_actions_destroy(&actions_); }
  Redirections(const Redirections&) = delete;
  Redirections& operator=(const Redirections&) = delete;
  void add(const Descriptor& from, int to) { ::posix_spawn_file_actions_adddup2(&actions_, from.get(), to); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

// SIGPIPE as programs expect it, also where our caller ignores it.
class DefaultSignals {
 public:
  DefaultSignals() {
    sigset_t signals;
    ::sigemptyset(&signals);
    ::sigaddset(&signals, SIGPIPE);
    ::posix_spawnattr_init(&attributes_);
    ::posix_spawnattr_setsigdefault(&attributes_, &signals);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
  }
  ~DefaultSignals() { ::posix_spawnattr_destroy(&attributes_); }
  DefaultSignals(const DefaultSignals&) = delete;
  DefaultSignals& operator=(const DefaultSignals&) = delete;
  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

// A started child; waited for even when reading its output throws.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  ~Child() {
    if (pid_ > 0) wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // The wait status, or nothing when the system reaped the child itself (a caller that ignores SIGCHLD).
  std::optional<int> wait() {
    int status = 0;
    pid_t waited = 0;
    do waited = ::waitpid(pid_, &status, 0);
    while (waited < 0 && errno == EINTR);
    pid_ = 0;
    return waited < 0 ? std::nullopt : std::optional(status);
  }

 private:
  pid_t pid_;
};

std::vector<std::string> environment_with(const Environment& variables) {
  std::vector<std::string> list;
  const auto is_given = [&variables](const std::string& line) {
    return std::any_of(variables.begin(), variables.end(), [&line](const auto& variable) {
      return line.compare(0, variable.first.size() + 1, variable.first + "=") == 0;
    });
  };
  for (char** line = environ; line != nullptr && *line != nullptr; ++line)
    if (!is_given(*line)) list.emplace_back(*line);
  for (const auto& [name, value] : variables) list.push_back(name + "=" + value);
  return list;
}

std::vector<char*> pointers(const std::vector<std::string>& list) {
  std::vector<char*> result;
  for (const std::string& text : list) result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

pid_t start(const fs::path& program, const std::vector<std::string>& argv, const Descriptor& in, const Descriptor& out,
            const Environment& variables) {
  Redirections redirections;
  redirections.add(in, STDIN_FILENO);
  redirections.add(out, STDOUT_FILENO);
  redirections.add(out, STDERR_FILENO);
  const std::vector<std::string> environment = environment_with(variables);
  pid_t pid = 0;
  const int error = ::posix_spawn(&pid, program.c_str(), redirections.get(), DefaultSignals().get(),
                                  pointers(argv).data(), pointers(environment).data());
  if (error != 0) throw FileError(program.string(), std::strerror(error));
  return pid;
}

std::string read_all(const Descriptor& source) {
  std::string text;
  char block[65536];
  for (;;) {
    const ssize_t n = ::read(source.get(), block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    require(n >= 0, "output of a process");
    if (n == 0) return text;
    text.append(block, static_cast<std::size_t>(n));
  }
}

bool is_program(const fs::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && ::access(path.c_str(), X_OK) == 0;
}

// PATH, or the system's own where it is not set.
std::string search_path() {
  if (const char* path = std::getenv("PATH")) return path;
  std::string path(::confstr(_CS_PATH, nullptr, 0), '\0');
  ::confstr(_CS_PATH, path.data(), path.size());
  return path.c_str();
}

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
  if (name.empty()) return std::nullopt;
  if (name.find('/') != std::string::npos) return is_program(name) ? std::optional<fs::path>(name) : std::nullopt;
  const std::string path = search_path();
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find(':', begin), path.size());
    const std::string folder = path.substr(begin, end - begin);
    const fs::path candidate = fs::path(folder.empty() ? "." : folder) / name;
    if (is_program(candidate)) return candidate;
    begin = end + 1;
  }
  return std::nullopt;
}

ProcessResult run_process(const std::vector<std::string>& argv, std::string_view input, const Environment& variables) {
  if (argv.empty()) throw InternalError("run_process without a program");
  const bool is_path = argv[0].find('/') != std::string::npos;
  const auto program = is_path ? argv[0] : find_program(argv[0]);
  if (!program) throw FileError(argv[0], "no such program on PATH");
  const Descriptor in = input_file(input);
  Pipe out = make_pipe();
  ProcessResult result;
  Child child(start(*program, argv, in, out.write_end, variables));
  const Descriptor source = std::move(out.read_end);  // closed before the child is waited for
  out.write_end.close();
  result.output = read_all(source);
  const auto status = child.wait();
  if (!status) throw FileError(argv[0], "its exit status is not known: SIGCHLD is ignored");
  result.status = WIFSIGNALED(*status) ? 128 + WTERMSIG(*status) : WEXITSTATUS(*status);
  return result;
}

}  // namespace kanec
