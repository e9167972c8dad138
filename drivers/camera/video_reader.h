#pragma once
// Images of a device, a file or a stream, decoded one by one by OpenCV.

#include <memory>
#include <optional>
#include <string>

#include "common/image.h"

namespace prosector {

enum class VideoKind { device, other };

/// Motion-JPEG from files and streams is decoded image by image: OpenCV 4.6 takes each image for as large as
/// the first one, and repeats old images where one is not.
class VideoReader {
 public:
  /// Opens `from`, which the user called `address`. A device is asked for 640 × 480 images, 30 a second.
  /// Throws InputError where images are too large.
  VideoReader(std::string address, std::string from, VideoKind kind);
  ~VideoReader();
  VideoReader(VideoReader&& other) noexcept;

  /// Opens it anew, at its beginning. Returns whether that worked.
  bool rewind();
  bool is_open() const;
  /// Returns the images a second as the file says it; it may be any number.
  double stated_rate() const;
  /// Returns the last image's time as the source says it, ms; it may be on any clock.
  double stated_ms() const;

  /// Skips an image. Returns whether there was one.
  bool skip();
  /// Returns the next image; nothing at the end, or where many in a row can't be decoded. Throws InputError
  /// for images of other than 8 bits in 1, 3 or 4 channels, and for too large ones.
  std::optional<Image> read();

  static constexpr double device_rate = 30;  // that devices are asked for, images a second

 private:
  struct Video;
  std::string address_;
  std::unique_ptr<Video> video_;
};

}  // namespace prosector
