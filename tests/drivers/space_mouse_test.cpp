// A SpaceMouse moves a hand by speed, presses its buttons, and survives what is no record.
#include "drivers/trackers/space_mouse.h"

#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "tests/drivers/fed_port.h"
#include "twins/trackers/space_mouse_twin.h"

namespace prosector {
namespace {

TEST(SpaceMouse, MovesTheHandAsFarAsItsTwinWants) {
  const Vec3 from(0, 1.2, 0.3), way(0.05, -0.08, 0.03);
  TrackerTwinOptions options;
  options.script.add(0, 0, {from, Quat::Identity()});
  options.script.add(0, 1, {from + way, Quat::Identity()});
  Feed feed;
  SpaceMouse device(std::make_unique<FedPort>(feed), {});
  SpaceMouseTwin twin(options, monotonic_ns());
  std::vector<DeviceSample> samples;
  const std::int64_t end = monotonic_ns() + 1'500'000'000;
  while (monotonic_ns() < end) {
    const auto bytes = sent_bytes(twin, feed, monotonic_ns());
    feed.to_driver.insert(feed.to_driver.end(), bytes.begin(), bytes.end());
    device.poll(samples);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ASSERT_GT(samples.size(), 20u);
  const Vec3 moved = samples.back().pose.p - samples.front().pose.p;
  EXPECT_LT((moved - way).norm(), 0.02) << moved.transpose();
  EXPECT_EQ(device.status().health, DeviceHealth::streaming);
}

TEST(SpaceMouse, ButtonsAndGarbage) {
  Feed feed;
  SpaceMouse device(std::make_unique<FedPort>(feed), {});
  std::vector<DeviceSample> samples;
  device.poll(samples);
  std::mt19937 random(3);
  for (int k = 0; k < 2000; ++k) feed.to_driver.push_back(static_cast<std::uint8_t>(random() | 0x80));
  device.poll(samples);
  EXPECT_EQ(device.status().health, DeviceHealth::babbling);
  EXPECT_EQ(device.status().records, 0u);
  feed.to_driver.resize(40, 0xff);
  for (const auto kind : {space_mouse::press, space_mouse::release}) {
    space_mouse::Record record;
    record.kind = kind;
    record.button = 3;
    const auto bytes = space_mouse::encode(record);
    feed.to_driver.insert(feed.to_driver.end(), bytes.begin(), bytes.end());
    std::this_thread::sleep_for(std::chrono::milliseconds(15));
    device.poll(samples);
    ASSERT_FALSE(samples.empty());
    EXPECT_EQ(samples.back().buttons, kind == space_mouse::press ? 8u : 0u);
  }
  for (const DeviceSample& s : samples) {
    EXPECT_TRUE(s.pose.p.allFinite() && s.pose.p.norm() < 3);
    EXPECT_NEAR(s.pose.q.norm(), 1, 1e-9);
  }
}

}  // namespace
}  // namespace prosector
