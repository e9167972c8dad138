#pragma once
// Boards with printed markers in a camera's view as a tracker's stations: wrists, head, instrument, each with
// its board.

#include <array>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "drivers/camera/base/one_euro.h"
#include "drivers/camera/devices/board_tracking_config.h"
#include "drivers/camera/devices/camera_config.h"
#include "drivers/camera/devices/shared_camera.h"
#include "drivers/camera/tags/standard_boards.h"
#include "drivers/camera/tags/tag_reader.h"
#include "drivers/device/health_monitor.h"
#include "drivers/device/pose_chain.h"

namespace prosector {

/// Estimator of a camera's pose in the room from a static printed board whose pose in the room is known.
class CameraPoseEstimator {
 public:
  CameraPoseEstimator(const std::string& board, const Pose& room_board);
  const Board& board() const { return tracker_.board(); }
  /// Updates the camera's pose in the room from the board in this image. If the board is not detected by its
  /// tags or print, the pose stays as it was.
  void update(const TagImage& picture, const TagOptics& optics);
  /// Returns the smoothed pose of OpenCV's camera frame (x right, y down, z forward) in the room frame;
  /// nothing before the first detection.
  const std::optional<Pose>& room_camera() const { return room_camera_; }

 private:
  Pose room_board_;
  BoardTracker tracker_;
  PoseFilter filter_;
  std::optional<Pose> room_camera_;
};

class TagsDevice final : public Device {
 public:
  /// Opens the camera on a separate thread, or uses the camera shared with other devices if the configuration
  /// has one at this address. Throws InputError if a board's file, the lens file or the file of the
  /// distortion map is unreadable.
  TagsDevice(const std::string& camera, const Placement& placement, const CameraConfig& config,
             const BoardTrackingConfig& tags);

  void poll(std::vector<DeviceSample>& out) override;
  DeviceStatus status() const override;
  int descriptor() const override { return -1; }

 private:
  /// Tracking state of one station, which is a body part or instrument that carries a printed board.
  struct Station {
    std::size_t index;
    BoardTracker tracker;
    Pose worn;  // pose of the tracked body part or instrument in the board's frame
    PoseFilter filter;
    std::uint64_t records = 0;
  };
  void begin(const Camera& camera);
  void see(const Frame& frame);
  std::optional<Pose> room_camera() const;
  DeviceSample sample_of(Station& station, const TrackedBoard& seen, std::int64_t time_ns) const;

  const std::shared_ptr<SharedCamera> camera_;

  // Used by the camera's thread only.
  const std::shared_ptr<TagReader> reader_;
  int changes_ = 0;  // reader changes that the trackers have processed
  std::vector<Station> stations_;
  std::optional<CameraPoseEstimator> place_;
  PoseChain chain_;

  mutable std::mutex mutex_;  // guards the members below
  std::deque<DeviceSample> found_;
  std::vector<std::int64_t> frames_ns_;  // capture times of images since the last poll
  std::int64_t seen_ns_ = 0;             // capture time of the last image with a station's board
  std::string warning_;                  // warning about the detections, for the user
  bool is_guessed_ = false;              // the lens parameters are guessed

  HealthMonitor health_;  // used by the polling thread only, as is opened_
  std::uint64_t opened_ = 0;
  std::unique_ptr<SharedCamera::Seat> seat_;  // last member: it uses those above
};

/// Opens a tracker of printed boards on a camera. `path` is the camera's address, such as "0" in the device
/// address "tags:0".
std::unique_ptr<Device> open_tags(const std::string& path, const Placement& placement,
                                  const CameraConfig& config, const BoardTrackingConfig& tags);

}  // namespace prosector
