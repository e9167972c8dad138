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
  /// Waits for the camera's next image, at most `time_limit`. A slow caller gets the newest image. Returns
  /// nothing on a timeout. Throws InputError if the camera is lost; it must then be reopened.
  virtual std::optional<Frame> next(std::chrono::milliseconds time_limit) = 0;
  /// Returns the camera's lens parameters if the camera knows them, as a synthetic camera does. Returns
  /// nothing for a real camera.
  virtual std::optional<Lens> lens() const { return std::nullopt; }
  /// Returns the exponent with which the camera converts light to pixel brightness; default_response if it is
  /// unknown.
  virtual double response() const { return default_response; }
  /// Returns a text that identifies the camera (its model, file or address). It is stored in the camera's
  /// calibration file.
  virtual std::string identity() const = 0;
};

/// Opens a camera. `address` is "/dev/video0", a device number, a video or image file, a stream's URL,
/// "synthetic:SCENE.toml", or "igtl://HOST[:PORT][/DEVICE]" for images that another program sends. The time
/// of a synthetic scene starts at `start_ns`. Throws InputError if the camera cannot be opened.
std::unique_ptr<Camera> open_camera(const std::string& address, std::int64_t start_ns = monotonic_ns());

}  // namespace prosector
