#pragma once
// Newest image of a camera, for other software.

#include <memory>
#include <mutex>

#include "common/image.h"
#include "drivers/camera/devices/shared_camera.h"

namespace prosector {

class OfferedCamera {
 public:
  /// Starts to receive the shared camera's images. Stores the newest one.
  explicit OfferedCamera(std::shared_ptr<SharedCamera> camera)
      : camera_(std::move(camera)),
        seat_(
            *camera_, [](const Camera&) {}, [this](const Frame& frame) { see(frame); }) {}

  const std::shared_ptr<SharedCamera>& camera() const { return camera_; }
  /// Returns the camera's newest image; null if none was received yet.
  std::shared_ptr<const Image> newest() const {
    const std::lock_guard lock(mutex_);
    return newest_;
  }

 private:
  void see(const Frame& frame) {
    auto image = std::make_shared<const Image>(frame.image);
    const std::lock_guard lock(mutex_);
    newest_ = std::move(image);
  }

  const std::shared_ptr<SharedCamera> camera_;
  mutable std::mutex mutex_;  // guards newest_
  std::shared_ptr<const Image> newest_;
  SharedCamera::Seat seat_;  // declared last: it uses the members above
};

}  // namespace prosector
