#pragma once
// Camera view of the table for augmented reality: undistorted images with the camera pose of each.

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "client/language/catalogue.h"
#include "common/image.h"
#include "drivers/camera/devices/camera_config.h"
#include "drivers/camera/devices/shared_camera.h"
#include "drivers/camera/tags/tag_reader.h"

namespace prosector {

/// Undistorted image of a camera, with its time and the poses and light that were detected in it.
struct UndistortedImage {
  std::shared_ptr<const Image> image;
  Lens bent, straight;           // lens models of the camera, and of `image`
  std::int64_t time_ns = 0;      // time of exposure
  std::uint64_t number = 0;      // sequence number, from 1
  std::optional<Pose> room_eye;  // camera pose: x right, y up, −z ahead; nullopt: the board is not detected
  std::optional<Pose> room_tablet = {};   // pose of the tablet's panel; nullopt: not detected
  std::optional<Vec3> paper = {};         // light on the board's white paper, see paper_light()
  std::optional<Pose> room_phantom = {};  // pose of the phantom with a board; nullopt: not detected yet
};

/// Board of tags by which the camera detects an object: the user's tablet or a phantom. `mount` is the pose
/// of the object on the board.
struct ObjectBoard {
  std::string board;  // name of a known board, or a file
  Pose mount;  // pose of the panel at its wearing position, or of the phantom's shape, in the board frame
};

class CameraSight {
 public:
  /// Starts to undistort the camera's images and to detect boards of tags in them. `config` gives the
  /// camera's lens, the board on the table and its room pose; `tablet` and `phantom`, the boards of these
  /// objects. Throws InputError if the file of a lens or board can't be read.
  CameraSight(std::shared_ptr<SharedCamera> camera, const CameraConfig& config,
              const std::optional<ObjectBoard>& tablet, const std::optional<ObjectBoard>& phantom = {});

  /// Waits up to `time_limit` for an image that no earlier call returned. Returns the newest image, after a
  /// timeout again the last one; null if there is none yet.
  std::shared_ptr<const UndistortedImage> next(std::chrono::milliseconds time_limit);
  /// Returns whether all consumers of the shared camera have processed the image captured at `time_ns`
  /// (monotonic clock).
  bool all_analysed(std::int64_t time_ns) const { return camera_->reported_ns() >= time_ns; }
  /// Returns a message for the user, in the language of `words`, about the present problem: a camera error,
  /// missing images, or an undetected table board. Returns an empty string if there is none.
  std::string warning(const Catalogue& words = {}) const;
  const Pose& room_board() const { return room_board_; }

  static constexpr double held =
      0.5;  // s for which the last pose remains valid while the board isn't detected

 private:
  void see(const Frame& frame);
  void find_boards(UndistortedImage& out, const TagImage& picture);

  std::shared_ptr<SharedCamera> camera_;
  const Pose room_board_;

  // The following members are used only by the camera thread.
  const std::shared_ptr<TagReader> reader_;
  BoardTracker tracker_;
  std::optional<BoardTracker> tablet_;
  const Pose tablet_panel_;  // in its board's frame
  std::optional<BoardTracker> phantom_;
  const Pose board_phantom_;
  std::optional<Pose> room_phantom_;  // last detected pose
  int changes_ = 0;                   // reader's change count known to the trackers
  std::optional<Pose> last_eye_;
  std::optional<Vec3> paper_;
  std::int64_t seen_ns_ = 0;  // time of the last image with the board

  mutable std::mutex mutex_;  // guards newest_ and taken_
  std::condition_variable image_available_;
  std::shared_ptr<const UndistortedImage> newest_;
  std::uint64_t taken_ = 0;  // number of the last returned image

  SharedCamera::Seat seat_;  // declared last: it uses the members above
};

}  // namespace prosector
