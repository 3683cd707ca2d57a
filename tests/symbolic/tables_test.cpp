// The tables that are printed. Oracle: the source's tables of its six-body tree, typed in block by block.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/tables/tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <set>
#include <stdexcept>

#include "generator/read/read.hpp"
#include "generator/symbolic/derive.hpp"
#include "tests/symbolic/sample_documents.hpp"

namespace kanec::emit {
namespace {

using symbolic::Style;
using testing::ElementsAreArray;
using testing::UnorderedElementsAreArray;

using Rows = std::vector<Row>;

class TablesTest : public testing::TestWithParam<const char*> {
 protected:
  static symbolic::Equations equations() {
    const std::string model = GetParam();
    return symbolic::derive(model.empty() ? scene::from_connection({0, 1, 2, 2, 1, 5})
                                          : scene::read(KANEC_SOURCE_DIR "/models/" + model + "/scene.toml"));
  }

  static Rows rows(const std::string& title) {
    for (const Table& table : tables(equations(), Style::text))
      if (table.title.rfind(title, 0) == 0) return table.rows;
    ADD_FAILURE() << "no table " << title;
    return {};
  }
};

INSTANTIATE_TEST_SUITE_P(SixBodies, TablesTest, testing::Values("", "six_body"),
                         [](const auto& model) { return model.param[0] == 0 ? "connection" : model.param; });

TEST_P(TablesTest, stand_in_the_order_of_the_source) {
  std::vector<std::string> titles;
  for (const Table& table : tables(equations(), Style::text))
    titles.push_back(table.title.substr(0, table.title.find_first_of("(,")));
  const std::string rates = "Time derivatives of the partial ";
  EXPECT_THAT(titles,
              testing::ElementsAre("Connection array L", "State vectors", "Kinematical equations",
                                   "Rotations and angular velocities of the joints", "Positions of the mass centres",
                                   "Velocities of the mass centres", "Partial angular velocities ",
                                   "Partial angular velocities", "Partial velocities ", "Partial velocities",
                                   rates + "angular velocities ", rates + "angular velocities", rates + "velocities ",
                                   rates + "velocities", "Equations of motion", "Blocks of A ", "f"));
}

TEST_P(TablesTest, connection_array_and_steps_to_the_reference_body) {
  EXPECT_THAT(rows("Connection array"),
              ElementsAreArray(
                  Rows{{"K", "(1, 2, 3, 4, 5, 6)"}, {"L(K)", "(0, 1, 2, 2, 1, 5)"}, {"u(K)", "(0, 1, 2, 2, 1, 2)"}}));
}

TEST_P(TablesTest, state_has_42_coordinates_and_36_speeds) {
  EXPECT_THAT(rows("State vectors"),
              ElementsAreArray(Rows{
                  {"x", "(eps1, eps2, eps3, eps4, eps5, eps6; s1, s2, s3, s4, s5, s6)"},
                  {"size of x", "42"},
                  {"y", "(omega1, omega2, omega3, omega4, omega5, omega6; sdot1, sdot2, sdot3, sdot4, sdot5, sdot6)"},
                  {"size of y", "36"}}));
}

TEST_P(TablesTest, kinematical_equations_of_every_body) {
  Rows expected;
  for (const std::string k : {"1", "2", "3", "4", "5", "6"}) {
    expected.push_back({"edot" + k, "1/2 (eps4_" + k + " omega" + k + " + e" + k + "~ omega" + k + ")"});
    expected.push_back({"eps4dot" + k, "-1/2 e" + k + " . omega" + k});
    expected.push_back({"d/dt s" + k, "sdot" + k});
  }
  EXPECT_THAT(rows("Kinematical equations"), ElementsAreArray(expected));
}

TEST_P(TablesTest, rotations_are_of_euler_parameters) {
  Rows expected;
  for (const std::string k : {"1", "2", "3", "4", "5", "6"})
    expected.push_back({"R" + k + "^T", "1 + 2 e" + k + "~ (eps4_" + k + " + e" + k + "~)"});
  EXPECT_THAT(rows("Rotations"), ElementsAreArray(expected));
}

TEST_P(TablesTest, positions_run_up_the_tree) {
  EXPECT_THAT(rows("Positions"), ElementsAreArray(Rows{{"p1", "s1 + R1^T r1"},
                                                       {"p2", "s1 + R1^T (q2 + s2) + R2^T r2"},
                                                       {"p3", "s1 + R1^T (q2 + s2) + R2^T (q3 + s3) + R3^T r3"},
                                                       {"p4", "s1 + R1^T (q2 + s2) + R2^T (q4 + s4) + R4^T r4"},
                                                       {"p5", "s1 + R1^T (q5 + s5) + R5^T r5"},
                                                       {"p6", "s1 + R1^T (q5 + s5) + R5^T (q6 + s6) + R6^T r6"}}));
}

TEST_P(TablesTest, velocities_run_up_the_tree) {
  EXPECT_THAT(
      rows("Velocities"),
      ElementsAreArray(Rows{
          {"v1", "sdot1 + R1^T omega1~ r1"},
          {"v2", "sdot1 + R1^T (omega1~ (q2 + s2) + sdot2) + R2^T omega2~ r2"},
          {"v3", "sdot1 + R1^T (omega1~ (q2 + s2) + sdot2) + R2^T (omega2~ (q3 + s3) + sdot3) + R3^T omega3~ r3"},
          {"v4", "sdot1 + R1^T (omega1~ (q2 + s2) + sdot2) + R2^T (omega2~ (q4 + s4) + sdot4) + R4^T omega4~ r4"},
          {"v5", "sdot1 + R1^T (omega1~ (q5 + s5) + sdot5) + R5^T omega5~ r5"},
          {"v6", "sdot1 + R1^T (omega1~ (q5 + s5) + sdot5) + R5^T (omega5~ (q6 + s6) + sdot6) + R6^T omega6~ r6"}}));
}

TEST_P(TablesTest, partial_angular_velocities_are_the_identity_and_their_rates_zero) {
  Rows expected;
  for (const std::string k : {"1", "2", "3", "4", "5", "6"}) expected.push_back({"omega" + k + ",omega" + k, "1"});
  EXPECT_THAT(rows("Partial angular velocities"), ElementsAreArray(expected));
  EXPECT_THAT(rows("Time derivatives of the partial angular"), ElementsAreArray(Rows{{"all", "0"}}));
}

TEST_P(TablesTest, partial_velocities_block_by_block) {
  EXPECT_THAT(rows("Partial velocities"), ElementsAreArray(Rows{{"v1,omega1", "-R1^T r1~"},
                                                                {"v1,sdot1", "1"},
                                                                {"v2,omega1", "-R1^T (q2~ + s2~)"},
                                                                {"v2,omega2", "-R2^T r2~"},
                                                                {"v2,sdot1", "1"},
                                                                {"v2,sdot2", "R1^T"},
                                                                {"v3,omega1", "-R1^T (q2~ + s2~)"},
                                                                {"v3,omega2", "-R2^T (q3~ + s3~)"},
                                                                {"v3,omega3", "-R3^T r3~"},
                                                                {"v3,sdot1", "1"},
                                                                {"v3,sdot2", "R1^T"},
                                                                {"v3,sdot3", "R2^T"},
                                                                {"v4,omega1", "-R1^T (q2~ + s2~)"},
                                                                {"v4,omega2", "-R2^T (q4~ + s4~)"},
                                                                {"v4,omega4", "-R4^T r4~"},
                                                                {"v4,sdot1", "1"},
                                                                {"v4,sdot2", "R1^T"},
                                                                {"v4,sdot4", "R2^T"},
                                                                {"v5,omega1", "-R1^T (q5~ + s5~)"},
                                                                {"v5,omega5", "-R5^T r5~"},
                                                                {"v5,sdot1", "1"},
                                                                {"v5,sdot5", "R1^T"},
                                                                {"v6,omega1", "-R1^T (q5~ + s5~)"},
                                                                {"v6,omega5", "-R5^T (q6~ + s6~)"},
                                                                {"v6,omega6", "-R6^T r6~"},
                                                                {"v6,sdot1", "1"},
                                                                {"v6,sdot5", "R1^T"},
                                                                {"v6,sdot6", "R5^T"}}));
}

TEST_P(TablesTest, partial_velocity_rates_block_by_block) {
  EXPECT_THAT(rows("Time derivatives of the partial velocities"),
              ElementsAreArray(Rows{{"d/dt v1,omega1", "-R1^T omega1~ r1~"},
                                    {"d/dt v2,omega1", "-R1^T (omega1~ (q2~ + s2~) + sdot2~)"},
                                    {"d/dt v2,omega2", "-R2^T omega2~ r2~"},
                                    {"d/dt v2,sdot2", "R1^T omega1~"},
                                    {"d/dt v3,omega1", "-R1^T (omega1~ (q2~ + s2~) + sdot2~)"},
                                    {"d/dt v3,omega2", "-R2^T (omega2~ (q3~ + s3~) + sdot3~)"},
                                    {"d/dt v3,omega3", "-R3^T omega3~ r3~"},
                                    {"d/dt v3,sdot2", "R1^T omega1~"},
                                    {"d/dt v3,sdot3", "R2^T omega2~"},
                                    {"d/dt v4,omega1", "-R1^T (omega1~ (q2~ + s2~) + sdot2~)"},
                                    {"d/dt v4,omega2", "-R2^T (omega2~ (q4~ + s4~) + sdot4~)"},
                                    {"d/dt v4,omega4", "-R4^T omega4~ r4~"},
                                    {"d/dt v4,sdot2", "R1^T omega1~"},
                                    {"d/dt v4,sdot4", "R2^T omega2~"},
                                    {"d/dt v5,omega1", "-R1^T (omega1~ (q5~ + s5~) + sdot5~)"},
                                    {"d/dt v5,omega5", "-R5^T omega5~ r5~"},
                                    {"d/dt v5,sdot5", "R1^T omega1~"},
                                    {"d/dt v6,omega1", "-R1^T (omega1~ (q5~ + s5~) + sdot5~)"},
                                    {"d/dt v6,omega5", "-R5^T (omega5~ (q6~ + s6~) + sdot6~)"},
                                    {"d/dt v6,omega6", "-R6^T omega6~ r6~"},
                                    {"d/dt v6,sdot5", "R1^T omega1~"},
                                    {"d/dt v6,sdot6", "R5^T omega5~"}}));
}

TEST_P(TablesTest, partial_velocities_one_matrix_a_body) {
  EXPECT_THAT(rows("Partial velocities, one matrix a body"),
              ElementsAreArray(Rows{{"[v1,y1]", "[-R1^T r1~, 0, 0, 0, 0, 0]"},
                                    {"[v1,y2]", "[1, 0, 0, 0, 0, 0]"},
                                    {"[v2,y1]", "[-R1^T (q2~ + s2~), -R2^T r2~, 0, 0, 0, 0]"},
                                    {"[v2,y2]", "[1, R1^T, 0, 0, 0, 0]"},
                                    {"[v3,y1]", "[-R1^T (q2~ + s2~), -R2^T (q3~ + s3~), -R3^T r3~, 0, 0, 0]"},
                                    {"[v3,y2]", "[1, R1^T, R2^T, 0, 0, 0]"},
                                    {"[v4,y1]", "[-R1^T (q2~ + s2~), -R2^T (q4~ + s4~), 0, -R4^T r4~, 0, 0]"},
                                    {"[v4,y2]", "[1, R1^T, 0, R2^T, 0, 0]"},
                                    {"[v5,y1]", "[-R1^T (q5~ + s5~), 0, 0, 0, -R5^T r5~, 0]"},
                                    {"[v5,y2]", "[1, 0, 0, 0, R1^T, 0]"},
                                    {"[v6,y1]", "[-R1^T (q5~ + s5~), 0, 0, 0, -R5^T (q6~ + s6~), -R6^T r6~]"},
                                    {"[v6,y2]", "[1, 0, 0, 0, R1^T, R5^T]"}}));
}

TEST_P(TablesTest, partial_velocity_rates_one_matrix_a_body) {
  const Rows all = rows("Time derivatives of the partial velocities, one matrix a body");
  ASSERT_EQ(all.size(), 12u);
  EXPECT_EQ(all[4], Row("[d/dt v3,y1]",
                        "[-R1^T (omega1~ (q2~ + s2~) + sdot2~), -R2^T (omega2~ (q3~ + s3~) + sdot3~), "
                        "-R3^T omega3~ r3~, 0, 0, 0]"));
  EXPECT_EQ(all[5], Row("[d/dt v3,y2]", "[0, R1^T omega1~, R2^T omega2~, 0, 0, 0]"));
}

TEST_P(TablesTest, partial_angular_velocities_one_matrix_a_body) {
  const Rows all = rows("Partial angular velocities, one matrix a body");
  ASSERT_EQ(all.size(), 12u);
  EXPECT_EQ(all[4], Row("[omega3,y1]", "[0, 0, 1, 0, 0, 0]"));
  EXPECT_EQ(all[5], Row("[omega3,y2]", "[0, 0, 0, 0, 0, 0]"));
}

TEST_P(TablesTest, equations_of_motion_are_kanes) {
  EXPECT_THAT(rows("Equations of motion"),
              ElementsAreArray(Rows{
                  {"A ydot", "f"},
                  {"A", "sum_K (m_K v_K,y^T v_K,y + omega_K,y^T I_K omega_K,y)"},
                  {"f", "sum_K v_K,y^T (F_K - m_K (d/dt v_K,y) y) + sum_K omega_K,y^T (M_K - omega_K~ I_K omega_K)"},
                  {"r", "A ydot - f"}}));
}

// Oracle: A and f of two bodies, multiplied out by hand from v_1 = (-R1^T r1~, 0; 1, 0), v_2 = (-R1^T d2~, -R2^T r2~;
// 1, R1^T) with d2 = q2 + s2, C1_2 = R1 R2^T, h1 = m1 r1 + m2 d2, h2 = m2 r2, J the inertia of what a body carries
// about its origin.
TEST(Tables, blocks_of_a_and_f_of_two_bodies) {
  const std::vector<Table> all = tables(symbolic::derive(scene::from_connection({0, 1})), Style::text);
  ASSERT_EQ(all.size(), 17u);
  EXPECT_THAT(all[15].rows, UnorderedElementsAreArray(Rows{{"A[omega1, omega1]", "J1"},
                                                           {"A[omega1, omega2]", "-d2~ C1_2 h2~"},
                                                           {"A[omega1, sdot1]", "h1~ R1"},
                                                           {"A[omega1, sdot2]", "m2 d2~"},
                                                           {"A[omega2, omega2]", "J2"},
                                                           {"A[omega2, sdot1]", "h2~ R2"},
                                                           {"A[omega2, sdot2]", "h2~ C1_2^T"},
                                                           {"A[sdot1, sdot1]", "m_sub1"},
                                                           {"A[sdot1, sdot2]", "m2 R1^T"},
                                                           {"A[sdot2, sdot2]", "m2"},
                                                           {"d2", "q2 + s2"},
                                                           {"C1_2", "R1 R2^T"},
                                                           {"h1", "m1 r1 + m2 d2"},
                                                           {"h2", "m2 r2"},
                                                           {"J1", "-m1 r1~ r1~ + I1 - m2 d2~ d2~"},
                                                           {"J2", "-m2 r2~ r2~ + I2"},
                                                           {"m_sub1", "m1 + m2"}}));
  EXPECT_THAT(all[16].rows, UnorderedElementsAreArray(Rows{{"d2", "q2 + s2"},
                                                           {"Pddot1", "-g"},
                                                           {"U1", "omega1~ omega1~"},
                                                           {"U2", "omega2~ omega2~"},
                                                           {"a1", "R1^T U1 r1 + Pddot1"},
                                                           {"Pddot2", "R1^T omega1~ (omega1~ d2 + 2 sdot2) + Pddot1"},
                                                           {"a2", "R2^T U2 r2 + Pddot2"},
                                                           {"G1", "-m1 a1 + F1"},
                                                           {"N1", "-omega1~ I1 omega1 + M1"},
                                                           {"G2", "-m2 a2 + F2"},
                                                           {"N2", "-omega2~ I2 omega2 + M2"},
                                                           {"f_omega2", "r2~ R2 G2 + N2"},
                                                           {"f_sdot2", "R1 G2"},
                                                           {"f_omega1", "r1~ R1 G1 + d2~ R1 G2 + N1"},
                                                           {"S1", "G1 + G2"},
                                                           {"f_sdot1", "S1"}}));
}

TEST(Tables, text_holds_every_row_of_every_table) {
  const symbolic::Equations equations = symbolic::derive(scene::from_connection({0, 0, 2}));
  const std::string text = text_document(equations);
  for (const Table& table : tables(equations, Style::text)) {
    EXPECT_THAT(text, testing::HasSubstr("\n" + table.title + "\n"));
    for (const auto& [left, right] : table.rows)
      EXPECT_THAT(text, testing::HasSubstr("  " + left + " = " + right + "\n"));
  }
}

// --- whole and without contradiction, whatever the scene

const Table& table_of(const std::vector<Table>& all, const std::string& title) {
  for (const Table& table : all)
    if (table.title.rfind(title, 0) == 0) return table;
  throw std::runtime_error("no table " + title);
}

std::vector<symbolic::Equations> samples() {
  const symbolic::Way as_typed{{.place_origins = false, .regroup = false, .turn_axes = false}};
  std::vector<symbolic::Equations> all;
  for (const std::filesystem::path& file : test::shipped_scenes())
    if (const scene::Scene scene = scene::read(file); size(scene) < 40)
      all.push_back(symbolic::derive(scene, {}, as_typed));
  for (int seed = 0; seed < 30; ++seed)
    all.push_back(symbolic::derive(test::scene_with_rough_names(seed), {}, as_typed));
  return all;
}

TEST(Tables, f_has_a_row_a_speed_in_the_order_of_y) {
  const std::string body = "name = 'one'\nconnection = [0]\n[inputs]\nu = 0\n[[body]]\nmass = 2\ninertia = [1, 1, 1]\n";
  const scene::Scene scene = scene::parse(body + "force = [0, 0, 'u']\n", "one.toml");
  const std::vector<Table> all = tables(symbolic::derive(scene), Style::text);
  EXPECT_THAT(table_of(all, "f, with").rows,
              ElementsAreArray(Rows{{"N1", "-omega1~ I1 omega1"}, {"f_omega1", "N1"}, {"f_sdot1", "F1"}}));
  const std::vector<Table> still = tables(symbolic::derive(scene::parse(body, "one.toml")), Style::text);
  EXPECT_THAT(table_of(still, "f, with").rows.back(), Row("f_sdot1", "0"));
  for (const symbolic::Equations& equations : samples()) {
    if (equations.speeds.empty()) continue;
    int n_rows = 0;
    const std::vector<Table> tables = emit::tables(equations, Style::text);
    for (const Row& row : table_of(tables, "f, with").rows) n_rows += row.first.rfind("f_", 0) == 0;
    EXPECT_GE(n_rows, static_cast<int>(equations.speeds.size())) << equations.scene.name;
  }
}

TEST(Tables, state_vectors_have_a_semicolon_between_two_parts_alone) {
  const auto x = [](const char* model) {
    const symbolic::Equations equations =
        symbolic::derive(scene::read(std::string(KANEC_SOURCE_DIR "/models/") + model + "/scene.toml"));
    return table_of(tables(equations, Style::text), "State").rows[0].second;
  };
  EXPECT_EQ(x("pendulum"), "(theta1)");
  EXPECT_EQ(x("cart_pole"), "(theta2; s1)");
  EXPECT_EQ(x("hard/contact"), "(s1)");
}

TEST(Tables, a_left_side_has_one_right_side) {
  for (const symbolic::Equations& equations : samples())
    for (const Style style : {Style::text, Style::latex}) {
      std::map<std::string, std::string> known;
      for (const Table& table : tables(equations, style))
        for (const auto& [left, right] : table.rows) {
          EXPECT_NE(left, right) << equations.scene.name;
          if (left == "A\\dot y" || left == "A ydot" || left == "f" || left == "A" || left == "r") continue;
          EXPECT_EQ(known.emplace(left, right).first->second, right) << equations.scene.name << ": " << left;
        }
    }
}

// The words of a row that are quantities, without what stands for transposes and skew matrices.
std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> result = {""};
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '\'')
      result.back() += c;
    else if (!result.back().empty())
      result.emplace_back();
  }
  return result;
}

