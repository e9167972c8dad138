#pragma once
// Reads images of a device, a file or a stream with OpenCV.

#include <memory>
#include <optional>
#include <string>

#include "common/image.h"

namespace prosector {

enum class VideoKind { device, other };

/// Reader of images from a video device, file or stream. Motion-JPEG from files and streams is decoded image
/// by image, because OpenCV 4.6 assumes that each image has the first one's size, and repeats old images
/// where it differs.
class VideoReader {
 public:
  /// Opens the video source `from`; `address` is the name that the user gave it, for messages. Requests 640 ×
  /// 480 images at 30 per second from a device. Throws InputError if the images of a file or stream are too
  /// large.
  VideoReader(std::string address, std::string from, VideoKind kind);
  ~VideoReader();
  VideoReader(VideoReader&& other) noexcept;

  /// Reopens the video source at its beginning. Returns whether that succeeded.
  bool rewind();
  bool is_open() const;
  /// Returns the image rate that the video source states, in images per second; it may be wrong.
  double stated_rate() const;
  /// Returns the time of the last image as the video source states it, in ms on a clock of unspecified
  /// origin.
  double stated_ms() const;

  /// Skips the next image without decoding it. Returns false at the end of the video.
  bool skip();
  /// Returns the next image of the video. Returns nothing at the end, or after many undecodable images in a
  /// row. Throws InputError if images do not have 8 bits in 1, 3 or 4 channels, or are too large.
  std::optional<Image> read();

  static constexpr double device_rate = 30;  // rate requested from devices, images per second

 private:
  struct Video;
  std::string address_;
  std::unique_ptr<Video> video_;
};

}  // namespace prosector
