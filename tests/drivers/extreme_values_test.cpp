// Numbers that no device means, to every driver of the table: each is dropped and counted, and none becomes a
// hand that isn't turned.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>

#include "common/error.h"
#include "drivers/camera/devices/camera_samples.h"
#include "drivers/device/driver_table.h"
#include "drivers/device/plausible.h"
#include "drivers/gloves/five_dt.h"
#include "drivers/protocols/fastrak_record.h"
#include "drivers/protocols/five_dt_record.h"
#include "drivers/recordings/recorded.h"
#include "drivers/trackers/igtl_device.h"
#include "drivers/trackers/leap_device.h"
#include "drivers/trackers/space_mouse.h"
#include "drivers/trackers/vrpn_device.h"
#include "tests/drivers/fed_port.h"
#include "twins/trackers/leap_twin.h"

namespace prosector {
namespace {

using Limits = std::numeric_limits<double>;
constexpr std::array extremes = {1e308, -1e308, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()};

/// A pose's numbers, x y z then a quaternion w x y z, one of them spoilt or all of the quaternion.
struct Spoilt {
  std::array<double, 7> numbers{0.1, 0.2, 0.3, 1, 0, 0, 0};
  Vec3 position() const { return {numbers[0], numbers[1], numbers[2]}; }
  Quat rotation() const { return {numbers[3], numbers[4], numbers[5], numbers[6]}; }
};
std::vector<Spoilt> spoilt_poses() {
  std::vector<Spoilt> out;
  for (const double extreme : extremes) {
    for (std::size_t i = 0; i < 7; ++i) out.emplace_back().numbers[i] = extreme;
    std::fill_n(out.emplace_back().numbers.begin() + 3, 4, extreme);
  }
  for (const double short_one : {0., Limits::denorm_min(), 1e-200, 1e-3})
    std::fill_n(out.emplace_back().numbers.begin() + 3, 4, short_one);
  return out;
}

/// What came out of a driver, and how much it counted as garbage.
struct Outcome {
  std::size_t samples = 0;
  std::uint64_t counted = 0;
};
using Feeder = std::function<Outcome(const Spoilt&)>;

Outcome outcome_of(Device& device) {
  std::vector<DeviceSample> samples;
  device.poll(samples);
  for (const DeviceSample& s : samples) EXPECT_TRUE(is_plausible(s));
  return {samples.size(), device.status().resyncs};
}
Outcome outcome_of(Feed& feed, Device& device, const std::vector<std::uint8_t>& bytes) {
  std::vector<DeviceSample> none;
  device.poll(none);
  feed.to_driver = bytes;
  return outcome_of(device);
}

Outcome from_fastrak(const Spoilt& spoilt) {
  std::vector<std::uint8_t> record = {'0', '1', ' '};
  for (const double number : spoilt.numbers) {
    const auto bytes = std::bit_cast<std::array<std::uint8_t, 4>>(static_cast<float>(number));
    record.insert(record.end(), bytes.begin(), bytes.end());
  }
  record.insert(record.end(), {'\r', '\n'});
  // What is no record is garbage to the driver.
  const bool read = fastrak::decode(record, {true, {2, 11, 1}}).has_value();
  return {read ? 1u : 0u, read ? 0u : 1u};
}

Outcome from_vrpn(const Spoilt& spoilt) {
  Feed feed;
  VrpnDevice device("Hand", std::make_unique<FedPort>(feed), {}, {}, {});
  vrpn::Bytes bytes = vrpn::cookie();
  vrpn::put(bytes, vrpn::naming(vrpn::names_sender, 1, "Hand"));
  vrpn::put(bytes, vrpn::naming(vrpn::names_type, 1, vrpn::pose_type));
  vrpn::put(bytes, {1, 1, vrpn::body_of(vrpn::TrackerPose{0, spoilt.position(), spoilt.rotation()})});
  return outcome_of(feed, device, bytes);
}

Outcome from_igtl(const Spoilt& spoilt) {
  Feed feed;
  IgtlDevice device({}, std::make_unique<FedPort>(feed), {});
  igtl::Tool tool{"", spoilt.position(), spoilt.numbers[3] * Mat3::Identity()};
  for (int i = 0; i < 3; ++i) tool.turn(i, (i + 1) % 3) = spoilt.numbers[static_cast<std::size_t>(4 + i)];
  igtl::Bytes bytes;
  igtl::put(bytes, {igtl::transform_type, "Probe", igtl::transform_body(tool)});
  return outcome_of(feed, device, bytes);
}

Outcome from_leap(const Spoilt& spoilt) {
  LeapDevice device("here", {}, {});
  leap::Text frame;
  frame.hands.push_back(simulated_hand(false, {{0.1, 0.2, 0.3}, Quat::Identity()}, {}));
  leap::Hand& hand = frame.hands.front();
  if (spoilt.position() != Spoilt{}.position()) {
    hand.wrist = hand.joints[1][2] = spoilt.position();
  } else {
    hand.direction = {spoilt.numbers[3], spoilt.numbers[4], spoilt.numbers[5]};
    if (spoilt.numbers[6] != 0) hand.palm_normal.x() = spoilt.numbers[6];
  }
  device.handle_text(leap::text_of(frame, 1));
  return outcome_of(device);
}

Outcome from_camera(const Spoilt& spoilt) {
  CameraSamples found;
  DeviceSample sample;
  sample.has_pose = true;
  sample.pose = {spoilt.position(), spoilt.rotation()};
  found.put(1, true, {&sample, 1});
  std::vector<DeviceSample> samples;
  CameraState camera;
  camera.is_open = true;
  camera.opened = 1;
  found.poll(camera, samples);
  return {samples.size(), found.status("", "").resyncs};
}

Outcome from_recorded(const Spoilt& spoilt) {
  const auto file =
      std::filesystem::temp_directory_path() / fmt::format("prosector-extreme-{}.csv", getpid());
  std::ofstream out(file);
  out << "time,x,y,z,qw,qx,qy,qz\n0";
  for (const double number : spoilt.numbers) out << fmt::format(",{}", number);
  out.close();
  Outcome found;
  try {
    found.samples = load_recording(file).size();
  } catch (const InputError&) {
    found.counted = 1;  // a file is refused as a whole, with the line
  }
  std::filesystem::remove(file);
  return found;
}

/// Counts have no infinities: a cap that is pushed beyond its range is none.
Outcome from_space_mouse(const Spoilt& spoilt) {
  Feed feed;
  SpaceMouse device(std::make_unique<FedPort>(feed), {});
  space_mouse::Record record;
  for (std::size_t i = 0; i < 6; ++i)
    record.push[i] = spoilt.numbers[i] < 0 ? std::numeric_limits<std::int32_t>::min()
                                           : std::numeric_limits<std::int32_t>::max();
  const auto bytes = space_mouse::encode(record);
  return {0, outcome_of(feed, device, {bytes.begin(), bytes.end()}).counted};
}

/// Gloves send counts: the largest are no more than a closed hand, and what can't be counts is garbage.
template <class Glove>
Outcome from_glove(const std::vector<std::uint8_t>& bytes) {
  Feed feed;
  Glove device(std::make_unique<FedPort>(feed), {}, {});
  if constexpr (std::is_same_v<Glove, FiveDtSerialGlove>) {
    std::vector<DeviceSample> none;
    device.poll(none);
    feed.to_driver = {five_dt::reset_answer};
    device.poll(none);
    feed.to_driver = bytes;
    return outcome_of(device);
  }
  return outcome_of(feed, device, bytes);
}

const std::map<std::string, Feeder>& feeders() {
  static const std::map<std::string, Feeder> all = {
      {"fastrak", from_fastrak},
      {"vrpn", from_vrpn},
      {"igtl", from_igtl},
      {"leap", from_leap},
      {"spacemouse", from_space_mouse},
      {"tags", from_camera},  // the same check at the way out
      {"hands", from_camera},
      {"face", from_camera},
      {"recorded", from_recorded},
      {"recorded-loop", from_recorded},
      {"5dt",
       [](const Spoilt&) {
         return from_glove<FiveDtSerialGlove>({0x80, 255, 255, 255, 255, 255, 255, 255, 0});
       }},
      {"5dt-wireless",
       [](const Spoilt&) {
         return from_glove<FiveDtWirelessGlove>({0x80, 255, 255, 255, 255, 255, 255, 255, 0, 0xff});
       }},
      {"5dt-usb",
       [](const Spoilt&) { return from_glove<FiveDtUsbGlove>(std::vector<std::uint8_t>(64, 0xff)); }},
  };
  return all;
}

TEST(ExtremeValues, AreDroppedAndCountedByEveryDriver) {
  for (const DriverRow& row : drivers()) {
    ASSERT_TRUE(feeders().contains(row.name)) << row.name << " has no test of extreme values";
    for (const Spoilt& spoilt : spoilt_poses()) {
      const Outcome outcome = feeders().at(row.name)(spoilt);
      EXPECT_EQ(outcome.samples, 0u) << row.name << ": " << fmt::format("{}", fmt::join(spoilt.numbers, " "));
      EXPECT_GT(outcome.counted, 0u) << row.name << ": " << fmt::format("{}", fmt::join(spoilt.numbers, " "));
    }
  }
}

TEST(ExtremeValues, GoodPosesPassWhereBadOnesDoNot) {
  for (const char* name : {"fastrak", "vrpn", "igtl", "leap", "tags", "recorded"})
    EXPECT_EQ(feeders().at(name)({}).samples, 1u) << name;
}

TEST(ExtremeValues, ChannelsAndDialsAreBounded) {
  for (const double extreme : extremes)
    for (const bool dial : {false, true}) {
      Feed feed;
      GloveConfig glove;
      glove.calibration = GloveCalibration{};
      glove.calibration->closed.fill(1);
      VrpnDevice device("Hand", std::make_unique<FedPort>(feed), {}, {}, glove);
      vrpn::Bytes bytes = vrpn::cookie();
      vrpn::put(bytes, vrpn::naming(vrpn::names_sender, 1, "Hand"));
      vrpn::put(bytes, vrpn::naming(vrpn::names_type, 1, dial ? vrpn::dial_type : vrpn::analog_type));
      vrpn::put(
          bytes,
          {1, 1, dial ? vrpn::body_of(vrpn::Dial{0, extreme}) : vrpn::body_of(vrpn::Channels{0.5, extreme})});
      const Outcome outcome = outcome_of(feed, device, bytes);
      EXPECT_EQ(outcome.samples, 0u);
      EXPECT_EQ(outcome.counted, 1u);
    }
}

TEST(ExtremeValues, BendsAreFromOpenToClosed) {
  DeviceSample sample;
  sample.has_flexion = true;
  EXPECT_TRUE(is_plausible(sample));
  for (const double extreme : {1e308, -1e-3, 1.001, Limits::infinity(), Limits::quiet_NaN()}) {
    sample.flexion[3] = extreme;
    EXPECT_FALSE(is_plausible(sample)) << extreme;
  }
}

TEST(ExtremeValues, ForcesAreBoundedAndKeepTheirDirection) {
  EXPECT_EQ(bounded_force({1, 2, 2}, 3.3), Vec3(1, 2, 2));
  EXPECT_LT((bounded_force({1e308, 0, 0}, 3.3) - Vec3(3.3, 0, 0)).norm(), 1e-12);
  EXPECT_LE(bounded_force(Vec3::Constant(1e308), 3.3).norm(), 3.3 + 1e-12);
  EXPECT_EQ(bounded_force({0, Limits::infinity(), 0}, 3.3), Vec3::Zero());
  EXPECT_EQ(bounded_force({0, 0, Limits::quiet_NaN()}, 3.3), Vec3::Zero());
}

}  // namespace
}  // namespace prosector
