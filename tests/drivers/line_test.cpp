// Drivers against their twins over real pseudo-terminals.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include "common/clock.h"
#include "drivers/config/device_config.h"
#include "drivers/device/driver_table.h"
#include "drivers/protocols/fastrak_record.h"
#include "tests/gesture_bends.h"
#include "twins/base/twin_server.h"
#include "twins/trackers/fastrak_twin.h"
#include "twins/trackers/five_dt_twin.h"

namespace prosector {
namespace {

/// A twin served in a thread on a link of its own.
class Line {
 public:
  Line(std::unique_ptr<Twin> twin, TwinServerOptions options) : twin_(std::move(twin)) {
    static int count = 0;
    link_ = (std::filesystem::temp_directory_path() /
             ("prosector-line-" + std::to_string(getpid()) + "-" + std::to_string(count++)))
                .string();
    options.link = link_;
    thread_ = std::thread([this, options] {
      serve_twin(*twin_, options, stop_, [this](const std::string&) { ready_ = true; });
    });
    while (!ready_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ~Line() {
    stop_ = true;
    thread_.join();
  }
  const std::string& link() const { return link_; }

 private:
  std::unique_ptr<Twin> twin_;
  std::string link_;
  std::atomic<bool> stop_ = false, ready_ = false;
  std::thread thread_;
};

using Samples = std::vector<DeviceSample>;

/// Polls until `done` or the time is over; true if done.
bool poll_until(Device& device, Samples& samples, double seconds, const std::function<bool()>& done) {
  const std::int64_t end = monotonic_ns() + static_cast<std::int64_t>(seconds * 1e9);
  while (monotonic_ns() < end) {
    device.poll(samples);
    if (done()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

const Pose hand{{0.2, 1.1, -0.3}, Quat(0.9, 0.2, -0.1, 0.3).normalized()};
const Pose head{{-0.1, 1.7, -0.2}, Quat(0.7, -0.2, 0.5, 0.1).normalized()};
const Pose transmitter{{0, 0.9, 0}, Quat(Eigen::AngleAxisd(0.4, Vec3::UnitY()))};

std::unique_ptr<Twin> tracker() {
  FastrakTwinOptions options;
  options.script.add(0, 0, hand);
  options.script.add(1, 0, head);
  options.room_device = transmitter;
  return std::make_unique<FastrakTwin>(options, monotonic_ns());
}

DeviceConfig tracker_config(bool binary) {
  DeviceConfig config;
  config.placement.room_device = transmitter;
  config.placement.stations = 3;
  config.fastrak.binary = binary;
  return config;
}

TEST(Line, FastrakReportsRoomPosesOfSeveralStations) {
  for (const bool binary : {true, false}) {
    Line line(tracker(), {});
    const auto device = open_device("fastrak:" + line.link(), tracker_config(binary));
    Samples samples;
    ASSERT_TRUE(poll_until(*device, samples, 5, [&] { return samples.size() >= 20; }))
        << device->status().message;
    for (const DeviceSample& s : samples) {
      const Pose& expected = s.station == 0 ? hand : head;
      EXPECT_TRUE(s.has_pose);
      EXPECT_LT((s.pose.p - expected.p).norm(), 2e-4);
      EXPECT_NEAR(std::abs(s.pose.q.dot(expected.q)), 1, 1e-6);
    }
    EXPECT_NE(samples[18].station, samples[19].station);
    EXPECT_EQ(device->status().health, DeviceHealth::streaming);
    EXPECT_EQ(device->status().resyncs, 0u);
  }
}

TEST(Line, FastrakSurvivesGarbage) {
  TwinServerOptions faults;
  faults.garbage = 0.3;
  Line line(tracker(), faults);
  const auto device = open_device("fastrak:" + line.link(), tracker_config(true));
  Samples samples;
  ASSERT_TRUE(poll_until(*device, samples, 8, [&] { return samples.size() >= 100; }));
  EXPECT_GT(device->status().resyncs, 0u);
  for (const DeviceSample& s : samples) EXPECT_LT((s.pose.p - (s.station == 0 ? hand : head).p).norm(), 1e-5);
}

TEST(Line, FaultsAreReportedAndHeal) {
  struct Case {
    const char* name;
    DeviceHealth health;
    TwinServerOptions faults;
  };
  std::array<Case, 3> cases = {{{"silence", DeviceHealth::silent, {}},
                                {"unplug", DeviceHealth::absent, {}},
                                {"babble", DeviceHealth::babbling, {}}}};
  cases[0].faults.silence = FaultSpan{1.5, 3.5};
  cases[1].faults.unplug = FaultSpan{1.5, 2.2};
  cases[2].faults.babble = FaultSpan{1.5, 3.0};
  for (const Case& c : cases) {
    Line line(tracker(), c.faults);
    const auto device = open_device("fastrak:" + line.link(), tracker_config(true));
    Samples samples;
    const auto is = [&](DeviceHealth health) {
      return [&, health] { return device->status().health == health; };
    };
    ASSERT_TRUE(poll_until(*device, samples, 1.4, is(DeviceHealth::streaming))) << c.name;
    ASSERT_TRUE(poll_until(*device, samples, 4, is(c.health))) << c.name;
    EXPECT_FALSE(device->status().message.empty());
    ASSERT_TRUE(poll_until(*device, samples, 6, is(DeviceHealth::streaming))) << c.name;
    const std::size_t before = samples.size();
    ASSERT_TRUE(poll_until(*device, samples, 2, [&] { return samples.size() > before + 10; })) << c.name;
  }
}

/// The first sample of each station that comes after `device` streams.
std::array<DeviceSample, 2> both_stations(Device& device) {
  Samples samples;
  EXPECT_TRUE(poll_until(device, samples, 5, [&] { return samples.size() >= 20; }))
      << device.status().message;
  std::array<DeviceSample, 2> out;
  for (const DeviceSample& s : samples) out.at(s.station) = s;
  return out;
}

void expect_near(const Pose& a, const Pose& b) {
  EXPECT_LT((a.p - b.p).norm(), 2e-4);
  EXPECT_NEAR(std::abs(a.q.dot(b.q)), 1, 1e-6);
}

// The tracker's own alignment: it reports in the frame given by the points O, X and Y (cm, +X forward, +Y
// right, +Z down), also after it was reset and set up again: the command is incremental, so the driver must
// undo it first.
TEST(Line, FastrakAlignsByItsOwnCommand) {
  TwinServerOptions options;
  options.unplug = FaultSpan{2.5, 2.8};
  Line line(tracker(), options);
  DeviceConfig config = tracker_config(true);
  config.fastrak.alignment = {10, 20, -5, 10, 30, -5, 0, 20, -5};  // X along the old Y, Y along the old −X
  const auto device = open_device("fastrak:" + line.link(), config);
  const Pose frame =
      fastrak::from_transmitter({{0.10, 0.20, -0.05}, Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()))});
  const auto check = [&] {
    for (const DeviceSample& s : both_stations(*device)) {
      const Pose& room = s.station == 0 ? hand : head;
      expect_near(s.pose, transmitter * (frame.inverse() * (transmitter.inverse() * room)));
    }
  };
  check();
  Samples none;
  ASSERT_TRUE(poll_until(*device, none, 5, [&] { return device->status().reopens > 0; }));
  check();
}

// Boresighted while it rests, each receiver reads no rotation, and the tracked thing stands as the tracker
// does.
TEST(Line, FastrakBoresightsWhenAsked) {
  Line line(tracker(), {});
  DeviceConfig config = tracker_config(true);
  config.fastrak.boresight = true;
  const auto device = open_device("fastrak:" + line.link(), config);
  for (const DeviceSample& s : both_stations(*device)) {
    const Pose& room = s.station == 0 ? hand : head;
    EXPECT_NEAR(std::abs(static_cast<double>(s.raw_pose[3])), 1, 1e-6);
    expect_near(s.pose, {room.p, transmitter.q});
  }
}

// The field has two solutions of opposite sign: the wrong hemisphere shows the mirrored position.
TEST(Line, FastrakHemisphereChoosesTheSide) {
  for (const double side : {1.0, -1.0}) {
    Line line(tracker(), {});
    DeviceConfig config = tracker_config(true);
    config.fastrak.hemisphere = side * fastrak::to_transmitter(transmitter.inverse() * hand).p;
    const auto device = open_device("fastrak:" + line.link(), config);
    const DeviceSample s = both_stations(*device)[0];
    const Vec3 seen = (transmitter.inverse() * hand).p;
    EXPECT_LT((s.pose.p - transmitter * Vec3(side * seen)).norm(), 2e-4);
  }
}

// raw_pose is what the device sent, to the last bit, so that measurements can match it with the device's own
// log.
TEST(Line, RawPosesAreTheTwinsLog) {
  for (const bool binary : {true, false}) {
    FastrakTwinOptions twin;
    twin.noise_cm = 0.5;  // so that no two records are alike
    twin.noise_deg = 1;
    twin.room_device = transmitter;
    twin.script.add(0, 0, hand);
    twin.script.add(1, 0, head);
    TwinServerOptions options;
    options.log =
        (std::filesystem::temp_directory_path() / ("prosector-raw-" + std::to_string(getpid()))).string();
    Samples samples;
    {
      Line line(std::make_unique<FastrakTwin>(twin, monotonic_ns()), options);
      const auto device = open_device("fastrak:" + line.link(), tracker_config(binary));
      ASSERT_TRUE(poll_until(*device, samples, 6, [&] { return samples.size() >= 100; }));
    }
    std::ifstream log(options.log);
    std::vector<std::pair<std::uint32_t, std::array<float, 7>>> sent;
    std::string text;
    std::getline(log, text);
    while (std::getline(log, text)) {
      std::istringstream line(text);
      std::vector<std::string> cells;
      for (std::string cell; std::getline(line, cell, ',');) cells.push_back(cell);
      if (cells.size() != 10) continue;  // before the output list was set
      std::array<float, 7> values;
      for (std::size_t k = 0; k < 7; ++k) values[k] = std::stof(cells[3 + k]);
      sent.emplace_back(static_cast<std::uint32_t>(std::stoul(cells[1]) - 1), values);
    }
    std::filesystem::remove(options.log);
    auto next = sent.begin();
    for (const DeviceSample& s : samples) {  // each in the log, in its order
      next = std::find(next, sent.end(), std::pair(s.station, s.raw_pose));
      ASSERT_NE(next, sent.end()) << "binary " << binary << ", record " << s.record << " of station "
                                  << s.station;
      ++next;
    }
    EXPECT_LE(static_cast<std::size_t>(next - sent.begin()), samples.size() + 2) << "records lost";
  }
}

TEST(Line, AbsentDeviceIsReportedNotThrown) {
  const auto device = open_device("fastrak:/nonexistent/tracker", {});
  Samples samples;
  device->poll(samples);
  EXPECT_EQ(device->status().health, DeviceHealth::absent);
  EXPECT_NE(device->status().message.find("/nonexistent/tracker"), std::string::npos);
}

TEST(Line, WhatReadsAsZerosStreamsNothing) {
  const auto device = open_device("5dt-usb:/dev/zero", {});
  Samples samples;
  for (int polls = 0; polls < 5; ++polls) device->poll(samples);
  EXPECT_TRUE(samples.empty());
  EXPECT_EQ(device->status().health, DeviceHealth::babbling);
  EXPECT_NE(device->status().message.find("/dev/zero sends no valid records"), std::string::npos);
}

TEST(Line, GlovesReportFlexionBothWays) {
  for (const bool hid : {false, true})
    for (const bool left : {false, true}) {
      FiveDtTwinOptions options;
      options.script.add(0, 0, std::array<double, fingers>{0, 0, 1, 1, 1});
      options.hid = hid;
      options.left = left;
      Line line(std::make_unique<FiveDtTwin>(options, monotonic_ns()), {});
      DeviceConfig config;
      config.glove.left = left;
      const double open = hid ? 800 : 0, closed = hid ? 1300 : 255;
      config.glove.calibration = GloveCalibration{};
      config.glove.calibration->open.fill(open);
      config.glove.calibration->closed.fill(closed);
      const auto device = open_device((hid ? "5dt-usb:" : "5dt:") + line.link(), config);
      Samples samples;
      ASSERT_TRUE(poll_until(*device, samples, 3, [&] { return samples.size() >= 10; }));
      EXPECT_EQ(samples.back().flexion, (std::array<double, fingers>{0, 0, 1, 1, 1}));
      EXPECT_EQ(samples.back().gesture, Gesture::thumb_index);
    }
}

// A simulated glove makes all gestures in a row, and each is told in its turn.
TEST(Line, GlovesTellEachGestureOfTheTable) {
  for (const bool hid : {false, true}) {
    constexpr double move = 0.04, rest = 0.06;  // s
    FiveDtTwinOptions options;
    options.hid = hid;
    options.left = hid;
    std::vector<Gesture> made;
    double time = 0;
    for_gestures([&](const GestureRow& row) {
      options.script.add(0, time += move, bends_of(row));
      options.script.add(0, time += rest, bends_of(row));
      made.push_back(row.gesture);
    });
    options.timing.wait_client = true;
    Line line(std::make_unique<FiveDtTwin>(options, monotonic_ns()), {});
    DeviceConfig config;
    config.glove.left = hid;
    config.gestures.pinch = true;
    config.glove.calibration = GloveCalibration{};
    config.glove.calibration->open.fill(hid ? 800 : 0);
    config.glove.calibration->closed.fill(hid ? 1300 : 255);
    const auto device = open_device((hid ? "5dt-usb:" : "5dt:") + line.link(), config);
    Samples samples;
    ASSERT_TRUE(poll_until(*device, samples, 10,
                           [&] { return !samples.empty() && samples.back().gesture == made.back(); }));
    auto next = made.begin();
    for (const DeviceSample& sample : samples)
      if (next != made.end() && sample.gesture == *next) ++next;
    EXPECT_EQ(next - made.begin(), std::ssize(made)) << (hid ? "usb" : "serial");
  }
}

}  // namespace
}  // namespace prosector
