// Every device that is reached by a network or a socket, fed with its twin's bytes: whole, cut anywhere,
// spoilt, of another version.
#include "tests/drivers/device_kinds.h"

#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "idl/message.h"
#include "tests/drivers/fed_port.h"

namespace prosector {
namespace {

constexpr std::int64_t period_ns = 10'000'000;
const Pose place{{0.2, 1.1, -0.3}, Quat(0.9, 0.2, -0.1, 0.3).normalized()};
const Pose other_place{{-0.1, 1.7, -0.2}, Quat(0.7, -0.2, 0.5, 0.1).normalized()};
const Pose stand{{0, 0.9, 0}, Quat(Eigen::AngleAxisd(0.4, Vec3::UnitY()))};

/// A device that stands at `stand`, played by its twin in the test's time.
class Fed {
 public:
  explicit Fed(const DeviceKind& kind, std::optional<FaultSpan> wrong_version = std::nullopt) {
    TrackerTwinOptions options;
    options.script.add(0, 0, place);
    options.script.add(1, 0, other_place);
    options.room_device = stand;
    options.stations = 2;
    options.wrong_version = wrong_version;
    twin = kind.twin(options, now_ns);
    DeviceConfig config;
    config.placement.room_device = stand;
    config.placement.stations = 3;
    device = kind.device(std::make_unique<FedPort>(feed), config);
    poll();
  }

  Feed feed;
  std::int64_t now_ns = 1;
  std::unique_ptr<Twin> twin;
  std::unique_ptr<Device> device;
  std::vector<DeviceSample> samples;

  std::vector<std::uint8_t> next_bytes() { return sent_bytes(*twin, feed, now_ns += period_ns); }
  void poll() { device->poll(samples); }
  void give(std::span<const std::uint8_t> bytes) {
    feed.to_driver.insert(feed.to_driver.end(), bytes.begin(), bytes.end());
    poll();
  }
  /// Goes on, whole, until so many samples came or it takes too long.
  bool streams(std::size_t count) {
    for (int step = 0; step < 2000 && samples.size() < count; ++step) {
      const int openings = feed.openings;
      give(next_bytes());
      if (!feed.open) std::this_thread::sleep_for(std::chrono::milliseconds(5));
      if (feed.openings != openings) twin->reset_client();
    }
    return samples.size() >= count;
  }
};

class EachKind : public testing::TestWithParam<DeviceKind> {};

TEST_P(EachKind, TellsWhereItsStationsAreInTheRoom) {
  Fed fed(GetParam());
  ASSERT_TRUE(fed.streams(20)) << fed.device->status().message;
  std::array<std::uint64_t, 2> records{};
  for (const DeviceSample& s : fed.samples) {
    ASSERT_LT(s.station, 2u);
    const Pose& expected = s.station == 0 ? place : other_place;
    EXPECT_LT((s.pose.p - expected.p).norm(), 1e-6);
    EXPECT_NEAR(std::abs(s.pose.q.dot(expected.q)), 1, 1e-6);
    EXPECT_EQ(s.record, records[s.station]++);
    EXPECT_GT(s.time_ns, 0);
  }
  EXPECT_GT(records[1], 0u);
  EXPECT_EQ(fed.device->status().health, DeviceHealth::streaming);
  EXPECT_EQ(fed.device->status().resyncs, 0u);
}

TEST_P(EachKind, ReadsTheSameWhereverItsBytesAreCut) {
  Fed whole(GetParam()), cut(GetParam());
  std::mt19937 random(3);
  for (int step = 0; step < 200; ++step) {
    whole.give(whole.next_bytes());
    const auto bytes = cut.next_bytes();
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t piece = std::min(bytes.size() - at, static_cast<std::size_t>(1 + random() % 40));
      cut.give(std::span(bytes).subspan(at, piece));
      at += piece;
    }
  }
  ASSERT_GT(whole.samples.size(), 100u);
  ASSERT_EQ(cut.samples.size(), whole.samples.size());
  for (std::size_t i = 0; i < cut.samples.size(); ++i) {
    EXPECT_EQ(cut.samples[i].station, whole.samples[i].station);
    EXPECT_EQ(cut.samples[i].raw_pose, whole.samples[i].raw_pose);
  }
}

TEST_P(EachKind, AnotherVersionIsSaidAndTheRightOneComesBack) {
  Fed fed(GetParam(), FaultSpan{0, 0.05});
  for (int step = 0; step < 4; ++step) fed.give(fed.next_bytes());
  EXPECT_TRUE(fed.samples.empty());
  EXPECT_EQ(fed.device->status().health, DeviceHealth::babbling);
  EXPECT_NE(fed.device->status().message.find("version"), std::string::npos) << fed.device->status().message;
  EXPECT_TRUE(fed.streams(20)) << fed.device->status().message;
  EXPECT_EQ(fed.device->status().health, DeviceHealth::streaming);
}

TEST_P(EachKind, SpoiltBytesMakeNoImplausibleSamplesAndGoodOnesComeBack) {
  std::mt19937 random(5);
  std::uint64_t spoilt = 0;
  for (int round = 0; round < 300; ++round) {
    Fed fed(GetParam());
    for (int step = 0; step < 12 && fed.feed.open; ++step) {
      auto bytes = fed.next_bytes();
      for (std::uint32_t k = random() % 4; k > 0 && !bytes.empty(); --k) {
        const std::size_t at = random() % bytes.size();
        switch (random() % 3) {
          case 0:
            bytes[at] = static_cast<std::uint8_t>(random());
            break;
          case 1:
            bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                         static_cast<std::uint8_t>(random()));
            break;
          default:
            bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
        }
      }
      fed.give(bytes);
    }
    for (const DeviceSample& s : fed.samples) {
      ASSERT_LT(s.station, max_stations);
      ASSERT_TRUE(s.pose.p.allFinite() && s.pose.p.norm() < 200);
      ASSERT_NEAR(s.pose.q.norm(), 1, 1e-6);
      for (const double f : s.flexion) ASSERT_TRUE(f >= 0 && f <= 1);
    }
    const DeviceStatus status = fed.device->status();
    spoilt += status.resyncs + (status.health == DeviceHealth::babbling ? 1 : 0);
    if (round % 50 != 0) continue;
    EXPECT_TRUE(fed.streams(fed.samples.size() + 8)) << status.message;
  }
  EXPECT_GT(spoilt, 10u);
}

