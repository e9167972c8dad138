// How long a tracked pose counts after it was seen.

#include <gtest/gtest.h>

#include <vector>

#include "client/app/pose_life.h"

namespace prosector {
namespace {

constexpr std::int64_t ms = 1'000'000, start = 5'000 * ms;

/// Returns for how long the last pose counts, in steps of 10 ms, where it was seen after these gaps.
std::int64_t life_after(const std::vector<std::int64_t>& gaps) {
  PoseLife life;
  std::int64_t now = start;
  life.see(now);
  for (const std::int64_t gap : gaps) life.see(now += gap * ms);
  std::int64_t lasts = 0;
  while (!life.is_over(now + (lasts + 10) * ms)) lasts += 10;
  return lasts;
}

TEST(PoseLife, IsAQuarterOfASecondWherePosesComeInTime) {
  for (const std::int64_t gap : {4, 17, 33, 67, 100}) EXPECT_EQ(life_after({gap, gap, gap}), 250) << gap;
  EXPECT_EQ(life_after({}), 250);
}

TEST(PoseLife, WaitsForTheNextPictureWherePicturesTakeLong) {
  for (const std::int64_t gap : {150, 200, 300, 390})
    EXPECT_GE(life_after({gap, gap}), 2 * gap) << "the next one's way through networks takes as long again";
  EXPECT_EQ(life_after({1000, 1000}), 1000) << "never longer than a second";
}

TEST(PoseLife, DoesNotGrowByOneLoss) {
  EXPECT_EQ(life_after({33, 33, 900}), 250);
  EXPECT_EQ(life_after({33, 900, 33}), 250);
}

TEST(PoseLife, IsOverForWhatWasNeverSeen) {
  EXPECT_TRUE(PoseLife().is_over(start));
  EXPECT_EQ(PoseLife().seen_ns(), 0);
}

TEST(PoseLife, TakesNoPoseFromBefore) {
  PoseLife life;
  life.see(start);
  life.see(start - 100 * ms);
  EXPECT_EQ(life.seen_ns(), start);
}

}  // namespace
}  // namespace prosector
