#include <gtest/gtest.h>

#include "drivers/five_dt_record.h"
#include "drivers/gesture.h"
#include "drivers/glove_hand.h"

namespace prosector {
namespace {

TEST(FiveDtRecord, PacketAndReportRoundTrip) {
  const five_dt::Counts counts = {0, 50, 128, 200, 255};
  for (const bool left : {false, true}) {
    auto packet = five_dt::encode_packet(counts, 7, 9, left);
    EXPECT_EQ(packet[1], left ? 255 : 0);
    EXPECT_EQ(five_dt::decode_packet(packet, left), counts);
    packet[3] ^= 1;
    EXPECT_FALSE(five_dt::decode_packet(packet, left));
  }
  const five_dt::Counts words = {800, 900, 1000, 1300, 4095};
  const auto report = five_dt::encode_report(words);
  EXPECT_EQ(report[0], 800 >> 8);
  EXPECT_EQ(report[6], 900 >> 8);
  EXPECT_EQ(five_dt::decode_report(report), words);
}

// /dev/zero, and what else reads as zeros, is no glove.
TEST(FiveDtRecord, AReportOfZerosIsNone) {
  five_dt::Report report{};
  EXPECT_FALSE(five_dt::decode_report(report));
  report[3] = 1;
  EXPECT_TRUE(five_dt::decode_report(report));
}

TEST(Calibration, WidensAndGuardsAgainstNoSpan) {
  FlexionCalibrator calibrator(DeviceConfig{}, 16);
  EXPECT_EQ(calibrator.update({100, 100, 100, 100, 100})[0], 0);
  EXPECT_EQ(calibrator.update({110, 100, 100, 100, 100})[0], 0);
  EXPECT_EQ(calibrator.update({200, 100, 100, 100, 100})[0], 1);
  EXPECT_DOUBLE_EQ(calibrator.update({150, 100, 100, 100, 100})[0], 0.5);
}

TEST(Calibration, FixedCountsMayFall) {
  DeviceConfig config;
  config.calibration = GloveCalibration{{1300, 1300, 1300, 1300, 1300}, {800, 800, 800, 800, 800}};
  FlexionCalibrator calibrator(config, 16);
  EXPECT_DOUBLE_EQ(calibrator.update({1050, 1300, 800, 2000, 0})[0], 0.5);
  const auto flexion = calibrator.update({1050, 1300, 800, 2000, 0});
  EXPECT_EQ(flexion[1], 0);
  EXPECT_EQ(flexion[2], 1);
  EXPECT_EQ(flexion[3], 0);
  EXPECT_EQ(flexion[4], 1);
}

std::array<double, fingers> fingers_of(int open, double thumb) {
  std::array<double, fingers> flexion{thumb, 1, 1, 1, 1};
  for (std::size_t i = 1; i < fingers; ++i)
    if ((open >> (i - 1) & 1) != 0) flexion[i] = 0;
  return flexion;
}

TEST(Gestures, EveryPatternHasItsRow) {
  for (int open = 0; open < 16; ++open) {
    Gesture expected = Gesture::none;
    for (const GestureRow& row : gesture_table())
      if (row.open_fingers == open) expected = row.gesture;
    for (const double thumb : {0.0, 1.0}) {
      GestureDetector detector({0.65, 0.35, 0.05, false});
      EXPECT_EQ(detector.update(fingers_of(open, thumb)), expected) << open;
    }
  }
}

TEST(Gestures, NamesAreUnique) {
  for (const GestureRow& row : gesture_table()) {
    ASSERT_NE(find_gesture(row.name), nullptr);
    EXPECT_EQ(find_gesture(row.name)->gesture, row.gesture);
    EXPECT_STREQ(gesture_name(row.gesture), row.name);
  }
}

TEST(Gestures, NoneBetweenAndHysteresisAtTheEdge) {
  GestureDetector detector({0.65, 0.35, 0.05, false});
  EXPECT_EQ(detector.update({0, 0.62, 1, 1, 1}), Gesture::none);
  EXPECT_EQ(detector.update({0, 0.66, 1, 1, 1}), Gesture::fist);
  EXPECT_EQ(detector.update({0, 0.62, 1, 1, 1}), Gesture::fist);
  EXPECT_EQ(detector.update({0, 0.59, 1, 1, 1}), Gesture::none);
}

TEST(Gestures, PinchOnlyWhenAsked) {
  GestureDetector with({0.65, 0.35, 0.05, true}), without({0.65, 0.35, 0.05, false});
  EXPECT_EQ(with.update({1, 1, 0, 0, 0}), Gesture::pinch);
  EXPECT_EQ(without.update({1, 1, 0, 0, 0}), Gesture::none);
}

}  // namespace
}  // namespace prosector
