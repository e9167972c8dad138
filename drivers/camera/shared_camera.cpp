#include "drivers/camera/shared_camera.h"

#include <utility>

#include "common/error.h"

namespace prosector {

SharedCamera::SharedCamera(std::string address) : address_(std::move(address)) {
  thread_ = std::make_unique<CameraThread>(
      address_, [this](const Camera& camera) { begin(camera); }, [this](const Frame& frame) { see(frame); });
}

SharedCamera::~SharedCamera() = default;

SharedCamera::Seat::Seat(SharedCamera& camera, CameraThread::Begin begin, CameraThread::See see)
    : camera_(camera), begin_(std::move(begin)), see_(std::move(see)) {
  const std::lock_guard lock(camera_.mutex_);
  camera_.seats_.push_back(this);
}

SharedCamera::Seat::~Seat() {
  const std::lock_guard lock(camera_.mutex_);
  std::erase(camera_.seats_, this);
}

void SharedCamera::begin(const Camera& camera) {
  const std::lock_guard lock(mutex_);
  open_ = &camera;
  for (Seat* seat : seats_) seat->has_begun_ = false;
}

/// Tells every seat, also where another one can't use the picture; then says so.
void SharedCamera::see(const Frame& frame) {
  std::string problem;
  const std::lock_guard lock(mutex_);
  for (Seat* seat : seats_) try {
      if (!std::exchange(seat->has_begun_, true)) seat->begin_(*open_);
      seat->see_(frame);
    } catch (const InputError& error) {
      problem = error.what();
    }
  if (!problem.empty()) throw InputError(problem);
}

}  // namespace prosector
