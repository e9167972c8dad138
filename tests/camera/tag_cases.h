#pragma once
// A board somewhere before a camera, as tests and benches place it.

#include <numbers>

#include "drivers/camera/base/camera_frames.h"
#include "tests/random.h"
#include "twins/camera/synthetic_scene.h"

namespace prosector {

inline constexpr double degree = std::numbers::pi / 180;

/// The camera that published figures were measured with.
inline Lens usual_lens() {
  Lens lens;
  lens.cx = 322;
  lens.cy = 237;
  lens.k1 = -0.18;
  lens.k2 = 0.03;
  return lens;
}

/// A camera in the room's origin that looks along −z, on a wooden wall far behind.
inline SyntheticScene usual_scene(const Lens& lens) {
  SyntheticScene scene;
  scene.lens = lens;
  scene.exposure = 0;
  scene.rays = 4;
  TexturedQuad wall{
      0, {}, 6, 5, std::make_shared<Texture>(wood(512, 3), true, Response(scene.sensor.response)), true};
  Carrier behind;
  behind.name = "wall";
  behind.pose.p = {0, 0, -3};
  scene.carriers.push_back(behind);
  scene.things.push_back(wall);
  return scene;
}

/// Places a board that faces the camera, tilted at most so far (rad), in the middle half of the picture.
inline Pose board_before_camera(Random& random, double distance, double least_tilt, double most_tilt) {
  const double about = random.uniform(0, 2 * std::numbers::pi);
  const double tilt = random.uniform(least_tilt, most_tilt), turn = random.uniform(-0.5, 0.5);
  Pose pose;
  pose.p = {random.uniform(-0.15, 0.15) * distance, random.uniform(-0.12, 0.12) * distance, -distance};
  pose.q = Quat(Eigen::AngleAxisd(tilt, Vec3(std::cos(about), std::sin(about), 0))) *
           Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ()));
  return pose;
}

}  // namespace prosector
