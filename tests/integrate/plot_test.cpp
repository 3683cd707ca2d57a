// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/picture/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/base/error.hpp"
#include "runtime/base/process.hpp"
#include "tests/integrate/output_fixture.hpp"
#include "tests/integrate/tree_model.hpp"

namespace kanec::integrate::test {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

// The PATH of this process while it lives.
class Path {
 public:
  explicit Path(const std::string& path) : before_(::getenv("PATH")) { ::setenv("PATH", path.c_str(), 1); }
  ~Path() { ::setenv("PATH", before_.c_str(), 1); }
  Path(const Path&) = delete;
  Path& operator=(const Path&) = delete;

 private:
  std::string before_;
};

// A program called gnuplot in a folder of its own, first on the PATH.
class FakeGnuplot {
 public:
  explicit FakeGnuplot(const std::string& script)
      : program_(write(folder_.path(), script)), path_(folder_.path().string() + ":" + ::getenv("PATH")) {}

 private:
  static std::filesystem::path write(const std::filesystem::path& folder, const std::string& script) {
    const std::filesystem::path program = folder / "gnuplot";
    write_file(program, "#!/bin/sh\n" + script);
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return program;
  }
  Folder folder_;
  std::filesystem::path program_;
  Path path_;
};

// Writes the script it is given where the picture should go, ending like one.
const char* const echo =
    "script=$(cat)\nout=$(printf '%s' \"$script\" | sed -n \"s/^set output '\\(.*\\)'$/\\1/p\")\n"
    "printf '%s</svg>' \"$script\" > \"$out\"\n";

void add_rows(Plot& plot, int n_bodies, int rows, bool has_energy) {
  const std::vector<double> x(static_cast<std::size_t>(7 * n_bodies), 0.5),
      y(static_cast<std::size_t>(6 * n_bodies), 2.0);
  for (int i = 0; i < rows; ++i)
    plot.add({0.25 * i, x, y, 1.0 * i, has_energy ? std::optional(Energy{1.0 * i, 3.0}) : std::nullopt});
}

PlotData one_sample(int n_bodies, bool has_energy) {
  PlotData data{free_names(n_bodies), has_energy, false};
  data.values.assign(data.columns(), 1.0);
  return data;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Plot, is_a_picture_with_axes_units_and_legend) {
  if (!find_program("gnuplot")) GTEST_SKIP() << "gnuplot is not installed (Debian package gnuplot-nox)";
  const Folder folder;
  Solver solver(six_bodies());
  solver.set_parameters(std::vector<double>{0.0, 0.0, -9.81});
  Plot plot(folder.path() / "run.svg", free_names(6), true);
  simulate(solver, six_body_coordinates(), six_body_speeds(), {}, [&plot](const Row& row) { plot.add(row); });
  plot.finish();
  const std::string picture = read_file(folder.path() / "run.svg");
  for (const char* text : {"<svg", "time t [s]", "ε [-]", "s [m]", "ω [rad/s]", "ds/dt [m/s]", "energy [J]",
                           "change of energy - work [J]", "kinetic", "potential", "body 6", "</svg>"})
    EXPECT_THAT(picture, HasSubstr(text));
  EXPECT_EQ(count(picture, "time t [s]"), 6u);  // one a panel
}

TEST(Plot, of_a_model_without_energy_has_four_panels) {
  if (!find_program("gnuplot")) GTEST_SKIP() << "gnuplot is not installed (Debian package gnuplot-nox)";
  const Folder folder;
  Plot plot(folder.path() / "run.svg", free_names(1), false);
  add_rows(plot, 1, 1, false);  // a single row of constants is the hardest for axis ranges
  plot.finish();
  const std::string picture = read_file(folder.path() / "run.svg");
  EXPECT_EQ(count(picture, "time t [s]"), 4u);
  EXPECT_THAT(picture, AllOf(HasSubstr("omega_1_3"), Not(HasSubstr("energy"))));
}

TEST(Plot, thins_long_runs_and_keeps_their_ends) {
  const FakeGnuplot gnuplot(echo);
  const Folder folder;
  Plot plot(folder.path() / "run.svg", free_names(1), true);
  add_rows(plot, 1, 100'000, true);
  plot.finish();
  const std::string script = read_file(folder.path() / "run.svg");
  const std::size_t begin = script.find("$energy << END\n") + 15, end = script.find("END\n", begin);
  const std::string block = script.substr(begin, end - begin);
  EXPECT_EQ(block.rfind("0 0 3 0 0\n", 0), 0u);  // t, kinetic, potential, work, deviation
  EXPECT_THAT(block, EndsWith("\n24999.75 99999 3 99999 0\n"));
  EXPECT_GT(count(block, "\n"), 600u);
  EXPECT_LE(count(block, "\n"), 1201u);
}

TEST(Plot, without_gnuplot_names_the_package) {
  const Path path("/nonexistent");
  EXPECT_THAT([] { Plot("/tmp/unused.svg", free_names(1), true); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("gnuplot"), HasSubstr("Debian package gnuplot-nox"))));
}

TEST(Plot, that_gnuplot_cannot_draw_is_an_error_with_its_words) {
  const FakeGnuplot gnuplot("cat > /dev/null\necho 'unknown terminal' >&2\nexit 3\n");
  const Folder folder;
  {
    Plot plot(folder.path() / "run.svg", free_names(1), true);
    add_rows(plot, 1, 2, true);
    EXPECT_THAT([&plot] { plot.finish(); },
                ThrowsMessage<FileError>(
                    AllOf(HasSubstr("run.svg: gnuplot failed with status 3"), HasSubstr("unknown terminal"))));
  }
  EXPECT_TRUE(folder.is_empty());
}

TEST(Plot, that_gnuplot_left_out_is_an_error) {
  const FakeGnuplot gnuplot("cat > /dev/null\n");
  const Folder folder;
  Plot plot(folder.path() / "run.svg", free_names(1), true);
  add_rows(plot, 1, 2, true);
  EXPECT_THAT([&plot] { plot.finish(); }, ThrowsMessage<FileError>(HasSubstr("gnuplot failed with status 0")));
}

TEST(Plot, of_names_that_do_not_fit_is_refused) {
  const FakeGnuplot gnuplot(echo);
  const Folder folder;
  StateNames names = free_names(2);
  names.coordinates.back() = "velocity";
  EXPECT_THROW(Plot(folder.path() / "run.svg", names, true), InternalError);
}

TEST(Plot, in_no_folder_or_on_a_full_disk_is_a_file_error) {
  const FakeGnuplot gnuplot(echo);
  EXPECT_THAT([] { Plot("/nonexistent/run.svg", free_names(1), true); },
              ThrowsMessage<FileError>("/nonexistent/run.svg: No such file or directory"));
  Plot full("/dev/full", free_names(1), true);
  add_rows(full, 1, 2, true);
  EXPECT_THAT([&full] { full.finish(); }, ThrowsMessage<FileError>("/dev/full: No space left on device"));
}

TEST(PlotScript, names_curves_of_few_bodies_bodies_of_some_and_none_of_many) {
  const std::string few = gnuplot_script(one_sample(3, false), "out.svg");
  EXPECT_THAT(few, AllOf(HasSubstr("title 'eps_3_4'"), HasSubstr("title 'sdot_2_1'"), Not(HasSubstr("notitle"))));
  const std::string some = gnuplot_script(one_sample(12, false), "out.svg");
  EXPECT_EQ(count(some, "title 'body 12'"), 4u);
  EXPECT_THAT(some, HasSubstr("translations (1 solid, 2 dashed, 3 dotted)"));
  const std::string many = gnuplot_script(one_sample(64, false), "out.svg");
  EXPECT_EQ(count(many, "title 'body"), 0u);
  EXPECT_EQ(count(many, " with lines "), 64u * 13u);
  EXPECT_THAT(many, HasSubstr("(1 solid, 2 dashed, 3 dotted; body 1 blue … 64 red)"));
}

PlotData sample_of(const StateNames& names) {
  PlotData data{names, true, true};
  data.values.assign(data.columns(), 1.0);
  return data;
}

TEST(PlotScript, has_a_row_of_panels_a_kind_of_coordinate) {
  const std::string arm = gnuplot_script(
      sample_of({{"theta_1", "theta_2", "theta_3"}, {"thetadot_1", "thetadot_2", "thetadot_3"}}), "out.svg");
  EXPECT_THAT(arm, AllOf(HasSubstr("multiplot layout 2,2"), HasSubstr("θ [rad]"), HasSubstr("dθ/dt [rad/s]"),
                         Not(HasSubstr("ε [-]")), Not(HasSubstr("s [m]"))));
  const std::string mixed = gnuplot_script(
      sample_of({{"eps_1_1", "eps_1_2", "eps_1_3", "eps_1_4", "theta_2_1", "theta_2_2", "s_1_1", "s_3"},
                 {"omega_1_1", "omega_1_2", "omega_1_3", "thetadot_2_1", "thetadot_2_2", "sdot_1_1", "sdot_3"}}),
      "out.svg");
  EXPECT_THAT(mixed, AllOf(HasSubstr("multiplot layout 4,2"), HasSubstr("size 1500,1680"), HasSubstr("title 's_3'")));
  EXPECT_EQ(count(mixed, " with lines "), 15u + 5u);
  EXPECT_THAT(mixed, HasSubstr("title 'work of the prescribed coordinates"));
}

TEST(PlotScript, of_a_long_chain_tells_bodies_by_colour_alone) {
  StateNames chain;
  for (int k = 1; k <= 32; ++k) {
    chain.coordinates.push_back("theta_" + std::to_string(k));
    chain.speeds.push_back("thetadot_" + std::to_string(k));
  }
  EXPECT_THAT(
      gnuplot_script(sample_of(chain), "out.svg"),
      AllOf(HasSubstr("angles (body 1 blue … 32 red)"), Not(HasSubstr("title 'theta_")), Not(HasSubstr("dt 2 title"))));
}

TEST(PlotScript, of_prescribed_coordinates_alone_is_drawn) {
  if (!find_program("gnuplot")) GTEST_SKIP() << "gnuplot is not installed (Debian package gnuplot-nox)";
  const Folder folder;
  Plot plot(folder.path() / "run.svg", {}, true, true);
  plot.add({0.0, {}, {}, 0.0, Energy{1, 2}});
  plot.finish();
  EXPECT_EQ(count(read_file(folder.path() / "run.svg"), "time t [s]"), 2u);
}

TEST(PlotScript, quotes_the_output_path) {
  EXPECT_THAT(gnuplot_script(one_sample(1, false), "it's.svg"), HasSubstr("set output \"it\\047s.svg\"\n"));
}

// A deviation far below the energies survives the rounding of what is drawn.
TEST(PlotScript, takes_the_deviation_before_rounding) {
  PlotData data = one_sample(1, true);
  std::vector<double> second(data.columns(), 1.0);
  second[data.columns() - 3] = 1.0 + 0x1p-40;
  data.values.insert(data.values.end(), second.begin(), second.end());
  EXPECT_THAT(gnuplot_script(data, "out.svg"), HasSubstr("1 1 1 1 9.094947e-13\n"));  // 2^-40
}

}  // namespace
}  // namespace kanec::integrate::test
