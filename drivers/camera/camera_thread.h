#pragma once
// A camera's pictures, looked at on a thread of their own: opened, lost, and opened again by itself.

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "drivers/camera/camera.h"

namespace prosector {

/// What a camera does, for people.
struct CameraState {
  bool is_open = false;
  std::uint64_t opened = 0;  // times
  std::uint64_t frames = 0;
  std::int64_t last_ns = 0;  // of the newest picture
  int width = 0, height = 0;
  std::string problem;  // why it isn't open; empty: nothing is wrong
};

class CameraThread {
 public:
  using Begin = std::function<void(const Camera&)>;  // each time it was opened
  using See = std::function<void(const Frame&)>;     // each picture; may throw: why it says nothing

  /// Starts. Both functions are called on its thread. Throws nothing: what is wrong is in state().
  CameraThread(std::string address, Begin begin, See see);
  ~CameraThread();

  CameraState state() const;

 private:
  void run();
  void look(Camera& camera);
  void tell(const std::string& problem);

  const std::int64_t begun_ns_ = monotonic_ns();
  const std::string address_;
  const Begin begin_;
  const See see_;
  mutable std::mutex mutex_;
  CameraState state_;
  std::atomic<bool> ends_ = false;
  std::thread thread_;  // last: it uses what is above
};

}  // namespace prosector
