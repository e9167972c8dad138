#pragma once
// A synthetic scene as a camera that runs in real time.

#include "drivers/camera/camera.h"
#include "drivers/camera/synthetic/synthetic_scene.h"

namespace prosector {

class SyntheticCamera final : public Camera {
 public:
  /// Begins the scene's time at that moment of monotonic_ns().
  SyntheticCamera(SyntheticScene scene, std::int64_t start_ns);

  /// Waits for the next picture, as real cameras let wait; pictures that take too long to draw are dropped.
  std::optional<Frame> next(std::chrono::milliseconds patience) override;
  std::optional<Lens> lens() const override { return painter_.scene().lens; }
  double response() const override { return painter_.scene().sensor.response; }
  std::string identity() const override { return "synthetic"; }

 private:
  double seconds(std::int64_t now_ns) const;
  bool has_fault(CameraFault fault, double at) const;

  ScenePainter painter_;
  std::int64_t start_ns_;
  std::uint64_t next_ = 0;
  double last_shown_ = -1;  // s
};

}  // namespace prosector
