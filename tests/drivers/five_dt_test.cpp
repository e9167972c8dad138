// Drivers of 5DT gloves, fed with bytes as public drivers accept them.
#include "drivers/gloves/five_dt.h"

#include <gtest/gtest.h>

#include <random>

#include "drivers/protocols/five_dt_record.h"
#include "tests/drivers/fed_port.h"
#include "twins/trackers/five_dt_twin.h"

namespace prosector {
namespace {

using GloveBytes = std::vector<std::uint8_t>;

void add_bytes(GloveBytes& out, std::span<const std::uint8_t> bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

/// Fixed counts from 0 to `closed`.
GloveConfig glove_config(double closed) {
  GloveConfig out;
  out.calibration = GloveCalibration{};
  out.calibration->closed.fill(closed);
  return out;
}

template <class Glove>
struct FedGlove {
  explicit FedGlove(double closed, bool left = false) : config(glove_config(closed)) {
    config.left = left;
    device = std::make_unique<Glove>(std::make_unique<FedPort>(feed), GestureThresholds{}, config);
    device->poll(samples);
  }
  void give(const GloveBytes& bytes) {
    feed.to_driver = bytes;
    device->poll(samples);
  }

  Feed feed;
  GloveConfig config;
  std::unique_ptr<Glove> device;
  std::vector<DeviceSample> samples;
};

TEST(FiveDtWireless, PacketsAreReadWhereverTheyAreCut) {
  const five_dt::Counts first = {0, 51, 102, 153, 255}, second = {255, 0, 0, 0, 128};
  for (const bool left : {false, true}) {
    GloveBytes stream = {7, 0x80, 3};  // the end of a packet that began before
    add_bytes(stream, five_dt::encode_wireless(first, 128, 128, left));
    add_bytes(stream, five_dt::encode_wireless(second, 128, 128, left));
    for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
      FedGlove<FiveDtWirelessGlove> fed(255, left);
      fed.give({stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(cut)});
      fed.give({stream.begin() + static_cast<std::ptrdiff_t>(cut), stream.end()});
      ASSERT_EQ(fed.samples.size(), 2u) << cut;
      EXPECT_EQ(fed.samples[0].raw_flexion, first);
      EXPECT_EQ(fed.samples[1].raw_flexion, second);
      EXPECT_EQ(fed.device->status().message, "");
      EXPECT_TRUE(fed.feed.from_driver.empty()) << "it hears nothing: nothing is sent";
    }
  }
}

TEST(FiveDtWireless, WithoutASumTheOrderOfPacketsTells) {
  FedGlove<FiveDtWirelessGlove> fed(255);
  GloveBytes packet = {0x80, 10, 20, 30, 40, 50, 0x80, 0x80, 0x99, 0x01}, stream;
  for (int k = 0; k < 5; ++k) add_bytes(stream, packet);
  fed.give(stream);
  ASSERT_EQ(fed.samples.size(), 4u) << "the first one is believed once another follows";
  EXPECT_EQ(fed.samples[3].raw_flexion, (five_dt::Counts{10, 20, 30, 40, 50}));
}

TEST(FiveDtWireless, AGloveOfTheOtherHandIsSaid) {
  FedGlove<FiveDtWirelessGlove> fed(255, false);
  GloveBytes packet;
  add_bytes(packet, five_dt::encode_wireless({1, 2, 3, 4, 5}, 0, 0, true));
  fed.give(packet);
  EXPECT_NE(fed.device->status().message.find("is a left glove"), std::string::npos)
      << fed.device->status().message;
}

TEST(FiveDtWireless, TheTwinSpeaksUnasked) {
  FiveDtTwinOptions options;
  options.script.add(0, 0, std::array<double, fingers>{0, 0, 1, 1, 1});
  options.wireless = true;
  FiveDtTwin twin(options, 1);
  FedGlove<FiveDtWirelessGlove> fed(255);
  for (std::int64_t k = 1; k <= 20; ++k) fed.give(sent_bytes(twin, fed.feed, 10'000'000 * k));
  ASSERT_GE(fed.samples.size(), 19u);
  EXPECT_EQ(fed.samples.back().flexion, (std::array<double, fingers>{0, 0, 1, 1, 1}));
}

TEST(FiveDtWireless, GarbageIsCounted) {
  std::mt19937 random(9);
  FedGlove<FiveDtWirelessGlove> fed(255);
  GloveBytes bytes(10000);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() % 0x80);
  fed.give(bytes);
  EXPECT_TRUE(fed.samples.empty());
  EXPECT_EQ(fed.device->status().health, DeviceHealth::babbling);
}

// Public drivers read ten bytes from some gloves with a cable: the answer to the reset comes again behind
// each packet.
TEST(FiveDtSerial, AByteBehindEachPacketIsNoGarbage) {
  FedGlove<FiveDtSerialGlove> fed(255);
  GloveBytes stream = {five_dt::reset_answer};
  for (int k = 0; k < 5; ++k) {
    add_bytes(stream, five_dt::encode_packet({10, 20, 30, 40, 50}, 128, 128, false));
    stream.push_back(0x55);
  }
  fed.give(stream);
  EXPECT_EQ(fed.samples.size(), 5u);
  EXPECT_EQ(fed.device->status().resyncs, 0u);
}

// Other drivers look at no word but the fingers'.
TEST(FiveDtUsb, OtherWordsMayHoldAnything) {
  FedGlove<FiveDtUsbGlove> fed(4095);
  five_dt::Report report;
  report.fill(0xee);
  const five_dt::Counts counts = {800, 900, 1000, 1300, 4095};
  const auto fingers_alone = five_dt::encode_report(counts);
  for (std::size_t i = 0; i < fingers; ++i)
    for (const std::size_t byte : {6 * i, 6 * i + 1}) report[byte] = fingers_alone[byte];
  fed.give({report.begin(), report.end()});
  ASSERT_EQ(fed.samples.size(), 1u);
  EXPECT_EQ(fed.samples[0].raw_flexion, counts);
}

TEST(FiveDtUsb, AfterABadReportFingersStayInTheirWords) {
  FedGlove<FiveDtUsbGlove> fed(4095);
  auto bad = five_dt::encode_report({0xffff, 900, 1000, 1100, 1200});
  GloveBytes stream(bad.begin(), bad.end());
  const five_dt::Counts counts = {800, 900, 1000, 1100, 1200};
  for (int k = 0; k < 4; ++k) add_bytes(stream, five_dt::encode_report(counts));
  fed.give(stream);
  ASSERT_EQ(fed.samples.size(), 4u);
  for (const DeviceSample& sample : fed.samples) EXPECT_EQ(sample.raw_flexion, counts);
  EXPECT_EQ(fed.device->status().resyncs, 1u);
}

}  // namespace
}  // namespace prosector
