#include <gtest/gtest.h>

#include "drivers/device/gesture.h"
#include "drivers/gloves/glove_hand.h"
#include "drivers/protocols/five_dt_record.h"
#include "tests/gesture_bends.h"

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
  FlexionCalibrator calibrator(GloveConfig{}, 16);
  EXPECT_EQ(calibrator.update({100, 100, 100, 100, 100})[0], 0);
  EXPECT_EQ(calibrator.update({110, 100, 100, 100, 100})[0], 0);
  EXPECT_EQ(calibrator.update({200, 100, 100, 100, 100})[0], 1);
  EXPECT_DOUBLE_EQ(calibrator.update({150, 100, 100, 100, 100})[0], 0.5);
}

TEST(Calibration, FixedCountsMayFall) {
  GloveConfig glove;
  glove.calibration = GloveCalibration{{1300, 1300, 1300, 1300, 1300}, {800, 800, 800, 800, 800}};
  FlexionCalibrator calibrator(glove, 16);
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

/// Returns what the table says of these fingers, by the words above it.
Gesture expected_gesture(int open, bool thumb_open, bool pinch) {
  Gesture out = Gesture::none;
  for (const ThumbRequirement need :
       {ThumbRequirement::any, thumb_open ? ThumbRequirement::open : ThumbRequirement::bent})
    for (const GestureRow& row : gesture_table())
      if (row.open_fingers == open && row.thumb == need && (pinch || !row.requires_pinch_option))
        out = row.gesture;
  return out;
}

TEST(Gestures, EveryPatternHasItsRow) {
  for (int open = 0; open < 16; ++open)
    for (const double thumb : {0.0, 0.3, 0.4, 0.6, 1.0})
      for (const bool pinch : {false, true}) {
        GestureDetector detector({0.65, 0.35, 0.05, pinch});
        EXPECT_EQ(detector.update(fingers_of(open, thumb)), expected_gesture(open, thumb < 0.35, pinch))
            << open << " thumb " << thumb;
      }
}

// What people make is told of any row, however the fingers come there.
TEST(Gestures, OfTheWholeTableFollowEachOther) {
  GestureDetector detector({0.65, 0.35, 0.05, true});
  for_gestures([&](const GestureRow& from) {
    for_gestures([&](const GestureRow& to) {
      EXPECT_EQ(detector.update(bends_of(from)), from.gesture) << from.name;
      std::array<double, fingers> half{};
      for (std::size_t f = 0; f < fingers; ++f) half[f] = (bends_of(from)[f] + bends_of(to)[f]) / 2;
      (void)detector.update(half);
      EXPECT_EQ(detector.update(bends_of(to)), to.gesture) << from.name << " to " << to.name;
    });
  });
}

TEST(Gestures, HaveRowsThatDiffer) {
  for_gestures([&](const GestureRow& a) {
    for_gestures([&](const GestureRow& b) {
      EXPECT_EQ(a.open_fingers == b.open_fingers && a.thumb == b.thumb, a.gesture == b.gesture) << a.name;
    });
  });
}

TEST(Gestures, WithoutAThumbAreThoseOfTheSameFingers) {
  EXPECT_EQ(without_thumb(Gesture::none), Gesture::none);
  for_gestures([](const GestureRow& row) {
    const GestureRow* plain = find_gesture(gesture_name(without_thumb(row.gesture)));
    EXPECT_EQ(plain->open_fingers, row.open_fingers) << row.name;
    EXPECT_EQ(plain->gesture == row.gesture, row.thumb == ThumbRequirement::any || row.requires_pinch_option)
        << row.name;
  });
  EXPECT_EQ(without_thumb(Gesture::thumb_up), Gesture::fist);
  EXPECT_EQ(without_thumb(Gesture::thumb_index), Gesture::point);
  EXPECT_EQ(without_thumb(Gesture::four), Gesture::flat);
}

// Every gesture through both gloves' records and their counts.
TEST(Gestures, ComeOutOfEachGlovesRecords) {
  for (const bool usb : {false, true}) {
    const double open = usb ? 800 : 0, closed = usb ? 1300 : 255;
    GestureThresholds thresholds;
    thresholds.pinch = true;
    GloveConfig glove;
    glove.calibration = GloveCalibration{};
    glove.calibration->open.fill(open);
    glove.calibration->closed.fill(closed);
    GloveHand hand(thresholds, glove, 16);
    for_gestures([&](const GestureRow& row) {
      five_dt::Counts counts{};
      for (std::size_t f = 0; f < fingers; ++f)
        counts[f] = static_cast<std::uint16_t>(open + bends_of(row)[f] * (closed - open));
      const auto read = usb ? five_dt::decode_report(five_dt::encode_report(counts))
                            : five_dt::decode_packet(five_dt::encode_packet(counts, 0, 0, false), false);
      ASSERT_TRUE(read);
      EXPECT_EQ(hand.sample(*read, 0).gesture, row.gesture) << row.name;
    });
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
  EXPECT_EQ(detector.update({1, 0.62, 1, 1, 1}), Gesture::none);
  EXPECT_EQ(detector.update({1, 0.66, 1, 1, 1}), Gesture::fist);
  EXPECT_EQ(detector.update({1, 0.62, 1, 1, 1}), Gesture::fist);
  EXPECT_EQ(detector.update({1, 0.59, 1, 1, 1}), Gesture::none);
}

TEST(Gestures, PinchOnlyWhenAsked) {
  GestureDetector with({0.65, 0.35, 0.05, true}), without({0.65, 0.35, 0.05, false});
  EXPECT_EQ(with.update({1, 1, 0, 0, 0}), Gesture::pinch);
  EXPECT_EQ(with.update({0, 1, 0, 0, 0}), Gesture::none) << "the thumb is away";
  EXPECT_EQ(without.update({1, 1, 0, 0, 0}), Gesture::none);
}

}  // namespace
}  // namespace prosector