TEST_P(EachKind, AFloodOfAnythingIsSurvived) {
  std::mt19937 random(7);
  Fed fed(GetParam());
  std::vector<std::uint8_t> flood(65536);
  for (int k = 0; k < 20; ++k) {
    for (auto& byte : flood) byte = static_cast<std::uint8_t>(random());
    fed.give(flood);
  }
  fed.samples.clear();
  fed.feed.open = false;  // the plug is pulled
  fed.poll();
  fed.twin->reset_client();
  EXPECT_TRUE(fed.streams(10)) << fed.device->status().message;
}

INSTANTIATE_TEST_SUITE_P(Devices, EachKind, testing::ValuesIn(device_kinds()),
                         [](const auto& kind) { return kind.param.name; });

TEST(VrpnDevice, ButtonsChannelsAndDialsReachTheHand) {
  Feed feed;
  GloveConfig glove;
  glove.calibration = GloveCalibration{};
  glove.calibration->open = {0, 0, 0, 0, 0};
  glove.calibration->closed = {1, 1, 1, 2, -1};
  VrpnDevice device("Hand0", std::make_unique<FedPort>(feed), {}, {}, glove);
  std::vector<DeviceSample> samples;
  device.poll(samples);
  vrpn::Bytes bytes = vrpn::cookie();
  vrpn::put(bytes, vrpn::naming(vrpn::names_sender, 2, "Hand0"));
  vrpn::put(bytes, vrpn::naming(vrpn::names_sender, 3, "Other"));
  const std::array<const char*, 4> types = {vrpn::pose_type, vrpn::button_type, vrpn::analog_type,
                                            vrpn::dial_type};
  for (std::int32_t t = 0; t < 4; ++t)
    vrpn::put(bytes, vrpn::naming(vrpn::names_type, t, types[static_cast<std::size_t>(t)]));
  vrpn::put(bytes, {3, 1, vrpn::body_of(vrpn::Button{5, true})});  // not this device's
  vrpn::put(bytes, {2, 1, vrpn::body_of(vrpn::Button{2, true})});
  vrpn::put(bytes, {2, 2, vrpn::body_of(vrpn::Channels{0.25, 0.5, 2, 1, -1, 99})});
  vrpn::put(bytes, {2, 3, vrpn::body_of(vrpn::Dial{0, 0.5})});
  vrpn::put(bytes, {2, 0, vrpn::body_of(vrpn::TrackerPose{0, Vec3(1, 2, 3), Quat::Identity()})});
  vrpn::put(bytes, {2, 0, vrpn::body_of(vrpn::TrackerPose{0, Vec3(1, 2, 3), Quat(9, 0, 0, 0)})});
  feed.to_driver = bytes;
  device.poll(samples);
  ASSERT_EQ(samples.size(), 3u);
  EXPECT_EQ(samples[0].flexion, (std::array<double, fingers>{0.25, 0.5, 1, 0.5, 1}));
  EXPECT_EQ(samples[1].flexion[0], 0.75);
  EXPECT_EQ(samples[2].buttons, 4u);
  EXPECT_EQ(samples[2].pose.p, Vec3(1, 2, 3));
  EXPECT_EQ(device.status().resyncs, 1u) << "what is no quaternion";
}

