// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/trajectory/trajectory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "runtime/base/error.hpp"
#include "tests/integrate/closed_form.hpp"
#include "tests/integrate/output_fixture.hpp"
#include "tests/integrate/tree_model.hpp"

namespace kanec::integrate::test {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::vector<double> x = {0, 0, 0.6, 0.8, 1, 0.1, -2.5}, y = {1e-300, 3, 1.0 / 3.0, 4, 5, 6};

TEST(Trajectory, has_a_header_with_units_and_one_line_a_row) {
  const Folder folder;
  Trajectory trajectory(folder.path() / "run.csv", free_names(1), true);
  trajectory.add({0.25, x, y, 1e22, Energy{7, -0.5}});
  trajectory.finish();
  EXPECT_EQ(read_file(folder.path() / "run.csv"),
            "t[s],eps_1_1,eps_1_2,eps_1_3,eps_1_4,s_1_1[m],s_1_2[m],s_1_3[m],omega_1_1[rad/s],omega_1_2[rad/s],"
            "omega_1_3[rad/s],sdot_1_1[m/s],sdot_1_2[m/s],sdot_1_3[m/s],kinetic[J],potential[J],work[J]\n"
            "0.25,0,0,0.6,0.8,1,0.1,-2.5,1e-300,3,0.3333333333333333,4,5,6,7,-0.5,1e+22\n");
}

TEST(Trajectory, of_a_model_without_energy_leaves_its_columns_out) {
  const Folder folder;
  Trajectory trajectory(folder.path() / "run.csv", free_names(1), false);
  trajectory.add({0.0, x, y, 0.0, {}});
  trajectory.finish();
  EXPECT_THAT(read_file(folder.path() / "run.csv"), HasSubstr("sdot_1_3[m/s],work[J]\n"));
  EXPECT_THAT(read_file(folder.path() / "run.csv"), ::testing::EndsWith(",4,5,6,0\n"));
}

TEST(Trajectory, of_any_joints_has_their_names_and_units) {
  const Folder folder;
  Trajectory trajectory(folder.path() / "run.csv", {{"theta_2", "s_1_3"}, {"thetadot_2", "sdot_1_3"}}, false);
  trajectory.finish();
  EXPECT_EQ(read_file(folder.path() / "run.csv"),
            "t[s],theta_2[rad],s_1_3[m],thetadot_2[rad/s],sdot_1_3[m/s],work[J]\n");
}

TEST(StateNames, tell_kind_body_and_component) {
  const Component wrist = component_of("thetadot_12_3", {}), slide = component_of("s_4", {});
  EXPECT_EQ(wrist.kind, Kind::thetadot);
  EXPECT_EQ(wrist.body, 12);
  EXPECT_EQ(wrist.component, 3);
  EXPECT_EQ(slide.kind, Kind::s);
  EXPECT_EQ(slide.component, 1);
  for (const char* name : {"", "eps", "eps_", "phi_1", "s_0", "s_x", "s_1_", "s_1_2_3", "theta_1x"})
    EXPECT_THROW(component_of(name, {}), InternalError) << name;
  const std::vector<std::string> bodies = {"1", "arm", "leg_2"};
  const Component leg = component_of("theta_leg_2", bodies), arm = component_of("omega_arm_2", bodies);
  EXPECT_TRUE(leg.body == 3 && leg.component == 1);
  EXPECT_TRUE(arm.body == 2 && arm.component == 2);
  EXPECT_EQ(component_of("eps_1_4", bodies).component, 4);
  EXPECT_EQ(unit_of("sdot_arm"), "m/s");
  for (const char* name : {"s_2", "s_leg", "s_leg_2_x", "theta_arm_0"})
    EXPECT_THROW(component_of(name, bodies), InternalError) << name;
}

TEST(Trajectory, reads_back_to_the_last_bit) {
  const Folder folder;
  const State start = precession(0.0);
  Trajectory trajectory(folder.path() / "run.csv", free_names(1), true);
  std::vector<double> expected;
  simulate(Solver(single_body()), start.x, start.y, {}, [&](const Row& row) {
    trajectory.add(row);
    expected.push_back(row.t);
    expected.insert(expected.end(), row.x.begin(), row.x.end());
    expected.insert(expected.end(), row.y.begin(), row.y.end());
    expected.insert(expected.end(), {row.energy->kinetic, row.energy->potential, row.work});
  });
  trajectory.finish();
  std::istringstream lines(read_file(folder.path() / "run.csv"));
  std::string line, field;
  std::getline(lines, line);
  std::vector<double> found;
  while (std::getline(lines, line))
    for (std::istringstream fields(line); std::getline(fields, field, ',');) found.push_back(std::stod(field));
  EXPECT_EQ(found.size(), 1001u * 17u);
  EXPECT_EQ(found, expected);
}

TEST(Trajectory, does_not_appear_before_it_is_finished) {
  const Folder folder;
  {
    Trajectory trajectory(folder.path() / "run.csv", free_names(1), false);
    for (int i = 0; i < 10000; ++i) trajectory.add({0.1 * i, x, y, 0.0, {}});
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "run.csv"));
  }
  EXPECT_TRUE(folder.is_empty());
}

TEST(Trajectory, on_a_full_disk_is_a_file_error) {
  const auto write = [](int rows) {
    Trajectory trajectory("/dev/full", free_names(1), false);
    for (int i = 0; i < rows; ++i) trajectory.add({0.1 * i, x, y, 0.0, {}});
    trajectory.finish();
  };
  EXPECT_THAT([&] { write(1); }, ThrowsMessage<FileError>("/dev/full: No space left on device"));
  EXPECT_THAT([&] { write(10000); }, ThrowsMessage<FileError>("/dev/full: No space left on device"));
}

TEST(Trajectory, in_no_folder_is_refused_before_the_run) {
  EXPECT_THAT([] { Trajectory("/nonexistent/run.csv", free_names(1), true); },
              ThrowsMessage<FileError>("/nonexistent/run.csv: No such file or directory"));
}

TEST(Trajectory, refuses_names_and_rows_that_do_not_fit) {
  const Folder folder;
  StateNames names = free_names(2);
  names.speeds.back() = "velocity";
  EXPECT_THROW(Trajectory(folder.path() / "run.csv", names, true), InternalError);
  Trajectory trajectory(folder.path() / "run.csv", free_names(1), true);
  EXPECT_THROW(trajectory.add({0.0, x, y, 0.0, {}}), InternalError);
  EXPECT_THROW(trajectory.add({0.0, x, x, 0.0, Energy{}}), InternalError);
}

}  // namespace
}  // namespace kanec::integrate::test
