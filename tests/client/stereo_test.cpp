// Stereo profiles as files, and the pictures' geometry against its formula.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "client/render/projection.h"
#include "client/view/camera.h"
#include "common/error.h"

namespace prosector {
namespace {

std::string refusal_of(const std::string& toml) {
  try {
    (void)parse_stereo_profile(toml, "test.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Pixels from the left of the eye's own picture.
double column(const DrawCamera& camera, const Vec3& point) {
  const Eigen::Vector4d clip = view_projection_of(camera) * point.homogeneous();
  return (clip.x() / clip.w() + 1) / 2 * camera.width;
}

TEST(StereoProfile, OfTheShippedHeadsetIsItsDataSheet) {
  const StereoProfile hmd = load_stereo_profile("5dt_hmd_800_26");
  EXPECT_EQ(hmd.picture_width(), 1600);
  EXPECT_EQ(hmd.picture_height(), 600);
  EXPECT_NEAR(hmd.fov_horizontal, 20.93 * std::numbers::pi / 180, 1e-12);
  EXPECT_NEAR(hmd.fov_vertical, 15.77 * std::numbers::pi / 180, 1e-12);
  // 26° along the diagonal of a 4:3 picture.
  EXPECT_NEAR(std::tan(hmd.fov_horizontal / 2) / std::tan(hmd.fov_vertical / 2), 4.0 / 3, 0.002);
  EXPECT_NEAR(std::hypot(std::tan(hmd.fov_horizontal / 2), std::tan(hmd.fov_vertical / 2)),
              std::tan(13 * std::numbers::pi / 180), 2e-4);
}

TEST(StereoProfile, EachNumberKeepsItsRange) {
  const struct {
    const char *key, *range;
    double below, least, most, above;
  } rows[] = {{"eye_width", "16 to 4096 pixels", 15, 16, 4096, 4097},
              {"eye_height", "16 to 8192 pixels", 15, 16, 8192, 8193},
              {"fov_horizontal", "1 to 170 degrees", 0.99, 1, 170, 170.1},
              {"fov_vertical", "1 to 170 degrees", 0.99, 1, 170, 170.1},
              {"eye_distance", "0 to 0.2 m", -0.001, 0, 0.2, 0.201},
              {"convergence", "0.05 to 1000 m", 0.049, 0.05, 1000, 1001}};
  for (const auto& row : rows) {
    for (const double good : {row.least, row.most})
      EXPECT_EQ(refusal_of(fmt::format("{} = {}", row.key, good)), "");
    for (const std::string& bad : {fmt::format("{}", row.below), fmt::format("{}", row.above),
                                   std::string("nan"), std::string("\"wide\"")}) {
      const std::string refusal = refusal_of(fmt::format("# comment\n{} = {}", row.key, bad));
      EXPECT_NE(refusal.find(fmt::format("test.toml:2: {}: must be a ", row.key)), std::string::npos)
          << refusal;
      EXPECT_NE(refusal.find(row.range), std::string::npos) << refusal;
    }
  }
}

TEST(StereoProfile, RefusesWhatItDoesNotKnow) {
  EXPECT_NE(refusal_of("fov = 20").find("fov: unknown key; allowed:"), std::string::npos);
  EXPECT_NE(refusal_of("swap_eyes = 1").find("swap_eyes: must be true or false"), std::string::npos);
  EXPECT_NE(refusal_of("eye_width = 800.5").find("whole number"), std::string::npos);
  EXPECT_NE(refusal_of("eye_width =").find("test.toml:1"), std::string::npos);
  try {
    (void)load_stereo_profile("no_such_display");
    FAIL() << "no refusal";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("5dt_hmd_800_26"), std::string::npos) << error.what();
  }
}

// Off-axis frusta, parallel axes: a point at depth Z is e·(1/Z − 1/D) apart in tangents, whatever its
// direction; e: eye distance, D: convergence.
TEST(StereoCameras, DisparityFollowsTheFormula) {
  StereoProfile wide;
  wide.eye_width = 1440;
  wide.eye_height = 1600;
  wide.fov_horizontal = 1.7;
  wide.fov_vertical = 1.8;
  wide.eye_distance = 0.058;
  wide.convergence = 1.4;
  for (const StereoProfile& profile : {StereoProfile{}, load_stereo_profile("5dt_hmd_800_26"), wide})
    for (const Pose& head : {Pose{}, Pose{{0.3, 1.6, -0.2}, Quat(0.8, 0.3, -0.5, 0.1).normalized()}}) {
      const auto eyes = stereo_cameras(head, profile, profile.picture_width(), profile.picture_height());
      for (const double depth : {0.15, 0.4, 0.6, 1.4, 5.0})
        for (const double aside : {-0.1, 0.0, 0.07}) {
          const Vec3 point = head * Vec3(aside * depth, 0.05 * depth, -depth);
          const double disparity = column(eyes[0], point) - column(eyes[1], point);
          const double expected = profile.eye_distance * (1 / depth - 1 / profile.convergence) *
                                  profile.eye_width / (2 * std::tan(profile.fov_horizontal / 2));
          EXPECT_NEAR(disparity, expected, 1e-6 * profile.eye_width) << depth << " m";
        }
    }
}

// A head that nods from beyond straight down to beyond straight up, looking any way: what is ahead of it
// stays in the picture's middle, its right stays right and its top up. Angles about fixed axes would turn
// over at 90°.
TEST(HeadTracking, PassesStraightUpAndDownWithoutTurningOver) {
  for (const double yaw : {0.0, 0.7, 1.5707963, -2.4})
    for (int degrees = -110; degrees <= 110; ++degrees) {
      const Quat q(Eigen::AngleAxisd(yaw, Vec3::UnitY()) *
                   Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vec3::UnitX()));
      const Pose head{{0.3, 1.6, -0.2}, q};
      const DrawCamera camera = mono_camera(head, 0.9, 400, 300);
      const auto seen = [&](const Vec3& in_head) {
        const Eigen::Vector4d clip = view_projection_of(camera) * (head * in_head).homogeneous();
        return Eigen::Vector2d(clip.x() / clip.w(), clip.y() / clip.w());
      };
      EXPECT_LT(seen({0, 0, -1}).norm(), 1e-9) << degrees;
      EXPECT_NEAR(seen({0.1, 0, -1}).x(), 0.1 / camera.right, 1e-9) << degrees;
      EXPECT_NEAR(seen({0, 0.1, -1}).y(), 0.1 / camera.top, 1e-9) << degrees;
    }
}

TEST(StereoCameras, SwappedEyesTradePlaces) {
  StereoProfile profile;
  const auto eyes = stereo_cameras({}, profile, 1600, 600);
  EXPECT_EQ(eyes[0].x, 0);
  EXPECT_EQ(eyes[1].x, 800);
  profile.swap_eyes = true;
  const auto swapped = stereo_cameras({}, profile, 1600, 600);
  EXPECT_EQ(swapped[0].x, 800);
  EXPECT_EQ(swapped[1].x, 0);
  EXPECT_EQ(swapped[0].pose.p, eyes[0].pose.p);
}

}  // namespace
}  // namespace prosector
