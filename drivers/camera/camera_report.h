#pragma once
// What a camera's pictures are like, for its owner and for who builds Prosector: rate, lost pictures, light,
// noise, how still a board is found that lies still.

#include <map>
#include <string>
#include <vector>

#include "drivers/camera/camera_calibration.h"
#include "drivers/camera/frame.h"
#include "drivers/camera/tags/tag_reader.h"

namespace prosector {

inline constexpr double least_light = 40;  // of 255: darker pictures are too dark

class CameraReport {
 public:
  /// Begins a report. Without a calibration the lens is guessed.
  explicit CameraReport(std::optional<CameraCalibration> calibration);

  /// Takes the next picture, which was handed out at `now_ns`.
  void take(const Frame& frame, std::int64_t now_ns);
  /// Returns what was seen, line by line.
  std::vector<std::string> lines() const;
  /// Tells whether all of it is as cameras should be.
  bool is_good() const;

 private:
  struct Followed {
    BoardTracker tracker;
    std::vector<Vec3> places;  // m, camera's frame
    int followed = 0;          // by flow alone
  };
  void look_for_boards(const Frame& frame);

  std::optional<CameraCalibration> calibration_;
  TagReader reader_;
  std::vector<Followed> boards_;
  GreyImage last_;
  int width_ = 0, height_ = 0, odd_sizes_ = 0;
  std::uint64_t frames_ = 0, dropped_ = 0, next_number_ = 0;
  int alike_ = 0;                     // pictures that are the one before, bit for bit
  std::vector<double> steps_, ages_;  // s between pictures; from mid-exposure until it was handed out
  std::vector<double> brightness_, noise_, tags_;  // of 255; of 255; how many were read
};

}  // namespace prosector
