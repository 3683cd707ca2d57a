// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/endurance/trial.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

#include "runtime/base/files.hpp"
#include "runtime/cli/kanec.hpp"

namespace kanec::test {
namespace {

// In the child: as main() would.
[[noreturn]] void become(const std::filesystem::path& folder, std::vector<std::string> words, unsigned seconds) {
  ::alarm(seconds);
  const int file = ::open((folder / "output").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0 || ::chdir(folder.c_str()) != 0) ::_exit(127);
  ::dup2(file, 1);
  ::dup2(file, 2);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const int status = cli::run(static_cast<int>(words.size()), pointers.data());
  std::exit(status);
}

}  // namespace

Outcome run(const std::filesystem::path& folder, const std::vector<std::string>& arguments, unsigned seconds) {
  std::vector<std::string> words = {"kanec"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  Outcome outcome;
  for (const std::string& word : words) outcome.command += (outcome.command.empty() ? "" : " ") + word;
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process can be made");
  if (child == 0) become(folder, words, seconds);
  int status = 0;
  ::waitpid(child, &status, 0);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.output = read_file(folder / "output");
  return outcome;
}

}  // namespace kanec::test
