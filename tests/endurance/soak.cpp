// Random scenes through generate, check and simulate until the time is over. What fails is kept in a folder of its own:
// the scene, the command and what it said. Not: how scenes are drawn (random_model.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "runtime/base/files.hpp"
#include "runtime/model/scene_text.hpp"
#include "tests/base/folder.hpp"
#include "tests/endurance/random_model.hpp"
#include "tests/endurance/trial.hpp"

namespace kanec::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::string joined(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& item : list) text += (text.empty() ? "" : ",") + item;
  return text;
}

template <std::size_t N>
std::string one_of(Random& random, const std::array<const char*, N>& list) {
  return list[static_cast<std::size_t>(random.below(N))];
}

// Bounds beyond which code is wrong and not only rounded: a random scene may have an A that is nearly singular.
constexpr const char* ulps = "1e7";
constexpr const char* from_generic = "1e-6";

using Command = std::vector<std::string>;

void append(Command& command, const Command& more) { command.insert(command.end(), more.begin(), more.end()); }

// generate in one form, check in another, simulate by some method. Triples are many: little of each is compiled.
std::vector<Command> commands(Random& random, const scene::Scene& scene, bool is_triple) {
  constexpr std::array forms = {"speed", "size", "line", "loops"};
  constexpr std::array algorithms = {"articulated", "composite"};
  constexpr std::array methods = {"rk4", "lie4", "gauss4", "gauss6", "dop853", "arkode", "cvode", "taylor"};
  const auto in_some_form = [&](Command command, int functions) {
    append(command,
           {"--functions", joined(random_functions(random, scene, functions)), "--optimize", one_of(random, forms)});
    if (random.chance(0.3)) append(command, {"--algorithm", one_of(random, algorithms)});
    return command;
  };
  std::vector<Command> list = {in_some_form({"generate", "scene.toml", "-o", "generated/", "--abi"}, 8)};
  if (random.chance(0.3)) list.back().push_back("--taylor");
  list.push_back(in_some_form(
      {"check", "scene.toml", "--states", "4", "--bound", ulps, "--generic-bound", from_generic}, is_triple ? 1 : 6));
  if (random.chance(is_triple ? 0.05 : 0.3))
    list.push_back({"simulate", "scene.toml", "--duration", "0.02", "--output-step", "0.01", "--integrator",
                    one_of(random, methods), "--csv", "trajectory.csv"});
  return list;
}

// A random load that grows with what it drives may leave all bounds in finite time: told as that, no failure.
bool is_end_of_motion(const Outcome& outcome) {
  return outcome.status == 2 && outcome.output.find("integration stopped at t = ") != std::string::npos;
}

class Soak {
 public:
  Soak(double seconds, std::uint64_t seed, fs::path kept)
      : end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))),
        seed_(seed),
        kept_(std::move(kept)) {}

  int all() {
    for (int number = 0; Clock::now() < end_; ++number) one(number);
    std::printf("soak, seed %llu: %d scenes, %d commands, %d failures%s\n", static_cast<unsigned long long>(seed_),
                scenes_, commands_, failures_, failures_ > 0 ? (", kept in " + kept_.string()).c_str() : "");
    return failures_ > 0 ? 1 : 0;
  }

 private:
  void one(int number) {
    const scene::Scene scene = random_model(seed_, number);
    Random random(seed_ * 7'000'003 + static_cast<std::uint64_t>(number));
    const Folder folder;
    ::setenv("KANEC_CACHE", (folder.path() / "cache").c_str(), 1);
    write_file(folder.path() / "scene.toml", scene_text(scene));
    ++scenes_;
    for (const Command& command : commands(random, scene, is_triple(number))) {
      ++commands_;
      constexpr unsigned patience = 300;
      const Outcome outcome = run(folder.path(), command, patience);
      if (outcome.status != 0 && !is_end_of_motion(outcome)) keep(number, folder.path(), outcome);
    }
  }

  void keep(int number, const fs::path& folder, const Outcome& outcome) {
    ++failures_;
    const fs::path place = kept_ / (std::to_string(seed_) + "_" + std::to_string(number));
    fs::create_directories(place);
    fs::copy_file(folder / "scene.toml", place / "scene.toml", fs::copy_options::overwrite_existing);
    write_file(place / "failure",
               outcome.command + "\nexit status " + std::to_string(outcome.status) + "\n" + outcome.output);
    std::printf("scene %d: exit status %d of %s\n", number, outcome.status, outcome.command.c_str());
    std::fflush(stdout);
  }

  Clock::time_point end_;
  std::uint64_t seed_;
  fs::path kept_;
  int scenes_ = 0, commands_ = 0, failures_ = 0;
};

}  // namespace
}  // namespace kanec::test

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) {
    std::fputs(
        "soak SECONDS SEED [FOLDER]: random scenes through kanec; what fails is kept in FOLDER (soak_failures)\n",
        stderr);
    return 2;
  }
  ::setenv("KANEC_CXXFLAGS", "-O0", 1);
  return kanec::test::Soak(std::atof(argv[1]), std::strtoull(argv[2], nullptr, 10),
                           argc > 3 ? argv[3] : "soak_failures")
      .all();
}
