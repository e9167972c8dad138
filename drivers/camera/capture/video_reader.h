#pragma once
// Reads images of a device, a file or a stream with OpenCV.

#include <memory>
#include <optional>
#include <string>

#include "common/image.h"

namespace prosector {

enum class VideoKind { device, other };

/// Video source. Motion-JPEG from files and streams is decoded image by image. OpenCV 4.6 assumes that each
/// image has the first one's size, and repeats old images where it differs.
class VideoReader {
 public:
  /// Opens `from`; `address` is the user's name for it, used in messages. Requests 640 × 480 images at 30 per
  /// second from a device. Throws InputError if images are too large.
  VideoReader(std::string address, std::string from, VideoKind kind);
  ~VideoReader();
  VideoReader(VideoReader&& other) noexcept;

  /// Reopens the source at its beginning. Returns whether that succeeded.
  bool rewind();
  bool is_open() const;
  /// Returns the image rate that the source states, 1/s; it may be wrong.
  double stated_rate() const;
  /// Returns the last image's time as the source states it, ms, on an unspecified clock.
  double stated_ms() const;

  /// Skips an image. Returns false at the end.
  bool skip();
  /// Returns the next image. Returns nothing at the end, or after many undecodable images in a row. Throws
  /// InputError if images don't have 8 bits in 1, 3 or 4 channels, or are too large.
  std::optional<Image> read();

  static constexpr double device_rate = 30;  // rate requested from devices, images per second

 private:
  struct Video;
  std::string address_;
  std::unique_ptr<Video> video_;
};

}  // namespace prosector
