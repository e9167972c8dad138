// The rhythm of a headset's frames.

#include "client/xr/frame_pacing.h"

#include <gtest/gtest.h>

namespace prosector {
namespace {

constexpr std::int64_t frame_ms = 1'000'000;

TEST(FramePacing, CountsWhatWentByWithoutAFrame) {
  FramePacing pacing;
  EXPECT_EQ(pacing.interval_ms(), 0);
  // The wait is over a little late now and then; what is seen is at whole periods of 11 ms, but for 0.4 ms.
  pacing.take(0, 100 * frame_ms, 11 * frame_ms);
  pacing.take(12 * frame_ms, 111 * frame_ms, 11 * frame_ms);
  pacing.take(22 * frame_ms, 122 * frame_ms + 400'000, 11 * frame_ms);
  EXPECT_EQ(pacing.missed(), 0u);
  pacing.take(55 * frame_ms, 155 * frame_ms, 11 * frame_ms);
  EXPECT_EQ(pacing.missed(), 2u);
  EXPECT_EQ(pacing.in_time(), 2u);
  EXPECT_EQ(pacing.frames(), 4u);
  EXPECT_DOUBLE_EQ(pacing.period_ms(), 11);
  EXPECT_DOUBLE_EQ(pacing.interval_ms(), 55.0 / 3);
  EXPECT_DOUBLE_EQ(pacing.longest_ms(), 33);
}

TEST(FramePacing, CountsNoTimeInWhichThereWasNoRhythm) {
  FramePacing pacing;
  pacing.take(0, 100 * frame_ms, 20 * frame_ms);
  pacing.pause();
  pacing.take(900 * frame_ms, 1000 * frame_ms, 20 * frame_ms);
  EXPECT_EQ(pacing.missed(), 0u);
  EXPECT_EQ(pacing.interval_ms(), 0);
  pacing.take(920 * frame_ms, 1020 * frame_ms, 20 * frame_ms);
  EXPECT_DOUBLE_EQ(pacing.interval_ms(), 20);
  EXPECT_EQ(pacing.frames(), 3u);
}

TEST(FramePacing, MissesNothingWhereTheRuntimeTellsNoPeriod) {
  FramePacing pacing;
  for (std::int64_t k = 0; k < 4; ++k) pacing.take(k * 30 * frame_ms, k * 30 * frame_ms, 0);
  EXPECT_EQ(pacing.missed(), 0u);
  EXPECT_DOUBLE_EQ(pacing.interval_ms(), 30);
}

}  // namespace
}  // namespace prosector
