#pragma once
// Reads a camera on its own thread: opens it, and reopens it after it was lost.

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "drivers/camera/base/camera.h"

namespace prosector {

/// State of a camera, for display: whether it is open, its counts and size of images, and its problem.
struct CameraState {
  bool is_open = false;
  std::uint64_t opened = 0;  // number of times the camera was opened
  std::uint64_t frames = 0;
  std::int64_t last_ns = 0;  // time of the newest image
  int width = 0, height = 0;
  std::string problem;  // reason why the camera isn't open or why processing failed; empty: no error
};

class CameraThread {
 public:
  using Begin = std::function<void(const Camera&)>;  // called each time the camera is opened
  using See = std::function<void(const Frame&)>;  // called with each image; an exception's text becomes the
                                                  // camera's problem

  /// Starts a thread that opens the camera at `address` and reads its images. The thread calls `begin` each
  /// time it has opened the camera, and `see` with each image. Never throws; errors are reported in state().
  CameraThread(std::string address, Begin begin, See see);
  ~CameraThread();

  CameraState state() const;

 private:
  void run();
  void look(Camera& camera);
  void report(const std::string& problem);

  const std::int64_t begun_ns_ = monotonic_ns();
  const std::string address_;
  const Begin begin_;
  const See see_;
  mutable std::mutex mutex_;
  CameraState state_;
  std::atomic<bool> ends_ = false;
  std::thread thread_;  // last member, because the thread uses the members above
};

}  // namespace prosector
