// A headset by OpenXR with our double of a runtime, and whatever that does to it. One test: the double
// follows the environment once a process.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "client/xr/headset.h"
#include "common/clock.h"
#include "tests/folders.h"

namespace prosector {
namespace {

const Pose room_stage{{0.5, 0, -0.25}, Quat(Eigen::AngleAxisd(1.2, Vec3::UnitY()))};

/// Counts what a headset's frames hold, and fails on what no frame may.
struct Seen {
  int frames = 0, hands = 0, heads = 0, shown = 0, pressed = 0;

  void take(const TrackedUser& user) {
    if (user.head) {
      ++heads;
      EXPECT_LT((user.head->p - room_stage.p).norm(), 0.11);  // the wearer is at the stage's middle
      EXPECT_LT(user.head->q.angularDistance(room_stage.q), 1e-5);
    }
    for (const auto& hand : user.hands) {
      if (!hand) continue;
      ++hands;
      EXPECT_TRUE(is_finite(hand->wrist));
      for (const std::size_t finger : {0, 1, 2, 4}) EXPECT_NEAR(hand->flexion[finger], 0, 1e-5);
      if (hand->buttons == menu_button) ++pressed;
    }
  }
};

TEST(Headset, ComesBackFromWhateverARuntimeDoes) {
  setenv("XR_RUNTIME_JSON", build_path("lib/twins/openxr_double.json").c_str(), 1);
  const std::string runtime = "--held --script " + source_path("tests/client/ring_finger.csv") +
                              " --rate 200 --width 32 --height 24 --unfocused 0.2 0.4 --garbage 0.5 0.7 "
                              "--recentred 0.75 --session-lost 0.8 --frame-refused 1.1 --instance-lost 1.4 "
                              "--away 1.4 2.2 --left 3.2";
  setenv("PROSECTOR_OPENXR", runtime.c_str(), 1);
  const auto context = make_egl_context(64, 64);
  Seen seen, received;
  std::mutex received_mutex;
  std::optional<Headset> made;
  made.emplace(*context, room_stage, [&](const TrackedUser& user) {
    const std::lock_guard lock(received_mutex);
    received.take(user);
  });
  Headset& headset = *made;
  std::vector<std::string> news;
  const std::int64_t end = monotonic_ns() + 30'000'000'000;
  while (!headset.closed() && monotonic_ns() < end) {
    const auto frame = headset.next_frame();
    for (const HeadsetNews& now : headset.take_news()) news.push_back(now.line);
    if (!headset.keeps_time()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (!frame) continue;
    ++seen.frames;
    EXPECT_EQ(frame->width, 32);
    EXPECT_EQ(frame->height, 24);
    EXPECT_EQ(frame->cameras()[1].x, 32);
    for (const EyeView& eye : frame->eyes) EXPECT_TRUE(is_usable(eye));
    EXPECT_NEAR((frame->eyes[0].pose.p - frame->eyes[1].pose.p).norm(), 0.064, 1e-5);
    seen.take(frame->user);
    headset.show([&](unsigned texture) { seen.shown += texture != 0 ? 1 : 0; });
  }
  EXPECT_TRUE(headset.closed());
  made.reset();
  EXPECT_GT(received.heads, 20);
  EXPECT_GT(received.hands, 20);
  EXPECT_GT(seen.frames, 10);
  EXPECT_GT(seen.shown, 10);
  EXPECT_GT(seen.heads, seen.frames / 2);
  EXPECT_GT(seen.hands, 10);
  EXPECT_GT(seen.pressed, 2);  // the ring finger's button, though the hand is of joints
  EXPECT_LT(seen.pressed, seen.hands / 2);
  const auto said = [&](const std::string& words) {
    return std::ranges::count_if(
        news, [&](const std::string& line) { return line.find(words) != std::string::npos; });
  };
  EXPECT_EQ(said("simulated headset by"), 4);
  for (const char* words : {"hand tracking paused", "hand tracking restored", "re-centred",
                            "the session is lost", "the runtime failed", "no runtime responds", "taken off"})
    EXPECT_GE(said(words), 1) << words;
}

}  // namespace
}  // namespace prosector
