// Lines and conditions that would flood a terminal, and figures as people read them.

#include "common/repeated_line_filter.h"

#include <gtest/gtest.h>

#include "common/percent_text.h"
#include "common/rate_limited_flag.h"

namespace prosector {
namespace {

TEST(RepeatedLineFilter, LetOneOfAKindThroughAndCountTheOthers) {
  RepeatedLineFilter lines(10);
  EXPECT_EQ(lines.admit("knife was torn away by 80 N", 0), "knife was torn away by 80 N");
  EXPECT_EQ(lines.admit("Ada: right hand let go", 0), "Ada: right hand let go") << "another kind";
  for (int k = 1; k < 100; ++k)
    EXPECT_FALSE(lines.admit("knife was torn away by " + std::to_string(k) + " N", 0.1 * k));
  EXPECT_EQ(lines.admit("knife was torn away by 7 N", 10), "knife was torn away by 7 N (and 99 similar)");
  EXPECT_EQ(lines.admit("knife was torn away by 7 N", 30), "knife was torn away by 7 N");
}

TEST(RateLimitedFlag, IsReportedAtOnceAndAFlickeringOneOnceAnInterval) {
  RateLimitedFlag state(30);
  EXPECT_FALSE(state.look(false, 0));
  EXPECT_EQ(state.look(true, 1), true);
  EXPECT_EQ(state.look(false, 1.1), false);
  int reports = 0;
  for (int k = 0; k < 290; ++k) reports += state.look(k % 2 == 0, 1.2 + 0.1 * k) ? 1 : 0;
  EXPECT_EQ(reports, 0);
  EXPECT_EQ(state.look(true, 31.5), true) << "what it is by then";
  EXPECT_FALSE(state.look(true, 40));
  EXPECT_EQ(state.look(false, 41), false);
}

TEST(PercentText, HasTwoDigitsAndNoExponent) {
  EXPECT_EQ(percent_text(0), "0 %");
  EXPECT_EQ(percent_text(1e-9), "less than 0.001 %");
  EXPECT_EQ(percent_text(0.0003), "0.03 %");
  EXPECT_EQ(percent_text(0.021), "2.1 %");
  EXPECT_EQ(percent_text(0.06), "6 %");
  EXPECT_EQ(percent_text(0.3456), "35 %");
  EXPECT_EQ(percent_text(0.996), "100 %");
  EXPECT_EQ(percent_text(1.1), "110 %");
  EXPECT_EQ(percent_text(123.4), "12340 %");
  for (const double unknown : {-1., 1.1, 1e9, 0. / 0.}) EXPECT_FALSE(is_known_error(unknown)) << unknown;
  EXPECT_TRUE(is_known_error(0) && is_known_error(1));
}

}  // namespace
}  // namespace prosector
