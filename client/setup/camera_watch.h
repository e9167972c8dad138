#pragma once
// A camera that a page shows: its newest picture, the tags in it, and a guide that takes pictures once it is
// asked. All of it is reckoned on the camera's thread.

#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "drivers/camera/calibration/lens_guide.h"
#include "drivers/camera/camera_thread.h"

namespace prosector {

/// What was seen last.
struct WatchedPicture {
  std::shared_ptr<const Image> image;  // none: no picture came yet
  std::uint64_t number = 0;            // counts pictures from 1
  std::vector<SeenTag> tags;
  double brightness = 0;  // of 255
  double rate = 0;        // pictures a second
  LensGuideStep step;     // of the guide, while it is asked
  std::set<PictureCell> covered;
};

class CameraWatch {
 public:
  explicit CameraWatch(std::string address);

  CameraState state() const { return thread_.state(); }
  WatchedPicture picture() const;
  /// Returns what tells the camera from others; empty: it wasn't open yet.
  std::string identity() const;
  /// Begins to keep views of a board, anew.
  void guide(const Board& board);
  void stop_guide();
  std::vector<LensView> views() const;

 private:
  void see(const Frame& frame);

  mutable std::mutex mutex_;        // of what is told
  mutable std::mutex guide_mutex_;  // held while a picture is taken into the guide
  std::optional<LensGuide> guide_;
  TagFinder finder_{TagFinderSettings{}};
  WatchedPicture last_;
  std::string identity_;
  std::int64_t last_ns_ = 0;
  CameraThread thread_;  // last: it uses what is above
};

}  // namespace prosector
