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

/// Message for the user while a camera device has no poses because the board that gives the camera's pose in
/// the room has not been detected yet.
inline constexpr const char* unknown_camera_pose =
    "the camera's pose is unknown until the table's board has been detected";

class SharedCamera {
 public:
  /// Starts the thread that opens the camera at `address` and passes its images to the subscribers.
  explicit SharedCamera(std::string address);
  ~SharedCamera();

  /// Subscription of one user of a shared camera's images. It receives every image from the next one on,
  /// until it is destroyed.
  class Seat {
   public:
    /// Subscribes to the camera's images. The callbacks run on the camera's thread: `begin` before the first
    /// image after each opening of the camera, `see` for each image. Each image is passed to this
    /// subscription after all others, or before them if `before_all`.
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

  /// Sets the camera's pose in the room at the image that the subscribers are processing. The subscriber that
  /// tracks the table's board calls it; later subscribers read the pose with room_camera().
  void set_room_camera(const Pose& room_camera);
  /// Returns the pose of OpenCV's camera frame (x right, y down, z forward) in the room; nothing if no
  /// subscriber set it for the last image.
  std::optional<Pose> room_camera() const;

  /// Returns the tag reader for this camera's images with the lens file `lens`. All callers with the same
  /// file share one reader. Subscribers may use it only in their callbacks.
  std::shared_ptr<TagReader> reader(const std::filesystem::path& lens);

  /// Returns the capture time (ns) of the last image that all subscribers have processed; 0 if there is none
  /// yet.
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

/// Returns the shared camera `known` if it is the camera at this address. Otherwise opens the camera at this
/// address and returns it.
std::shared_ptr<SharedCamera> shared_camera(const std::shared_ptr<SharedCamera>& known,
                                            const std::string& address);

}  // namespace prosector
