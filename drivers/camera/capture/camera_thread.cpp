#include "drivers/camera/capture/camera_thread.h"

#include <exception>

namespace prosector {
namespace {

using namespace std::chrono_literals;
constexpr auto time_limit = 100ms;
constexpr auto retry = 500ms;

}  // namespace

CameraThread::CameraThread(std::string address, Begin begin, See see)
    : address_(std::move(address)),
      begin_(std::move(begin)),
      see_(std::move(see)),
      thread_([this] { run(); }) {}

CameraThread::~CameraThread() {
  ends_ = true;
  thread_.join();
}

CameraState CameraThread::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

void CameraThread::report(const std::string& problem) {
  const std::lock_guard lock(mutex_);
  state_.problem = problem;
}

void CameraThread::run() {
  while (!ends_) {
    try {
      const std::unique_ptr<Camera> camera = open_camera(address_, begun_ns_);
      {
        const std::lock_guard lock(mutex_);
        state_.is_open = true;
        ++state_.opened;
        state_.problem.clear();
      }
      begin_(*camera);
      while (!ends_) look(*camera);
    } catch (const std::exception& error) {
      // A camera's errors must not end the session.
      const std::lock_guard lock(mutex_);
      state_.is_open = false;
      state_.problem = error.what();
    }
    for (auto waited = 0ms; waited < retry && !ends_; waited += 20ms) std::this_thread::sleep_for(20ms);
  }
}

void CameraThread::look(Camera& camera) {
  const std::optional<Frame> frame = camera.next(time_limit);
  if (!frame) return;
  {
    const std::lock_guard lock(mutex_);
    ++state_.frames;
    state_.last_ns = frame->time_ns;
    state_.width = frame->image.width;
    state_.height = frame->image.height;
  }
  try {
    see_(*frame);
    report("");
  } catch (const std::exception& error) {
    report(error.what());
  }
}

}  // namespace prosector
