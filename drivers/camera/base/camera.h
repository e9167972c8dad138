#pragma once
// Interface of cameras, real or synthetic. A camera delivers images, each with its exposure time.

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "common/clock.h"
#include "drivers/camera/base/frame.h"
#include "drivers/camera/base/lens.h"

namespace prosector {

inline constexpr double default_response = 2.2;  // exponent from light to brightness, close to sRGB's

class Camera {
 public:
  virtual ~Camera() = default;
  /// Waits for the next image, at most `patience`. A slow caller gets the newest image. Returns nothing on a
  /// timeout. Throws InputError if the camera is gone; it must then be reopened.
  virtual std::optional<Frame> next(std::chrono::milliseconds time_limit) = 0;
  /// Returns the lens if the camera knows it: a synthetic camera does, a real camera does not.
  virtual std::optional<Lens> lens() const { return std::nullopt; }
  /// Returns the exponent from light to brightness; the usual value if it is unknown.
  virtual double response() const { return default_response; }
  /// Returns a text that identifies the camera (model, serial number), under which its calibration is found.
  virtual std::string identity() const = 0;
};

/// Opens a camera. `address`: "/dev/video0", a number, a video file, a stream's URL, "synthetic:SCENE.toml",
/// or "igtl://HOST[:PORT][/DEVICE]" for another program's images. Throws InputError if the camera can't be
/// opened. The time of a synthetic scene starts at `start_ns`.
std::unique_ptr<Camera> open_camera(const std::string& address, std::int64_t start_ns = monotonic_ns());

}  // namespace prosector
