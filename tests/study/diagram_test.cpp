// The diagram of lines in a logarithmic plane. Oracle: what it must show by its own rules.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/diagram.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "runtime/picture/svg.hpp"

namespace kanec::cli::test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string tick(double value) { return "at " + std::to_string(std::lround(std::log10(value))); }

// Tenfold steps in both directions, and points that have no place.
Diagram diagram() {
  return {"speed & error",
          {"a note"},
          {"error [-]", tick},
          {"time [s]", tick},
          {{"first", {{1e-3, 1e-2, "<one>", true}, {1e-4, 1e-1, "two", true}, {1e-5, 1.0, "three", false}}},
           {"second", {{0.0, 1.0, "zero", true}, {NAN, 1.0, "none", false}, {1e-4, INFINITY, "far", false}}}},
          3e-5,
          "not known"};
}

std::vector<std::array<double, 2>> circles(const std::string& picture) {
  std::vector<std::array<double, 2>> list;
  const std::regex circle("<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\"");
  for (std::sregex_iterator at(picture.begin(), picture.end(), circle), end; at != end; ++at)
    list.push_back({std::stod((*at)[1]), std::stod((*at)[2])});
  return list;
}

TEST(Diagram, a_tenfold_value_is_the_same_step_everywhere) {
  const auto at = circles(diagram_svg(diagram()));
  ASSERT_EQ(at.size(), 4u);                                    // three points, and one in the legend
  EXPECT_NEAR(at[1][0] - at[0][0], at[2][0] - at[1][0], 0.2);  // one decimal each
  EXPECT_NEAR(at[1][1] - at[0][1], at[2][1] - at[1][1], 0.2);
  EXPECT_LT(at[1][0], at[0][0]);  // smaller to the left
  EXPECT_LT(at[1][1], at[0][1]);  // larger above
}

TEST(Diagram, names_everything_and_needs_nothing) {
  const std::string picture = diagram_svg(diagram());
  for (const char* word : {"speed &amp; error", "a note", "error [-]", "time [s]", "first", "second", "&lt;one&gt;",
                           "not known", "Pareto front", "at -5", "at -2"})
    EXPECT_THAT(picture, HasSubstr(word));
  for (const char* foreign : {"href", "url(", "<script", "@import", "nan", "inf"})
    EXPECT_THAT(picture, Not(HasSubstr(foreign)));
}

TEST(Diagram, joins_the_front_alone) {
  const std::string picture = diagram_svg(diagram());
  const auto at = circles(picture);
  const auto begin = picture.find("class=\"front\" points=\"");
  ASSERT_NE(begin, std::string::npos);
  const std::string places = picture.substr(begin + 22, picture.find('"', begin + 22) - begin - 22);
  EXPECT_EQ(std::count(places.begin(), places.end(), ','), 2);
  EXPECT_EQ(std::stod(places), at[0][0]);  // the fastest first
}

TEST(Diagram, of_nothing_is_still_a_picture) {
  EXPECT_THAT(diagram_svg({"", {}, {"x", tick}, {"y", tick}, {}, 0.0, ""}), testing::EndsWith("</svg>\n"));
}

TEST(DurationText, has_the_unit_that_fits) {
  EXPECT_EQ(duration_text(85e-9), "85 ns");
  EXPECT_EQ(duration_text(1.24e-6), "1.24 µs");
  EXPECT_EQ(duration_text(0.9999), "1 s");
  EXPECT_EQ(duration_text(25.0), "25 s");
}

}  // namespace
}  // namespace kanec::cli::test
