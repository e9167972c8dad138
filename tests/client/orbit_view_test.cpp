// An eye about its target: it stays within its bounds, and comes home from everywhere.

#include "client/app/desk/orbit_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "client/app/desk/desk_start.h"
#include "client/app/desk/desk_view.h"
#include "client/render/keyboard_layout.h"
#include "client/view/camera.h"
#include "client/view/pick.h"

namespace prosector {
namespace {

const ViewPlace home{{0.1, 1, -0.2}, 0.4, 0.5, 0.8};

void arrive(OrbitView& view) {
  for (int k = 0; k < 30; ++k) view.advance(0.01);
}

double off(const ViewPlace& a, const ViewPlace& b) {
  return (a.eye() - b.eye()).norm() + (a.target - b.target).norm();
}

TEST(OrbitView, PlaceOfAnEyeGivesThatEyeBack) {
  const Vec3 eye(0.3, 1.7, -0.4), target(0, 1, 0.2);
  const ViewPlace place = place_of(eye, target);
  EXPECT_LT((place.eye() - eye).norm(), 1e-12);
  EXPECT_LT((place.pose().q * -Vec3::UnitZ() - (target - eye).normalized()).norm(), 1e-12);
  EXPECT_TRUE(place_of(target, target).is_finite()) << "an eye in its target";
}

TEST(OrbitView, TurnsAboutTheTargetOrAboutTheEye) {
  OrbitView view;
  view.begin(home);
  view.turn(0.3, 0.1);
  EXPECT_LT((view.place().target - home.target).norm(), 1e-12);
  EXPECT_NEAR(view.place().distance, home.distance, 1e-12);
  EXPECT_GT((view.place().eye() - home.eye()).norm(), 0.1);
  const Vec3 eye = view.place().eye();
  view.rotate_gaze(0.3, -0.2);
  EXPECT_LT((view.place().eye() - eye).norm(), 1e-12);
  EXPECT_GT((view.place().target - home.target).norm(), 0.1);
}

// As a pointer that is dragged to the right and downwards does while the user flies.
TEST(OrbitView, GazeRotatesToTheRightAndDownwards) {
  OrbitView view;
  view.begin(home);
  const auto gaze = [&] { return Vec3(view.place().pose().q * -Vec3::UnitZ()); };
  const Vec3 before = gaze(), right = view.place().pose().q * Vec3::UnitX();
  view.rotate_gaze(0.2, 0);
  EXPECT_GT(gaze().dot(right), 0.1);
  EXPECT_NEAR(gaze().y(), before.y(), 1e-12);
  view.rotate_gaze(0, 0.2);
  EXPECT_LT(gaze().y(), before.y() - 0.1);
}

// As a pointer that drags the target to the right and downwards does.
TEST(OrbitView, EyeTurnsAboutTheTargetToTheLeftAndUpwards) {
  OrbitView view;
  view.begin(home);
  const Vec3 eye = home.eye(), right = home.pose().q * Vec3::UnitX();
  view.turn(0.2, 0);
  EXPECT_LT((view.place().eye() - eye).dot(right), -0.1);
  view.turn(0, 0.2);
  EXPECT_GT(view.place().eye().y(), eye.y() + 0.05);
}

TEST(OrbitView, AnythingKeepsItInBoundsAndHomeIsAlwaysReached) {
  std::mt19937 random(7);
  const double wild[] = {0,    0.1,  -0.1,  1,    -3,      1e3,
                         -1e9, 1e-9, 1e300, -0.0, 1 / 0.0, std::numeric_limits<double>::quiet_NaN()};
  const auto some = [&] { return wild[random() % std::size(wild)]; };
  OrbitView view;
  view.begin(home);
  for (int round = 0; round < 2000; ++round) {
    switch (random() % 6) {
      case 0:
        view.turn(some(), some());
        break;
      case 1:
        view.rotate_gaze(some(), some());
        break;
      case 2:
        view.zoom(some());
        break;
      case 3:
        view.move({some(), some(), some()});
        break;
      case 4:
        view.go_to({{some(), some(), some()}, some(), some(), some()});
        break;
      default:
        view.advance(some());
    }
    const ViewPlace& place = view.place();
    ASSERT_TRUE(place.is_finite());
    ASSERT_GE(place.distance, min_view_distance);
    ASSERT_LE(place.distance, max_view_distance);
    ASSERT_GT(place.distance, DrawCamera().near);
    ASSERT_LE(std::abs(place.pitch), max_view_pitch);
    ASSERT_LE(place.target.cwiseAbs().maxCoeff(), max_target_coordinate);
    ASSERT_TRUE(is_finite(place.pose()));
    if (round % 100 != 0) continue;
    view.go_to(view.home());
    arrive(view);
    ASSERT_LT(off(view.place(), home), 1e-9);
  }
}

TEST(OrbitView, GoesSmoothlyTheShortWayRoundInAQuarterOfASecond) {
  ViewPlace from = home, to = home;
  from.yaw = 3;
  to.yaw = -3;
  to.distance = 2;
  to.target.x() += 0.5;
  OrbitView view;
  view.begin(from);
  view.go_to(to);
  Vec3 last = view.place().eye();
  const double way = 2 * (2 * std::numbers::pi - 6) + 1.2 + 0.5;  // m, at most: turned, away, aside
  for (int k = 1; k <= 25; ++k) {
    view.advance(0.01);
    EXPECT_LT((view.place().eye() - last).norm(), 1.6 * way / 25) << k;
    EXPECT_GT(std::abs(view.place().yaw), 2.9) << "the short way";
    last = view.place().eye();
  }
  EXPECT_LT(off(view.place(), to), 1e-9);
}

TEST(OrbitView, WhatIsTurnedDuringATransitionIsTurnedAtItsEnd) {
  OrbitView view;
  view.begin(home);
  ViewPlace far = home;
  far.distance = 5;
  view.go_to(far);
  view.advance(0.1);
  view.turn(0.1, 0);
  view.zoom(0.5);
  arrive(view);
  EXPECT_NEAR(view.place().yaw, home.yaw - 0.1, 1e-12);
  EXPECT_NEAR(view.place().distance, 2.5, 1e-12);
}

std::vector<Vec3> corners_of(const Eigen::AlignedBox3d& box) {
  std::vector<Vec3> out;
  for (int k = 0; k < 8; ++k) out.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)));
  return out;
}

