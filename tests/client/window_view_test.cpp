// The screen as a window: off-axis cameras against geometry, eyes that are lost and found, the device that
// sees them.

#include "client/view/window_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <thread>

#include "client/app/desk/eye_window.h"
#include "client/view/camera.h"
#include "client/view/eased_eye_position.h"
#include "client/view/pick.h"
#include "common/clock.h"
#include "common/error.h"
#include "tests/random.h"

namespace prosector {
namespace {

/// Returns where a camera's picture shows a point: 0 to 1, from the upper left.
Eigen::Vector2d shown_at(const DrawCamera& camera, const Vec3& point) {
  const Vec3 x = camera.pose.inverse() * point;
  return {(x.x() / -x.z() - camera.left) / (camera.right - camera.left),
          (camera.top - x.y() / -x.z()) / (camera.top - camera.bottom)};
}

Vec3 random_eye(Random& random) {
  return {random.uniform(-0.4, 0.4), random.uniform(-0.3, 0.3), random.uniform(0.2, 1.2)};
}

Pose random_pose(Random& random) {
  return {random.point(2), Quat(Eigen::AngleAxisd(random.uniform(-3, 3), random.point(1).normalized()))};
}

TEST(CameraThrough, ShowsWhatTheWayFromTheEyeMeetsInTheWindow) {
  Random random{5};
  for (int k = 0; k < 500; ++k) {
    const Pose room_screen = random_pose(random);
    const Eigen::Vector2d size(random.uniform(0.1, 1), random.uniform(0.1, 1));
    const Vec3 eye = random_eye(random);
    const DrawCamera camera = camera_through(room_screen, size, eye);
    EXPECT_LT((camera.pose.p - room_screen * eye).norm(), 1e-12);
    // A place on the screen, and one on the same way from the eye, before it or behind.
    const Eigen::Vector2d share(random.uniform(0, 1), random.uniform(0, 1));
    const Vec3 on_screen(size.x() * (share.x() - 0.5), size.y() * (0.5 - share.y()), 0);
    const Vec3 point = eye + random.uniform(0.2, 5) * (on_screen - eye);
    EXPECT_LT((shown_at(camera, room_screen * point) - share).norm(), 1e-9);
  }
}

TEST(CameraThrough, StaysOneWhereverTheEyeIs) {
  for (const double z : {0.02, 0.0, -0.5, -1e6}) {
    const DrawCamera camera = camera_through({}, {0.5, 0.3}, {3, -2, z});
    EXPECT_TRUE(std::isfinite(camera.left) && camera.left < camera.right && camera.bottom < camera.top) << z;
  }
}

TEST(LookThrough, FromTheRestingEyeIsTheViewWithoutAWindow) {
  Random random{6};
  for (int k = 0; k < 100; ++k) {
    const double fov = random.uniform(0.2, 1.5), height = random.uniform(0.1, 1);
    const DrawCamera rest = mono_camera(random_pose(random), fov, 640, 480);
    const DrawCamera seen =
        look_through(rest, random.uniform(0.1, 5), {resting_eye(fov, height), height, false});
    EXPECT_LT((seen.pose.p - rest.pose.p).norm(), 1e-9);
    EXPECT_LT(seen.pose.q.angularDistance(rest.pose.q), 1e-9);
    for (const auto member : {&DrawCamera::left, &DrawCamera::right, &DrawCamera::bottom, &DrawCamera::top})
      EXPECT_NEAR(seen.*member, rest.*member, 1e-9);
    EXPECT_EQ(seen.width, rest.width);
    EXPECT_EQ(seen.far, rest.far);
  }
}

TEST(LookThrough, KeepsWhatLiesInTheScreenAndMovesTheRestAsParallaxDoes) {
  const double fov = 0.8, height = 0.3, distance = 1.2, scale = 2 * distance * std::tan(fov / 2) / height;
  const DrawCamera rest = mono_camera({}, fov, 640, 480);
  for (const double x : {-0.2, 0.1, 0.25}) {
    const Vec3 eye(x, 0.05, 0.6);
    const DrawCamera seen = look_through(rest, distance, {eye, height, false});
    EXPECT_LT((shown_at(seen, {0, 0, -distance}) - Eigen::Vector2d(0.5, 0.5)).norm(), 1e-12);
    for (const double behind : {-0.2, 0.3, 2.0}) {  // m of the room, from the screen
      // On the screen it moves by the eye's way times depth over the whole distance, in heights of the
      // picture.
      const double b = behind / scale, moved = x * b / (b + eye.z()) / height;
      EXPECT_NEAR((shown_at(seen, {0, 0, -distance - behind}).x() - 0.5) * 640 / 480, moved, 1e-9)
          << x << ", " << behind;
    }
  }
}

TEST(LookThrough, PansTheViewWithTheFace) {
  const DrawCamera rest = mono_camera({Vec3(1, 2, 3), Quat::Identity()}, 0.8, 640, 480);
  const DrawCamera seen = look_through(rest, 1, {Vec3(0.3, 0.2, 0.6), 0.3, true});
  EXPECT_EQ(seen.pose.p, rest.pose.p);
  const Vec3 ahead = ray_through(seen, 320, 240).along;
  EXPECT_NEAR(std::atan2(ahead.x(), -ahead.z()), std::atan2(0.3, 0.6), 1e-12) << "to the right";
  EXPECT_GT(ahead.y(), 0) << "up";
  const DrawCamera still = look_through(rest, 1, {Vec3(0, 0, 0.6), 0.3, true});
  EXPECT_LT(still.pose.q.angularDistance(rest.pose.q), 1e-12);
}

TEST(EasedEyePosition, IsExactlyWhereItIsSeenAfterItsWayThere) {
  EasedEyePosition eye;
  const Vec3 rest(0, 0, 0.4);
  EXPECT_EQ(eye.at(0, rest), rest);
  for (double t = 1; t < 3; t += 0.03) {
    const Vec3 seen(0.1 * std::sin(5 * t), 0.1, 0.6);
    eye.saw(seen, t);
    const Vec3 now = eye.at(t, rest);
    if (t > 1 + EasedEyePosition::back + 0.03) {
      EXPECT_EQ(now, seen);
    }
  }
  for (double t = 3; t < 3 + EasedEyePosition::held + EasedEyePosition::away + 0.1; t += 0.03)
    (void)eye.at(t, rest);
  EXPECT_EQ(eye.at(5, rest), rest) << "never seen again";
}

TEST(EasedEyePosition, NeverJumpsWhereverItIsLostAndFound) {
  Random random{8};
  EasedEyePosition eye;
  const Vec3 rest(0, 0, 0.4);
  Vec3 last = eye.at(0, rest), seen = random_eye(random);
  double lost_until = 0, gone = 0;
  for (double t = 0; t < 200; t += 0.01) {
    if (random.uniform(0, 1) < 0.005) lost_until = t + random.uniform(0, 3);
    if (t >= lost_until) {
      // Somebody who was away comes back elsewhere; else the eye rests, so that all motion is the easing's.
      if (gone > EasedEyePosition::held + 0.02) seen = random_eye(random);
      gone = 0;
      eye.saw(seen, t);
    } else {
      gone += 0.01;
    }
    const Vec3 now = eye.at(t, rest);
    // At most 1.5 times the mean speed of the longest way in the shortest time.
    EXPECT_LT((now - last).norm(), 1.5 * 1.7 * 0.01 / EasedEyePosition::back + 1e-9) << t;
    last = now;
  }
}

TEST(EyeWindow, FollowsAnyDeviceWhoseFirstStationIsTheEyes) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "window_eyes.csv";
  std::ofstream(file) << "time,station,x,y,z,qw,qx,qy,qz\n0,1,0.1,0.05,0.6,1,0,0,0\n0,2,9,9,9,1,0,0,0\n"
                         "0.05,1,0.1,0.05,0.6,1,0,0,0\n";
  WindowSettings settings;
  settings.address = "recorded-loop:" + file.string();
  settings.height = 0.25;
  EyeWindow window(settings);
  const std::int64_t start = monotonic_ns();
  WindowLook look = window.look(start, 0.8);
  EXPECT_LT((look.eye - resting_eye(0.8, 0.25)).norm(), 1e-12) << "nothing was seen yet";
  EXPECT_NE(window.take_news(), "");
  const Vec3 there(0.1, 0.05, 0.6);
  while (look.eye != there && seconds_since(start) < 20) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    look = window.look(monotonic_ns(), 0.8);
  }
  EXPECT_EQ(look.eye, there);
  EXPECT_EQ(look.height, 0.25);
  EXPECT_FALSE(look.pans);
  settings.address = "face";
  EXPECT_THROW(EyeWindow{settings}, InputError);
}

}  // namespace
}  // namespace prosector
