#include "tests/hands/face_errors.h"

#include <cmath>

#include "common/clock.h"
#include "drivers/camera/base/camera_frames.h"
#include "drivers/camera/face/eyes_filter.h"
#include "drivers/camera/face/eyes_pose.h"
#include "drivers/config/client_config.h"
#include "twins/camera/synthetic_scene.h"

namespace prosector {
namespace {

constexpr double rate = 30;         // pictures a second
constexpr double spread = 0.05;     // m, of places
constexpr double first_wait = 0.5;  // s before something moves: the filter has settled

/// Returns where the head of a place is in the screen's frame.
Pose screen_head(const FaceCase& what, int place, double seconds) {
  // Places on a spiral, so that they are spread evenly.
  const double turn = 2.4 * place, out = spread * std::sqrt((place + 0.5) / std::max(what.places, 1));
  const double moved = what.speed * std::max(0.0, seconds - first_wait);
  const Vec3 at(what.aside + moved + out * std::cos(turn), 0.03 + out * std::sin(turn),
                what.distance + 0.04 * std::sin(1.7 * place));
  return {at, Quat(Eigen::AngleAxisd(-what.yaw, Vec3::UnitY()))};  // it looks along its −z, to the screen
}

double milliseconds_since(std::int64_t start_ns) {
  return 1e-6 * static_cast<double>(monotonic_ns() - start_ns);
}

/// How much places differ from one to the next, along a way and across it.
struct Wander {
  double along = 0, across = 0;
  int steps = 0;
  bool has_last = false;
  Vec3 last = Vec3::Zero();

  void take(const Vec3& off, const Vec3& way) {
    if (has_last) {
      const Vec3 step = off - last;
      along += std::pow(step.dot(way), 2);
      across += (step - step.dot(way) * way).squaredNorm() / 2;
      ++steps;
    }
    has_last = true;
    last = off;
  }
};

double rms_mm(double sum, int n) {
  return n > 0 ? 1e3 * std::sqrt(sum / n) : 0;
}

}  // namespace

FaceErrors face_errors(const FaceCase& what, const std::shared_ptr<const FaceMesh>& face,
                       const std::filesystem::path& models) {
  FaceDetector finder(models);
  // Where one is by default, turned down a little, to the face.
  const Pose screen_camera = WindowSettings().device.placement.room_device *
                             Pose{Vec3::Zero(), Quat(Eigen::AngleAxisd(-0.2, Vec3::UnitX()))};
  FaceErrors out;
  Wander raw, smoothed;
  for (int place = 0; place < what.places; ++place) {
    SyntheticScene scene;
    scene.lens.height = what.height;
    scene.lens.width = what.height * 4 / 3;
    scene.lens.fx = scene.lens.fy = 600.0 * what.height / 480;
    scene.lens.cx = (scene.lens.width - 1) / 2.0;
    scene.lens.cy = (scene.lens.height - 1) / 2.0;
    scene.lens.k1 = -0.18;
    scene.rays = 1;
    scene.exposure = 0.01;
    scene.sensor.light = what.light;
    scene.camera.pose = screen_camera;
    scene.carriers.emplace_back();
    scene.faces.push_back({0, face});
    EyesFilter filter;
    raw.has_last = smoothed.has_last = false;
    std::optional<Vec3> reported;
    Vec3 truth = Vec3::Zero();
    const auto first = static_cast<std::uint64_t>(what.pictures * place);
    for (int k = 0; k < what.pictures; ++k) {
      const double seconds = k / rate;
      scene.carriers[0].pose = screen_head(what, place, seconds);
      truth = scene.carriers[0].pose.p;
      const Image image = SceneRenderer(scene).paint_at(seconds, first + static_cast<std::uint64_t>(k));
      ++out.pictures;
      std::int64_t start = monotonic_ns();
      const auto found = finder.find(image);
      out.find_ms.push_back(milliseconds_since(start));
      if (!found) continue;
      ++out.seen;
      start = monotonic_ns();
      const EyesPose eyes = estimate_eyes_pose(*found, scene.lens, face->eye_distance);
      const Pose head = filter.update(eyes.head, 1'000'000'000 + std::llround(1e9 * seconds));
      out.smooth_ms.push_back(milliseconds_since(start));
      const Vec3 way = (truth - screen_camera.p).normalized();
      raw.take(screen_camera * device_camera * eyes.head.p - truth, way);
      reported = screen_camera * device_camera * head.p;
      if (k >= what.pictures / 2) smoothed.take(*reported - truth, way);
    }
    if (!reported) continue;
    const Vec3 off = *reported - truth, way = truth.normalized();
    out.gaze.push_back(std::acos(std::min(1.0, reported->normalized().dot(way))));
    out.depth.push_back(1e3 * std::abs(off.dot(way)));
    out.across.push_back(1e3 * (off - off.dot(way) * way).norm());
    if (what.speed > 0) out.lag.push_back(-off.x() / what.speed);
  }
  out.jitter_along = rms_mm(raw.along, raw.steps);
  out.jitter_across = rms_mm(raw.across, raw.steps);
  out.rest_along = rms_mm(smoothed.along, smoothed.steps);
  out.rest_across = rms_mm(smoothed.across, smoothed.steps);
  return out;
}

}  // namespace prosector