TEST(IgtlBytes, AreTheProtocols) {
  igtl::Bytes bytes;
  igtl::put(bytes, {igtl::transform_type, "Probe",
                    igtl::transform_body({"", Vec3(0.001, 0, -0.002), Mat3::Identity()})});
  ASSERT_EQ(bytes.size(), 58u + 48u);
  EXPECT_EQ(igtl::Bytes(bytes.begin(), bytes.begin() + 2), (igtl::Bytes{0, 1}));
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(&bytes[2])), "TRANSFORM");
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(&bytes[14])), "Probe");
  EXPECT_EQ(igtl::Bytes(bytes.begin() + 42, bytes.begin() + 50), (igtl::Bytes{0, 0, 0, 0, 0, 0, 0, 48}));
  EXPECT_EQ(igtl::Bytes(bytes.begin() + 58 + 36, bytes.begin() + 58 + 40), (igtl::Bytes{0x3f, 0x80, 0, 0}))
      << "1 mm";
}

/// A second header before the content and words about it behind, as version 2 has them.
TEST(IgtlBytes, SecondHeadersAndLargeStrangersArePassedOver) {
  const igtl::Tool tool{"Probe", Vec3(0.1, 0.2, 0.3), Mat3::Identity()};
  igtl::Message message{igtl::transform_type, "Probe", {0, 12, 0, 2, 0, 0, 0, 3, 0, 0, 0, 1}};
  const auto content = igtl::transform_body(tool);
  message.body.insert(message.body.end(), content.begin(), content.end());
  message.body.insert(message.body.end(), 5, 7);
  igtl::Bytes stream;
  igtl::put(stream, {"IMAGE", "CT", igtl::Bytes(200000, 1)});
  igtl::put(stream, message, 2);
  igtl::Reader reader;
  std::vector<igtl::Message> read;
  for (std::size_t at = 0; at < stream.size(); at += 1000) {
    reader.take(std::span(stream).subspan(at, std::min<std::size_t>(1000, stream.size() - at)));
    while (const auto next = reader.next()) read.push_back(*next);
  }
  ASSERT_EQ(read.size(), 1u) << reader.problem();
  const auto back = igtl::transform_of(read[0]);
  ASSERT_TRUE(back);
  EXPECT_LT((back->place - tool.place).norm(), 1e-7);
}

TEST(IgtlDevice, WrongChecksumsCountForNothing) {
  Feed feed;
  TrackerTwinOptions options;
  options.bad_checksum_fraction = 0.3;
  IgtlTwin twin(options, 1);
  IgtlDevice device({"Tool1"}, std::make_unique<FedPort>(feed), {});
  std::vector<DeviceSample> samples;
  device.poll(samples);
  for (int step = 1; step <= 100; ++step) {
    feed.to_driver = sent_bytes(twin, feed, step * period_ns);
    device.poll(samples);
  }
  EXPECT_GT(samples.size(), 50u);
  EXPECT_LT(samples.size(), 90u);
  EXPECT_EQ(samples.size() + device.status().resyncs, 100u);
}

}  // namespace
}  // namespace prosector
