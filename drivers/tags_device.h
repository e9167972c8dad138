#pragma once
// Printed boards before a camera as a tracker's stations: wrists, a head, an instrument, each with its board.

#include <array>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "drivers/camera/one_euro.h"
#include "drivers/camera/shared_camera.h"
#include "drivers/camera/tags/known_boards.h"
#include "drivers/camera/tags/tag_reader.h"
#include "drivers/health_monitor.h"
#include "drivers/pose_chain.h"

namespace prosector {

/// Where a camera stands in the room, by a board that lies still.
class CameraPlace {
 public:
  CameraPlace(const std::string& board, const Pose& room_board);
  const Board& board() const { return tracker_.board(); }
  /// Looks for the board; where it isn't seen the camera is believed to stand where it stood.
  void update(const TagPicture& picture, const TagOptics& optics);
  /// Returns OpenCV's camera frame in the room; nothing before the board was seen.
  const std::optional<Pose>& room_camera() const { return room_camera_; }

 private:
  Pose room_board_;
  BoardTracker tracker_;
  PoseFilter filter_;
  std::optional<Pose> room_camera_;
};

class TagsDevice final : public Device {
 public:
  /// Opens the camera on a thread of its own, unless the configuration has one that others see by, too.
  /// Throws InputError where a board, a lens' file or a field map can't be read.
  TagsDevice(const std::string& camera, const DeviceConfig& config);

  void poll(std::vector<DeviceSample>& out) override;
  DeviceStatus status() const override;
  int descriptor() const override { return -1; }

 private:
  /// What is tracked as one station.
  struct Station {
    std::size_t index;
    BoardTracker tracker;
    Pose worn;  // of what wears it, in the board's frame
    PoseFilter filter;
    std::uint64_t records = 0;
  };
  void begin(const Camera& camera);
  void see(const Frame& frame);
  std::optional<Pose> room_camera() const;
  DeviceSample sample_of(Station& station, const TrackedBoard& seen, std::int64_t time_ns) const;

  const std::shared_ptr<SharedCamera> camera_;

  // Only the camera's thread uses these.
  const std::shared_ptr<TagReader> reader_;
  int changes_ = 0;  // of the reader that trackers know of
  std::vector<Station> stations_;
  std::optional<CameraPlace> place_;
  PoseChain chain_;

  mutable std::mutex mutex_;  // guards what follows
  std::deque<DeviceSample> found_;
  std::vector<std::int64_t> frames_ns_;  // of pictures since the last poll
  std::int64_t seen_ns_ = 0;             // of the last picture that showed a station's board
  std::string trouble_;                  // what is odd about what is seen
  bool is_guessed_ = false;              // the lens

  HealthMonitor health_;  // of who polls, as is the next
  std::uint64_t opened_ = 0;
  std::unique_ptr<SharedCamera::Seat> seat_;  // last: it uses what is above
};

/// Opens boards before a camera, "tags:0".
std::unique_ptr<Device> open_tags(const std::string& path, const DeviceConfig& config);

}  // namespace prosector