/// Returns the larger of the shares of the picture's width and height that the box takes.
double share_of(const Eigen::AlignedBox3d& box, const ViewPlace& place, double fov, double aspect) {
  double share = 0;
  const Pose into = place.pose().inverse();
  for (const Vec3& corner : corners_of(box)) {
    const Vec3 x = into * corner;
    EXPECT_LT(x.z(), 0) << "in front of the eye";
    const double up = std::tan(fov / 2);
    share = std::max({share, std::abs(x.y() / x.z()) / up, std::abs(x.x() / x.z()) / (up * aspect)});
  }
  return share;
}

TEST(OrbitView, FramesABoxToItsShareOfThePicture) {
  const Eigen::AlignedBox3d box(Vec3(-0.1, 0.9, -0.05), Vec3(0.15, 1.05, 0.2));
  for (const double yaw : {0.0, 1.0, -2.0})
    for (const double pitch : {0.0, 0.6, max_view_pitch})
      for (const double aspect : {0.5, 4.0 / 3, 3.0})
        EXPECT_NEAR(share_of(box, framed(box, yaw, pitch, 0.8, aspect), 0.8, aspect), 0.6, 1e-9);
  const Eigen::AlignedBox3d speck(Vec3(1, 1, 1), Vec3(1, 1, 1));
  EXPECT_EQ(framed(speck, 0, 0, 0.8, 1).distance, min_view_distance);
}

