#pragma once
// A camera shown on a page: its newest image, the detected tags, and a guide that collects images on request.
// All processing runs on the camera's thread.

#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "drivers/camera/calibration/lens_guide.h"
#include "drivers/camera/capture/camera_thread.h"

namespace prosector {

/// Latest image of a camera and its evaluation: detected tags, brightness, image rate, and the state of the
/// guided lens calibration.
struct EvaluatedImage {
  std::shared_ptr<const Image> image;  // null: no image was received yet
  std::uint64_t number = 0;            // counts images from 1
  std::vector<DetectedTag> tags;
  double brightness = 0;  // 0 … 255
  double rate = 0;        // images per second
  LensGuideStep step;     // of the guide, while it is active
  std::set<ImageCell> covered;
};

class CameraWatch {
 public:
  explicit CameraWatch(std::string address);

  CameraState state() const { return thread_.state(); }
  EvaluatedImage picture() const;
  /// Returns the camera's identifier, as its driver reports it; empty while the camera has not been opened
  /// yet.
  std::string identity() const;
  /// Starts a guided collection of the camera's images of `board`, for a lens calibration. Discards earlier
  /// ones.
  void guide(const Board& board);
  void stop_guide();
  std::vector<LensView> views() const;

 private:
  void see(const Frame& frame);

  mutable std::mutex mutex_;        // guards the published state
  mutable std::mutex guide_mutex_;  // held while the guide takes an image
  std::optional<LensGuide> guide_;
  TagDetector finder_{TagDetectorSettings{}};
  EvaluatedImage last_;
  std::string identity_;
  std::int64_t last_ns_ = 0;
  CameraThread thread_;  // last member: it uses the ones above
};

}  // namespace prosector
