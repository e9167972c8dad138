#pragma once
// A camera, real or synthetic: it gives pictures, each with the time of its exposure.

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "common/clock.h"
#include "drivers/camera/frame.h"
#include "drivers/camera/lens.h"

namespace prosector {

inline constexpr double usual_response = 2.2;  // exponent from light to brightness: about as sRGB has it

class Camera {
 public:
  virtual ~Camera() = default;
  /// Waits for the next picture, at most that long; who comes late gets the newest. Returns nothing where
  /// none came. Throws InputError when the camera is gone: it must be opened anew.
  virtual std::optional<Frame> next(std::chrono::milliseconds patience) = 0;
  /// Returns what is known of its lens: a synthetic camera's; nothing for a real one.
  virtual std::optional<Lens> lens() const { return std::nullopt; }
  /// Returns the exponent from light to brightness, as far as it is known.
  virtual double response() const { return usual_response; }
  /// Returns what tells it from other cameras, to find its calibration by: model, serial number.
  virtual std::string identity() const = 0;
};

/// Opens a camera: "/dev/video0", a number, a video's file, a stream's URL, "synthetic:SCENE.toml", or
/// another program's by "igtl://HOST[:PORT][/DEVICE]". Throws InputError where it can't be opened. A
/// synthetic scene's time begins at `start_ns`.
std::unique_ptr<Camera> open_camera(const std::string& address, std::int64_t start_ns = monotonic_ns());

}  // namespace prosector
