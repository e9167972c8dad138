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

/// Reader of tags in a camera's images. Several trackers may share one reader on one thread; each image is
/// read once.
class TagReader {
 public:
  /// Reads the lens file. If `lens` is empty, the lens is the synthetic camera's own or guessed. Throws
  /// InputError if the file can't be read.
  explicit TagReader(const std::filesystem::path& lens);
  /// Takes a calibration; with nullopt the lens is the camera's own or guessed.
  explicit TagReader(std::optional<CameraCalibration> calibration);

  /// Resets the lens for a newly opened camera.
  void begin(const Camera& camera);
  /// Reads an image and caches the result until the next one. Throws InputError if the image's aspect ratio
  /// isn't that of the lens.
  const TagImage& read(const Frame& frame);

  /// Registers a board that should be visible. While tags of it are missing, images are searched more
  /// thoroughly.
  void expect(const Board& board);

  /// Returns the lenses and response used for the last image.
  const TagOptics& optics() const { return optics_; }
  const Undistorter& straightener() const { return *straightener_; }
  bool is_guessed() const { return !calibration_; }
  /// Returns how often the lens or image size changed. After a change, earlier tracked positions are invalid.
  int changes() const { return changes_; }

 private:
  void make_ready(int width, int height);
  void find_missing_tags(TagImage& picture);

  static constexpr double thorough_interval = 1;  // s, least time between thorough searches of whole images
  static constexpr double remembered = 0.5;       // s, time for which a tag is searched at its last position
  /// A recently detected tag.
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
