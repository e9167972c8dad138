// How a FASTRAK is started, whatever state another program left it in, and what its error letters mean.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "drivers/trackers/fastrak.h"
#include "tests/drivers/fed_port.h"
#include "twins/trackers/fastrak_twin.h"

namespace prosector {
namespace {

std::string sent_at(int attempt) {
  std::string out;
  for (const FastrakStep& step : fastrak_start(attempt)) out += step.bytes;
  return out;
}

TEST(FastrakStart, LaterAttemptsFreeItFromMore) {
  EXPECT_EQ(sent_at(1),
            "\x11"
            "c");
  EXPECT_EQ(sent_at(2),
            "\x11\r"
            "c")
      << "amid a command that another program began";
  EXPECT_EQ(sent_at(6),
            "\x11\r\x19"
            "c");
  EXPECT_EQ(sent_at(8),
            "\x11\r"
            "t\x19"
            "c");
  EXPECT_EQ(sent_at(20),
            "\x11\r"
            "Yt\x19"
            "c");
  for (const FastrakStep& step : fastrak_start(20))
    EXPECT_GE(step.wait_ns, step.bytes == "\x19" ? 10'000'000'000 : 50'000'000);
}

/// A driver and a twin that is at (0.3, 0.1, −0.4) m in the room.
struct FedTracker {
  Feed feed;
  FastrakTwinOptions options;
  std::unique_ptr<FastrakTwin> twin;
  FastrakDevice device{std::make_unique<FedPort>(feed), Placement{}, FastrakConfig{}};
  std::vector<DeviceSample> samples;

  FedTracker() {
    options.script.add(0, 0, Pose{{0.3, 0.1, -0.4}, Quat(0.8, 0.1, -0.3, 0.5).normalized()});
    twin = std::make_unique<FastrakTwin>(options, monotonic_ns());
  }
  void say(std::string_view text) {
    std::vector<TwinOutput> none;
    twin->receive({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, monotonic_ns(), none);
  }
  bool streams(double seconds) {
    const std::int64_t end = monotonic_ns() + static_cast<std::int64_t>(1e9 * seconds);
    while (samples.size() < 5 && monotonic_ns() < end) {
      device.poll(samples);
      const auto bytes = sent_bytes(*twin, feed, monotonic_ns());
      feed.to_driver.insert(feed.to_driver.end(), bytes.begin(), bytes.end());
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return samples.size() >= 5;
  }
};

TEST(FastrakStart, AHalfWrittenCommandIsEnded) {
  FedTracker fed;
  fed.say("O1,2,");  // and the other program ended
  EXPECT_TRUE(fed.streams(4)) << fed.device.status().message;
}

TEST(FastrakErrors, PosesWithALetterCountAndAreSaid) {
  FedTracker fed;
  fed.say("uV1,1,1,1,-1,-1,-1\r");  // an envelope that it is outside of
  ASSERT_TRUE(fed.streams(4)) << fed.device.status().message;
  for (const DeviceSample& sample : fed.samples) {
    EXPECT_EQ(sample.error, 'x');
    EXPECT_TRUE(sample.has_pose) << "public drivers use it";
    EXPECT_FALSE(sample.has_trusted_pose()) << "calibration does not";
    EXPECT_LT((sample.pose.p - Vec3(0.3, 0.1, -0.4)).norm(), 1e-4);
  }
  EXPECT_NE(fed.device.status().message.find("error 'x'"), std::string::npos);
}

}  // namespace
}  // namespace prosector