TEST(DeskStart, ShowsTheAnatomyFromWhereTheScenesCameraStands) {
  const CameraInfo camera{{-0.4, 1.5, 0.8}, {0, 1.1, 0}, 0.75};
  const Eigen::AlignedBox3d box(Vec3(-0.1, 0.9, -0.1), Vec3(0.1, 1.05, 0.1));
  const std::vector<Vec3> anatomy = corners_of(box);
  const DeskStart start = desk_start(camera, anatomy, {}, 1.5);
  const ViewPlace scene = place_of(camera.eye, camera.target);
  EXPECT_NEAR(start.home.yaw, scene.yaw, 1e-12);
  EXPECT_NEAR(start.home.pitch, scene.pitch, 1e-12);
  EXPECT_NEAR(share_of(box, start.home, camera.fov, 1.5), 0.6, 1e-9);
  for (std::size_t k = 0; k < 4; ++k) {
    ASSERT_TRUE(start.views[k]);
    EXPECT_LT((start.views[k]->target - box.center()).norm(), 1e-12);
  }
  EXPECT_GT(start.views[0]->eye().z(), 0.3) << "front";
  EXPECT_LT(start.views[1]->eye().x(), -0.3) << "left";
  EXPECT_GT(start.views[2]->eye().x(), 0.3) << "right";
  EXPECT_GT(start.views[3]->eye().y(), 1.3) << "above";
  const DeskStart empty = desk_start(camera, {}, {}, 1.5);
  EXPECT_LT((empty.home.eye() - camera.eye).norm(), 1e-9) << "no anatomy: the camera's own view";
}

TEST(DeskStart, SeatsPeopleBesideEachOther) {
  const CameraInfo camera{{0, 1.5, 0.8}, {0, 1, 0}, 0.75};
  const std::vector<Vec3> anatomy = corners_of({Vec3(-0.1, 0.9, -0.1), Vec3(0.1, 1.05, 0.1)});
  std::vector<Vec3> heads;
  std::vector<double> yaws;
  for (int person = 0; person < 18; ++person) {
    const DeskStart start = desk_start(camera, anatomy, heads, 1.5);
    for (const double other : yaws)
      EXPECT_GT(std::abs(std::remainder(start.home.yaw - other, 2 * std::numbers::pi)), 0.3) << person;
    yaws.push_back(start.home.yaw);
    heads.push_back(start.home.eye());
  }
  constexpr double step = 20 * std::numbers::pi / 180;
  EXPECT_NEAR(yaws[0], 0, 1e-9);
  EXPECT_NEAR(yaws[1], step, 1e-9);
  EXPECT_NEAR(yaws[2], -step, 1e-9);
  heads.erase(heads.begin());
  EXPECT_NEAR(desk_start(camera, anatomy, heads, 1.5).home.yaw, 0, 1e-9) << "who leaves makes room";
}

TEST(Keyboard, TheCrossGoesByPlaceAndOtherKeysByWhatTheyPrint) {
  EXPECT_EQ(key_meant(key_of('Y'), "z"), key_of('Z')) << "German";
  EXPECT_EQ(key_meant(key_of(']'), "+"), key_of('='));
  EXPECT_EQ(key_meant(key_of('/'), "-"), key_of('-'));
  EXPECT_EQ(key_meant(key_of('W'), "z"), key_of('W')) << "French: the cross stays in its place";
  EXPECT_EQ(key_meant(key_of('Z'), "w"), key_of('Z'));
  EXPECT_EQ(key_meant(key_of('1'), "&"), key_of('1'));
  EXPECT_EQ(key_meant(key_of(';'), "ö"), key_of(';'));
  EXPECT_EQ(key_meant(key_of('G'), ""), key_of('G'));
}

TEST(DeskView, PointsAsTheCameraSeesThatLeadsIt) {
  DeskView view;
  view.begin({}, 640, 480);
  const Ray before = view.pointer();
  DrawCamera camera;
  camera.pose = {{0.3, 1.5, 0.4}, Quat(Eigen::AngleAxisd(-0.9, Vec3::UnitX()))};
  camera.left = -0.6;
  camera.right = 0.5;
  camera.bottom = -0.4;
  camera.top = 0.35;
  camera.width = 640;
  camera.height = 480;
  view.follow_camera(camera);
  const Ray seen = ray_through(camera, view.pointer_pixel().x(), view.pointer_pixel().y());
  EXPECT_EQ(view.pointer().from, camera.pose.p);
  EXPECT_LT((view.pointer().along - seen.along).norm(), 1e-12);
  EXPECT_LT((view.place().eye() - camera.pose.p).norm(), 1e-9);
  EXPECT_GT(view.place().back().dot(camera.pose.q * Vec3::UnitZ()), 1 - 1e-9);
  view.follow_camera(std::nullopt);
  EXPECT_EQ(view.pointer().along, before.along);
}

}  // namespace
}  // namespace prosector
