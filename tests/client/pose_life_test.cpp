// How long a tracked pose counts after it was seen.

#include <gtest/gtest.h>

#include <vector>

#include "client/app/user/pose_validity.h"

namespace prosector {
namespace {

constexpr std::int64_t ms = 1'000'000, start = 5'000 * ms;

/// Returns for how long the last pose counts, in steps of 10 ms, where it was seen after these gaps, and each
/// was known after `delay`. All is in ms.
std::int64_t life_after(const std::vector<std::int64_t>& gaps, std::int64_t delay = 0) {
  PoseValidity life;
  std::int64_t now = start;
  life.see(now, now + delay * ms);
  for (const std::int64_t gap : gaps) {
    now += gap * ms;
    life.see(now, now + delay * ms);
  }
  std::int64_t lasts = 0;
  while (!life.is_over(now + (lasts + 10) * ms)) lasts += 10;
  return lasts;
}

TEST(PoseValidity, IsAQuarterOfASecondWherePosesComeInTime) {
  for (const std::int64_t gap : {4, 17, 33, 67, 100}) EXPECT_EQ(life_after({gap, gap, gap}), 250) << gap;
  EXPECT_EQ(life_after({}), 250);
}

TEST(PoseValidity, WaitsForTheNextPictureWherePicturesTakeLong) {
  for (const std::int64_t gap : {150, 200, 300, 390}) EXPECT_GE(life_after({gap, gap}), 2 * gap);
  EXPECT_EQ(life_after({1000, 1000}), 1000) << "never longer than a second";
}

TEST(PoseValidity, WaitsForTheNextPictureWhereItTakesLongToBeEvaluated) {
  for (const std::int64_t gap : {33, 67, 200, 267})
    for (const std::int64_t delay : {100, 300, 450}) {
      const std::int64_t next = gap + delay;  // ms: when the next pose is known
      EXPECT_GE(life_after({gap, gap}, delay), next + gap / 2)
          << "a gap of " << gap << ", a delay of " << delay;
    }
  EXPECT_EQ(life_after({33, 33}, 5000), 1000) << "never longer than a second";
}

TEST(PoseValidity, DoesNotGrowByOneLoss) {
  EXPECT_EQ(life_after({33, 33, 900}), 250);
  EXPECT_EQ(life_after({33, 900, 33}), 250);
}

TEST(PoseValidity, IsOverForWhatWasNeverSeen) {
  EXPECT_TRUE(PoseValidity().is_over(start));
  EXPECT_EQ(PoseValidity().seen_ns(), 0);
}

TEST(PoseValidity, TakesNoPoseFromBefore) {
  PoseValidity life;
  life.see(start, start);
  life.see(start - 100 * ms, start);
  EXPECT_EQ(life.seen_ns(), start);
}

}  // namespace
}  // namespace prosector
