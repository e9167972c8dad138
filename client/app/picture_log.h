#pragma once
// When each picture was drawn that looks through a camera, and how old what it shows is: for latency.

#include <cstdint>
#include <filesystem>
#include <fstream>

namespace prosector {

/// Times of one picture, of monotonic_ns().
struct PictureTimes {
  std::int64_t drawn_ns = 0;
  std::int64_t camera_ns = 0;  // the camera's picture below it: the middle of its exposure
  std::int64_t hand_ns = 0;    // the user's own hands in it; 0: there are none
  double tick = 0;             // of the server, that it shows
};

class PictureLog {
 public:
  /// Opens a CSV file: drawn_ns, camera_ns, hand_ns, tick. Throws InputError where it cannot be written.
  explicit PictureLog(const std::filesystem::path& file);
  void add(const PictureTimes& times);

 private:
  std::ofstream out_;
};

}  // namespace prosector
