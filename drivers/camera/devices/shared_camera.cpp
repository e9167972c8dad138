#include "drivers/camera/devices/shared_camera.h"

#include <exception>
#include <utility>

#include "common/error.h"

namespace prosector {

SharedCamera::SharedCamera(std::string address) : address_(std::move(address)) {
  thread_ = std::make_unique<CameraThread>(
      address_, [this](const Camera& camera) { begin(camera); }, [this](const Frame& frame) { see(frame); });
}

SharedCamera::~SharedCamera() = default;

SharedCamera::Seat::Seat(SharedCamera& camera, CameraThread::Begin begin, CameraThread::See see,
                         bool before_all)
    : camera_(camera), begin_(std::move(begin)), see_(std::move(see)) {
  const std::lock_guard lock(camera_.mutex_);
  camera_.seats_.insert(before_all ? camera_.seats_.begin() : camera_.seats_.end(), this);
}

SharedCamera::Seat::~Seat() {
  const std::lock_guard lock(camera_.mutex_);
  std::erase(camera_.seats_, this);
}

void SharedCamera::set_room_camera(const Pose& room_camera) {
  const std::lock_guard lock(place_mutex_);
  room_camera_ = room_camera;
}

std::optional<Pose> SharedCamera::room_camera() const {
  const std::lock_guard lock(place_mutex_);
  return room_camera_;
}

std::shared_ptr<TagReader> SharedCamera::reader(const std::filesystem::path& lens) {
  const std::lock_guard lock(place_mutex_);
  std::shared_ptr<TagReader> known = readers_[lens].lock();
  if (!known) readers_[lens] = known = std::make_shared<TagReader>(lens);
  return known;
}

void SharedCamera::begin(const Camera& camera) {
  const std::lock_guard lock(mutex_);
  open_ = &camera;
  for (Seat* seat : seats_) seat->has_begun_ = false;
}

/// Passes an image to every seat, even if one of them throws. Then throws InputError with the last problem.
void SharedCamera::see(const Frame& frame) {
  std::string problem;
  {
    const std::lock_guard place_lock(place_mutex_);
    room_camera_.reset();
  }
  const std::lock_guard lock(mutex_);
  for (Seat* seat : seats_) try {
      if (!std::exchange(seat->has_begun_, true)) seat->begin_(*open_);
      seat->see_(frame);
    } catch (const std::exception& error) {
      problem = error.what();
    }
  reported_ns_ = frame.time_ns;
  if (!problem.empty()) throw InputError(problem);
}

std::shared_ptr<SharedCamera> shared_camera(const std::shared_ptr<SharedCamera>& known,
                                            const std::string& address) {
  return known && known->address() == address ? known : std::make_shared<SharedCamera>(address);
}

}  // namespace prosector
