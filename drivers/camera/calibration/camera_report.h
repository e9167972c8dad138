#pragma once
// Statistics of a camera's images, for the camera's owner and for developers: rate, dropped images,
// brightness, noise, and the scatter of a resting board's position.

#include <map>
#include <string>
#include <vector>

#include "drivers/camera/base/camera_calibration.h"
#include "drivers/camera/base/frame.h"
#include "drivers/camera/tags/tag_reader.h"

namespace prosector {

inline constexpr double least_light = 40;  // mean grey value, 0 to 255; darker images are too dark

class CameraReport {
 public:
  /// Starts a report on a camera's images. Without a calibration the lens is guessed, which affects the
  /// reported board positions.
  explicit CameraReport(std::optional<CameraCalibration> calibration);

  /// Adds the camera's next image to the statistics. `now_ns` is the time at which the camera delivered it.
  void take(const Frame& frame, std::int64_t now_ns);
  /// Returns the statistics of the camera's images as lines of text: rate, drops, brightness, noise, tags and
  /// scatter of boards.
  std::vector<std::string> lines() const;
  /// Reports whether the rate, dropped images, sizes, brightness and noise of the camera's images are all
  /// acceptable.
  bool is_good() const;

 private:
  struct Followed {
    BoardTracker tracker;
    std::vector<Vec3> places;  // m, positions in the camera's frame
    int followed = 0;          // number of images in which only optical flow found the board
  };
  void look_for_boards(const Frame& frame);

  std::optional<CameraCalibration> calibration_;
  TagReader reader_;
  std::vector<Followed> boards_;
  GreyImage last_;
  int width_ = 0, height_ = 0, wrong_size_images_ = 0;
  std::uint64_t frames_ = 0, dropped_ = 0, next_number_ = 0;
  int alike_ = 0;                     // number of images that are bitwise equal to the one before
  std::vector<double> steps_, ages_;  // s: image times; delay from mid-exposure to delivery
  std::vector<double> brightness_, noise_, tags_;  // grey values, 0 to 255; grey values; tags read per image
};

}  // namespace prosector
