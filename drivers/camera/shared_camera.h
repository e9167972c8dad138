#pragma once
// One camera for several who look at its pictures: a camera can be opened once only.

#include <algorithm>
#include <memory>
#include <vector>

#include "drivers/camera/camera_thread.h"

namespace prosector {

class SharedCamera {
 public:
  /// Starts the camera's thread, as CameraThread does.
  explicit SharedCamera(std::string address);
  ~SharedCamera();

  /// A place to look from. It sees from the next picture until it is gone.
  class Seat {
   public:
    Seat(SharedCamera& camera, CameraThread::Begin begin, CameraThread::See see);
    ~Seat();
    Seat(const Seat&) = delete;
    Seat& operator=(const Seat&) = delete;

   private:
    friend SharedCamera;
    SharedCamera& camera_;
    const CameraThread::Begin begin_;
    const CameraThread::See see_;
    bool has_begun_ = false;  // since the camera was last opened
  };

  const std::string& address() const { return address_; }
  CameraState state() const { return thread_->state(); }

 private:
  void begin(const Camera& camera);
  void see(const Frame& frame);

  const std::string address_;
  std::mutex mutex_;  // guards what follows, and is held while seats are told
  std::vector<Seat*> seats_;
  const Camera* open_ = nullptr;          // while its thread tells of a picture
  std::unique_ptr<CameraThread> thread_;  // last: it uses what is above
};

}  // namespace prosector
