// Recordings played back: each sample at its time, an end that is said, loops.
#include "drivers/recordings/recorded.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "common/clock.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr double seconds_apart = 0.04;

class Playback : public testing::Test {
 protected:
  std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("prosector-playback-" + std::to_string(getpid()) + ".csv");
  void SetUp() override { write("time,station,x,y,z\n2,1,1,0,0\n2.04,2,2,0,0\n2.08,1,3,0,0\n"); }
  void TearDown() override { std::filesystem::remove(file_); }
  void write(const std::string& text) { std::ofstream(file_) << text; }

  /// Polls until `count` samples came; each must be due when it comes.
  std::vector<DeviceSample> play(Device& device, std::size_t count) {
    std::vector<DeviceSample> all;
    const std::int64_t end = monotonic_ns() + 5'000'000'000;
    while (all.size() < count && monotonic_ns() < end) {
      std::vector<DeviceSample> some;
      device.poll(some);
      const std::int64_t now_ns = monotonic_ns();
      for (const DeviceSample& s : some) EXPECT_LE(s.time_ns, now_ns);
      all.insert(all.end(), some.begin(), some.end());
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return all;
  }
};

TEST_F(Playback, SamplesComeAtTheirTimesAndTheEndIsSaid) {
  const std::int64_t start_ns = monotonic_ns();
  RecordedDevice device(file_, false);
  const auto samples = play(device, 3);
  ASSERT_EQ(samples.size(), 3u);
  EXPECT_GE(samples[0].time_ns, start_ns);
  for (std::size_t i = 0; i < 3; ++i) {
    // The first is due at once, whatever time the recording begins with.
    EXPECT_NEAR(static_cast<double>(samples[i].time_ns - samples[0].time_ns) * 1e-9,
                static_cast<double>(i) * seconds_apart, 1e-6);
    EXPECT_EQ(samples[i].pose.p.x(), static_cast<double>(i + 1));
    EXPECT_EQ(samples[i].record, i);
  }
  EXPECT_EQ(samples[1].station, 1u);
  EXPECT_EQ(device.status().health, DeviceHealth::silent);
  EXPECT_NE(device.status().message.find("has ended"), std::string::npos);
  std::vector<DeviceSample> more;
  device.poll(more);
  EXPECT_TRUE(more.empty());
}

TEST_F(Playback, LoopsGoOnInOrder) {
  RecordedDevice device(file_, true);
  const auto samples = play(device, 8);
  ASSERT_GE(samples.size(), 8u);
  std::int64_t last_ns = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].pose.p.x(), static_cast<double>(i % 3 + 1));
    EXPECT_EQ(samples[i].record, i);
    EXPECT_GE(samples[i].time_ns, last_ns);
    last_ns = samples[i].time_ns;
  }
  EXPECT_EQ(device.status().health, DeviceHealth::streaming);
}

TEST_F(Playback, ARecordingWithoutSamplesIsRefused) {
  write("time,station,x,y,z\n");
  EXPECT_THROW(RecordedDevice(file_, false), InputError);
}

}  // namespace
}  // namespace prosector
