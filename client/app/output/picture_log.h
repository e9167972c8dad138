#pragma once
// Log of rendering times and data ages of augmented camera frames, for latency measurements.

#include <cstdint>
#include <filesystem>
#include <fstream>

namespace prosector {

/// Times of one rendered frame and of the data that it shows, in ns of the monotonic clock, for latency
/// measurements.
struct FrameTimes {
  std::int64_t drawn_ns = 0;
  std::int64_t camera_ns = 0;  // camera image in the background: middle of its exposure
  std::int64_t hand_ns = 0;    // poses of the user's own hands; 0: none
  double tick = 0;             // displayed server tick
};

class PictureLog {
 public:
  /// Opens a CSV file with the columns drawn_ns, camera_ns, hand_ns and tick. Throws InputError if it cannot
  /// be written.
  explicit PictureLog(const std::filesystem::path& file);
  void add(const FrameTimes& times);

 private:
  std::ofstream out_;
};

}  // namespace prosector