TEST(Tables, every_quantity_that_is_shown_is_told) {
  for (const symbolic::Equations& equations : samples()) {
    std::set<std::string> quantities, told;
    for (const symbolic::Quantity& quantity : equations.quantities) {
      const symbolic::Symbol& symbol = equations.table.of(quantity.symbol);
      quantities.insert((symbol.is_transpose ? equations.table.of(symbol.transpose).name : symbol.name) +
                        symbol.suffix);
    }
    // a number of the scene may have the name of a quantity, which then has a prime
    for (const symbolic::Symbol& symbol : equations.table.all())
      if (symbol.role != symbolic::Role::quantity) quantities.erase(symbol.name + symbol.suffix);
    const std::vector<Table> all = tables(equations, Style::text);
    for (const Table& table : all)
      for (const auto& [left, right] : table.rows) {
        told.insert(words(left).front());
        if (const std::size_t equal = right.find(" = "); equal != std::string::npos)
          told.insert(right.substr(0, equal));
      }
    for (const Table& table : all) {
      if (table.title == "Equations of motion") continue;
      for (const auto& [left, right] : table.rows)
        for (const std::string& word : words(right))
          EXPECT_TRUE(quantities.count(word) == 0 || told.count(word) > 0)
              << equations.scene.name << ": " << word << " in " << left << " = " << right;
    }
  }
}

}  // namespace
}  // namespace kanec::emit
