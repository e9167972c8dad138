#pragma once
// Converts a camera's images to the form that board trackers use, with the camera's lens.

#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "drivers/camera/base/camera_calibration.h"
#include "drivers/camera/base/undistorter.h"
#include "drivers/camera/tags/board_tracker.h"

namespace prosector {

/// Reader that detects tags in a camera's images and undistorts them. Several trackers may share one reader
/// on one thread; each image is then processed only once.
class TagReader {
 public:
  /// Reads the camera's lens file. If `lens` is empty, the lens is the one that the camera states, as a
  /// synthetic camera does, or a guessed one. Throws InputError if the file cannot be read.
  explicit TagReader(const std::filesystem::path& lens);
  /// Takes the camera's calibration. With nullopt, the lens is the one that the camera states, or a guessed
  /// one.
  explicit TagReader(std::optional<CameraCalibration> calibration);

  /// Prepares for the images of a newly opened camera. If no calibration was given, the lens is the one that
  /// this camera states, or a guessed one.
  void begin(const Camera& camera);
  /// Detects tags in a camera image and undistorts it. Caches the result, so that a second call for the same
  /// image is cheap. Throws InputError if the image's aspect ratio is not that of the lens.
  const TagImage& read(const Frame& frame);

  /// Registers a board that should be visible. While some of its tags are not detected, images are searched
  /// more thoroughly.
  void expect(const Board& board);

  /// Returns the lenses of the distorted and undistorted image and the camera's response, as used for the
  /// last image.
  const TagOptics& optics() const { return optics_; }
  const Undistorter& straightener() const { return *straightener_; }
  bool is_guessed() const { return !calibration_; }
  /// Returns the number of times that the lens or the image size has changed. After a change, positions
  /// tracked in earlier images are no longer valid.
  int changes() const { return changes_; }

 private:
  void make_ready(int width, int height);
  void find_missing_tags(TagImage& picture);

  static constexpr double thorough_interval = 1;  // s, least time between thorough searches of whole images
  static constexpr double remembered = 0.5;       // s, time for which a tag is searched at its last position
  /// A tag detected in a recent image, with the time of that image.
  struct Lately {
    DetectedTag tag;
    std::int64_t time_ns;
  };

  const bool is_calibrated_;  // a calibration was given to the constructor
  std::optional<CameraCalibration> calibration_;
  TagDetector finder_{TagDetectorSettings{}}, thorough_finder_{TagDetectorSettings{1}};
  std::set<int> expected_;  // codes
  std::vector<Lately> recent_tags_;
  std::optional<std::int64_t> thorough_ns_;  // time of the last image that was searched thoroughly
  TagOptics optics_;
  std::unique_ptr<Undistorter> straightener_;
  int width_ = 0, height_ = 0;  // size of the images it is prepared for
  TagImage picture_;
  std::optional<std::uint64_t> number_;  // number of the frame in `picture_`; nullopt: none
  int changes_ = 0;
};

}  // namespace prosector
