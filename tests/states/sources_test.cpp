// States from files of each kind. Oracle: the numbers that were written.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstring>

#include "generator/read/read.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/model/result_layout.hpp"
#include "runtime/states/evaluate_many.hpp"
#include "runtime/states/npy.hpp"
#include "runtime/states/state_source.hpp"
#include "tests/base/folder.hpp"

namespace kanec::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class States : public testing::Test {
 protected:
  scene::Scene scene = scene::read(KANEC_SOURCE_DIR "/models/cart_pole/scene.toml");  // theta_2, s_1; pole, cart; push
  Needs needs{true, false};

  std::string file(const std::string& name, const std::string& text) const {
    write_file(folder_.path() / name, text);
    return (folder_.path() / name).string();
  }

  std::vector<State> all(const std::string& name, const std::string& text, const Needs& wanted) const {
    const auto source = open_states(file(name, text), table_format_of_file(name), scene, wanted);
    std::vector<State> list;
    for (State state = initial_state(scene); source->next(state);) list.push_back(state);
    return list;
  }
  std::vector<State> all(const std::string& name, const std::string& text) const { return all(name, text, needs); }

  void refuses(const std::string& name, const std::string& text, const std::string& message) const {
    try {
      all(name, text);
      ADD_FAILURE() << "read: " << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
  }

  static std::string npy(const std::vector<std::vector<double>>& rows) {
    std::string bytes = npy_header(static_cast<std::int64_t>(rows.size()), static_cast<std::int64_t>(rows[0].size()));
    for (const auto& row : rows) bytes.append(reinterpret_cast<const char*>(row.data()), row.size() * sizeof(double));
    return bytes;
  }

 private:
  Folder folder_;
};

TEST_F(States, of_csv_by_number_and_by_body_in_any_order) {
  const auto list = all(
      "a.csv", "s_cart[m], theta_2[rad] ,thetadot_pole,sdot_1,push,t\n1,2,3,4,5,6\r\n\n# a remark\n-1e3,+.5,0,0,0,0");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_THAT(list[0].x, ElementsAre(2, 1));
  EXPECT_THAT(list[0].y, ElementsAre(3, 4));
  EXPECT_THAT(list[0].inputs, ElementsAre(5));
  EXPECT_EQ(list[0].t, 6);
  EXPECT_THAT(list[1].x, ElementsAre(0.5, -1000));
}

TEST_F(States, of_a_trajectory) {
  EXPECT_EQ(
      all("run.csv",
          "t[s],theta_2[rad],s_1[m],thetadot_2[rad/s],sdot_1[m/s],kinetic[J],potential[J],work[J]\n0,1,2,3,4,5,6,7\n")
          .size(),
      1u);
}

TEST_F(States, of_csv_that_is_none_are_refused_by_line) {
  const std::string header = "theta_2,s_1,thetadot_2,sdot_1\n";
  refuses("a.csv", "", "a.csv: found nothing");
  refuses("a.csv", "theta_2,s_1,thetadot_2\n1,2,3\n", "a.csv:1: found no column sdot_cart");
  refuses("a.csv", "theta_2,s_1,thetadot_2,sdot_1,thta\n", "a.csv:1: column 5: found \"thta\"");
  refuses("a.csv", "theta_2,theta_pole,s_1,thetadot_2,sdot_1\n", "a.csv:1: column 2: found \"theta_pole\" twice");
  refuses("a.csv", header + "1,2,3,4\n1,2,3\n", "a.csv:3: found 3 numbers");
  refuses("a.csv", header + "1,2,3,4,5\n", "a.csv:2: found 5 numbers");
  refuses("a.csv", header + "1,2,3,4\n\n1,x,3,4\n", "a.csv:4: s_1: found \"x\"");
  refuses("a.csv", header + "1,nan,3,4\n", "a.csv:2: s_1: found \"nan\"");
  refuses("a.csv", header + "1,,3,4\n", "a.csv:2: s_1: found nothing");
}

TEST_F(States, of_json_lines) {
  const auto list = all("a.jsonl",
                        "{\"x\": {\"theta_pole\": 1, \"s_1\": 2}, \"y\": {\"thetadot_2\": 3, \"sdot_cart\": 4}, "
                        "\"inputs\": {\"push\": 9}}\n\n"
                        "{\"x\": {\"theta_2\": 5, \"s_1\": 6}, \"y\": {\"thetadot_2\": 7, \"sdot_1\": 8}}");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_THAT(list[0].x, ElementsAre(1, 2));
  EXPECT_THAT(list[0].inputs, ElementsAre(9));
  EXPECT_THAT(list[1].inputs, ElementsAre(0));
  refuses("a.jsonl", "{\"x\": {\"theta_2\": 5, \"theta_pole\": 5, \"s_1\": 6}, \"y\": {}}\n", "which are one");
  refuses("a.jsonl", "{\"x\": {\"theta_2\": 5, \"s_1\": 6}, \"y\": {\"thetadot_2\": 7, \"sdot_1\": 8}}\n{\"x\": \n",
          "a.jsonl:2");
}

TEST_F(States, of_npy_with_and_without_time) {
  const auto list = all("a.npy", npy({{1, 2, 3, 4}, {5, 6, 7, 8}}));
  ASSERT_EQ(list.size(), 2u);
  EXPECT_THAT(list[1].x, ElementsAre(5, 6));
  EXPECT_THAT(list[1].y, ElementsAre(7, 8));
  const auto timed = all("a.npy", npy({{9, 1, 2, 3, 4}}));
  EXPECT_EQ(timed[0].t, 9);
  EXPECT_THAT(timed[0].x, ElementsAre(1, 2));
  EXPECT_THAT(all("a.npy", npy({{1, 2, 3, 4, 5, 6}}), {true, true})[0].ydot, ElementsAre(5, 6));
}

TEST_F(States, of_npy_in_fortrans_order) {
  const double numbers[] = {1, 5, 2, 6, 3, 7, 4, 8};
  std::string bytes = npy_header(2, 4);
  bytes.replace(bytes.find("False, "), 7, "True , ");
  bytes.replace(bytes.find("True , "), 7, "True,  ");
  bytes.append(reinterpret_cast<const char*>(numbers), sizeof(numbers));
  const auto list = all("a.npy", bytes);
  EXPECT_THAT(list[0].x, ElementsAre(1, 2));
  EXPECT_THAT(list[1].y, ElementsAre(7, 8));
}

TEST_F(States, of_npy_that_do_not_fit_are_refused) {
  refuses("a.npy", npy({{1, 2, 3}}), "found 3 columns; allowed: 4, which are x (2), y (2)");
  refuses("a.npy", npy({{1, 2, 3, 4}, {1, std::nan(""), 3, 4}}), "a.npy: row 1, column 1: found nan");
}

TEST_F(States, results_have_names_and_units) {
  EXPECT_THAT(result_names(result_layouts(scene, "accelerations")),
              ElementsAre("thetaddot_pole[rad/s^2]", "sddot_cart[m/s^2]"));
  EXPECT_THAT(result_names(result_layouts(scene, "mass_matrix")), ElementsAre("A_1_1", "A_1_2", "A_2_1", "A_2_2"));
  EXPECT_THAT(result_names(result_layouts(scene, "forcing+energy"))[2], "energy.kinetic[J]");
}

}  // namespace
}  // namespace kanec::test
