#pragma once
// Camera that shows a synthetic scene in real time.

#include "drivers/camera/base/camera.h"
#include "twins/camera/synthetic_scene.h"

namespace prosector {

class SyntheticCamera final : public Camera {
 public:
  /// Creates a camera that shows a synthetic scene. The scene's time is 0 when monotonic_ns() is `start_ns`.
  SyntheticCamera(SyntheticScene scene, std::int64_t start_ns);

  /// Waits for the scene's next image, at most `time_limit`, like a real camera. Returns nothing on a
  /// timeout. Skips images that take too long to draw. Throws InputError while the scene simulates an
  /// unplugged camera.
  std::optional<Frame> next(std::chrono::milliseconds time_limit) override;
  std::optional<Lens> lens() const override { return painter_.scene().lens; }
  double response() const override { return painter_.scene().sensor.response; }
  std::string identity() const override { return "synthetic"; }

 private:
  double seconds(std::int64_t now_ns) const;
  bool has_fault(CameraFault fault, double at) const;

  SceneRenderer painter_;
  std::int64_t start_ns_;
  std::uint64_t next_ = 0;
  double last_shown_ = -1;  // s
};

}  // namespace prosector
