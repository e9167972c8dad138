#pragma once
// A camera's newest picture, for other software.

#include <memory>
#include <mutex>

#include "common/image.h"
#include "drivers/camera/shared_camera.h"

namespace prosector {

class OfferedCamera {
 public:
  /// Looks from now on.
  explicit OfferedCamera(std::shared_ptr<SharedCamera> camera)
      : camera_(std::move(camera)),
        seat_(
            *camera_, [](const Camera&) {}, [this](const Frame& frame) { see(frame); }) {}

  const std::shared_ptr<SharedCamera>& camera() const { return camera_; }
  /// Returns the newest picture; null: none came yet.
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
  mutable std::mutex mutex_;  // guards what follows
  std::shared_ptr<const Image> newest_;
  SharedCamera::Seat seat_;  // last: it uses what is above
};

}  // namespace prosector
