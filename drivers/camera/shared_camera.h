#pragma once
// One camera for several who look at its pictures: a camera can be opened once only.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "drivers/camera/camera_thread.h"
#include "drivers/camera/tags/tag_reader.h"

namespace prosector {

/// What devices say that need the table's board.
inline constexpr const char* unknown_place =
    "the table's board hasn't been seen yet, so nobody knows where the camera is";

class SharedCamera {
 public:
  /// Starts the camera's thread, as CameraThread does.
  explicit SharedCamera(std::string address);
  ~SharedCamera();

  /// A place to look from. It sees from the next picture until it is gone.
  class Seat {
   public:
    /// Sits down behind all others, or before them.
    Seat(SharedCamera& camera, CameraThread::Begin begin, CameraThread::See see, bool before_all = false);
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

  /// Says where the camera stood when it took the picture that seats are told of now. For who sees so; others
  /// are told after it.
  void put_place(const Pose& room_camera);
  /// Returns that place, OpenCV's camera frame in the room; nothing where nobody said so of the last picture.
  std::optional<Pose> room_camera() const;

  /// Returns what reads boards in its pictures by that lens' file: one for all who ask. Seats use it while
  /// they are told of a picture.
  std::shared_ptr<TagReader> reader(const std::filesystem::path& lens);

  /// Returns the time of the last picture that all seats were told of; 0: none was.
  std::int64_t told_ns() const { return told_ns_; }

  const std::string& address() const { return address_; }
  CameraState state() const { return thread_->state(); }

 private:
  void begin(const Camera& camera);
  void see(const Frame& frame);

  const std::string address_;
  std::mutex mutex_;  // guards what follows, and is held while seats are told
  std::vector<Seat*> seats_;
  const Camera* open_ = nullptr;  // while its thread tells of a picture
  std::atomic<std::int64_t> told_ns_ = 0;
  mutable std::mutex place_mutex_;  // guards the next two
  std::optional<Pose> room_camera_;
  std::map<std::filesystem::path, std::weak_ptr<TagReader>> readers_;
  std::unique_ptr<CameraThread> thread_;  // last: it uses what is above
};

/// Returns the camera at the address: `known`, where it is that one, else a new one.
std::shared_ptr<SharedCamera> shared_camera(const std::shared_ptr<SharedCamera>& known,
                                            const std::string& address);

}  // namespace prosector
