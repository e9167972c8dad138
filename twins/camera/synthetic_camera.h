#pragma once
// Camera that shows a synthetic scene in real time.

#include "drivers/camera/base/camera.h"
#include "twins/camera/synthetic_scene.h"

namespace prosector {

class SyntheticCamera final : public Camera {
 public:
  /// Starts the scene's time at `start_ns` of monotonic_ns().
  SyntheticCamera(SyntheticScene scene, std::int64_t start_ns);

  /// Waits for the next image, like a real camera. Images that take too long to draw are dropped.
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
