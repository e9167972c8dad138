#pragma once
// A camera shared by several users of its images, because a camera can be opened only once.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "drivers/camera/capture/camera_thread.h"
#include "drivers/camera/tags/tag_reader.h"

namespace prosector {

/// Problem reported by devices that need the table's board.
inline constexpr const char* unknown_camera_pose =
    "the camera's pose is unknown until the table's board has been detected";

class SharedCamera {
 public:
  /// Starts the camera's thread (CameraThread).
  explicit SharedCamera(std::string address);
  ~SharedCamera();

  /// A subscription to the camera. It receives each image from the next one until it is destroyed.
  class Seat {
   public:
    /// Subscribes after all other seats, or before them if `before_all`.
    Seat(SharedCamera& camera, CameraThread::Begin begin, CameraThread::See see, bool before_all = false);
    ~Seat();
    Seat(const Seat&) = delete;
    Seat& operator=(const Seat&) = delete;

   private:
    friend SharedCamera;
    SharedCamera& camera_;
    const CameraThread::Begin begin_;
    const CameraThread::See see_;
    bool has_begun_ = false;  // whether begin_ was called since the camera was last opened
  };

  /// Sets the camera's pose in the room for the image that seats are processing. Called by the seat that
  /// tracks the table's board; later seats read the pose with room_camera().
  void set_room_camera(const Pose& room_camera);
  /// Returns the pose of OpenCV's camera frame in the room; nothing if no seat set it for the last image.
  std::optional<Pose> room_camera() const;

  /// Returns the tag reader for this camera with the lens file `lens`, shared by all callers. Seats use it
  /// only in their callbacks.
  std::shared_ptr<TagReader> reader(const std::filesystem::path& lens);

  /// Returns the time of the last image that all seats have processed; 0: none yet.
  std::int64_t reported_ns() const { return reported_ns_; }

  const std::string& address() const { return address_; }
  CameraState state() const { return thread_->state(); }

 private:
  void begin(const Camera& camera);
  void see(const Frame& frame);

  const std::string address_;
  std::mutex mutex_;  // guards the next two members, and is held while seats process an image
  std::vector<Seat*> seats_;
  const Camera* open_ = nullptr;  // the camera that was opened last; used only by its thread
  std::atomic<std::int64_t> reported_ns_ = 0;
  mutable std::mutex place_mutex_;  // guards the next two members
  std::optional<Pose> room_camera_;
  std::map<std::filesystem::path, std::weak_ptr<TagReader>> readers_;
  std::unique_ptr<CameraThread> thread_;  // last member, because the thread uses the members above
};

/// Returns `known` if it is the camera at this address, else a new one.
std::shared_ptr<SharedCamera> shared_camera(const std::shared_ptr<SharedCamera>& known,
                                            const std::string& address);

}  // namespace prosector
