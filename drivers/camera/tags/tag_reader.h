#pragma once
// Makes of a camera's pictures what trackers of boards look at: by the lens that is known of it.

#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "drivers/camera/camera_calibration.h"
#include "drivers/camera/straightener.h"
#include "drivers/camera/tags/board_tracker.h"

namespace prosector {

/// Several may look by one reader, on one thread: each picture is read once.
class TagReader {
 public:
  /// Reads the lens' file; empty: it is the synthetic camera's own, or guessed. Throws InputError where it
  /// can't be read.
  explicit TagReader(const std::filesystem::path& lens);
  /// Takes a lens that is known; nullopt: it is the camera's own, or guessed.
  explicit TagReader(std::optional<CameraCalibration> calibration);

  /// Takes a camera that was opened.
  void begin(const Camera& camera);
  /// Reads a picture, and holds it until the next one. Throws InputError where its shape isn't that of the
  /// lens.
  const TagPicture& read(const Frame& frame);

  /// Says which board should be seen: where tags of it are missing, pictures are read more thoroughly.
  void expect(const Board& board);

  /// Returns how the last picture was read.
  const TagOptics& optics() const { return optics_; }
  const Straightener& straightener() const { return *straightener_; }
  bool is_guessed() const { return !calibration_; }
  /// Returns how often pictures were read in another way than the one before: what was tracked is elsewhere.
  int changes() const { return changes_; }

 private:
  void make_ready(int width, int height);
  void find_more(TagPicture& picture);

  static constexpr double thorough_pause = 1;  // s between two thorough searches of whole pictures
  static constexpr double remembered = 0.5;    // s that a tag is looked for where it was
  /// A tag that was seen lately.
  struct Lately {
    SeenTag tag;
    std::int64_t time_ns;
  };

  const bool is_calibrated_;  // by who made this
  std::optional<CameraCalibration> calibration_;
  TagFinder finder_{TagFinderSettings{}}, thorough_finder_{TagFinderSettings{1}};
  std::set<int> expected_;  // codes
  std::vector<Lately> lately_;
  std::optional<std::int64_t> thorough_ns_;  // of the last picture that was searched thoroughly
  TagOptics optics_;
  std::unique_ptr<Straightener> straightener_;
  int width_ = 0, height_ = 0;  // of pictures that it is ready for
  TagPicture picture_;
  std::optional<std::uint64_t> number_;  // of the frame that `picture_` is of; nullopt: none
  int changes_ = 0;
};

}  // namespace prosector
