// The chart of times. Oracle: what it must show by its own rules.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "runtime/bench/contest_chart.hpp"
#include "runtime/bench/contest_text.hpp"

namespace kanec::test {
namespace {

using testing::HasSubstr;
using testing::Not;

// Ten times as long each; the last one without a time.
Contest contest() {
  Entry emitted{"residual", "emitted"}, generic{"residual", "generic"}, slow{"residual", "slow"},
      none{"residual", "none"};
  emitted.time = Time{100.0, 90.0};
  generic.time = Time{1000.0, 900.0};
  slow.time = Time{10000.0, 9000.0};
  slow.note = "not what it could be";
  none.note = "not modelled: a <screw> & more";
  return {"arm", "0123456789abcdef", {emitted, generic, slow, none}};
}

std::vector<double> widths(const std::string& picture) {
  std::vector<double> list;
  const std::regex bar("<rect x=\"[0-9.]+\" y=\"[0-9.]+\" width=\"([0-9.]+)\"");
  for (std::sregex_iterator at(picture.begin(), picture.end(), bar), end; at != end; ++at)
    list.push_back(std::stod((*at)[1]));
  return list;
}

TEST(Chart, a_tenfold_time_is_the_same_step_longer_everywhere) {
  const std::vector<double> bars = widths(chart({contest()}, {"a processor", "a compiler"}));
  ASSERT_EQ(bars.size(), 3u);
  EXPECT_NEAR(bars[2] - bars[1], bars[1] - bars[0], 0.2);  // one decimal each
  EXPECT_GT(bars[1], bars[0]);
}

TEST(Chart, names_everything_and_needs_nothing) {
  const std::string picture = chart({contest()}, {"a processor", "a compiler"});
  for (const char* word : {"arm: residual", "emitted", "generic", "100 ns", "1 µs, 10 times", "10 µs, 100 times",
                           "not modelled: a &lt;screw&gt; &amp; more", "a processor", "a compiler", "logarithmic"})
    EXPECT_THAT(picture, HasSubstr(word));
  for (const char* foreign : {"href", "url(", "<script", "@import"}) EXPECT_THAT(picture, Not(HasSubstr(foreign)));
}

TEST(Chart, of_nothing_is_still_a_picture) { EXPECT_THAT(chart({}, {}), testing::EndsWith("</svg>\n")); }

TEST(ContestText, tells_ratios_to_the_first_and_why_there_is_no_time) {
  const std::string table = text(contest());
  EXPECT_THAT(table, HasSubstr("1000.0 ns   10.00"));
  EXPECT_THAT(table, HasSubstr("not modelled: a <screw> & more"));
  EXPECT_EQ(footnotes({contest(), contest()}), "slow: not what it could be\n");
}

}  // namespace
}  // namespace kanec::test
