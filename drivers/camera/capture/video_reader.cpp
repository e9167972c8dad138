#include "drivers/camera/capture/video_reader.h"

#include <fmt/format.h>

#include <new>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <utility>

#include "common/error.h"
#include "drivers/camera/base/image_reader.h"

namespace prosector {
namespace {

constexpr int device_width = 640, device_height = 480;

/// Checks the image size. Throws InputError for images that are too large to process.
void check_size(const std::string& address, double width, double height) {
  if (width * height > static_cast<double>(max_image_pixels))
    throw InputError(fmt::format(
        "{}: the images have {:.0f} × {:.0f} pixels; at most {} pixels can be used: scale the video down",
        address, width, height, max_image_pixels));
}

bool starts_as_jpeg(const cv::Mat& packet) {
  return packet.total() > 2 && packet.type() == CV_8UC1 && packet.data[0] == 0xFF && packet.data[1] == 0xD8;
}

/// Decodes an image; returns an empty matrix on failure.
cv::Mat decoded(const cv::Mat& packet) {
  try {
    return cv::imdecode(packet, cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    return {};
  }
}

Image image_of(const cv::Mat& bgr) {
  cv::Mat rgb;
  cv::cvtColor(bgr, rgb, bgr.channels() == 1 ? cv::COLOR_GRAY2RGB : cv::COLOR_BGR2RGB);
  Image out{rgb.cols, rgb.rows, {}};
  out.rgb.assign(rgb.datastart, rgb.dataend);
  return out;
}

}  // namespace

struct VideoReader::Video {
  std::string from;
  VideoKind kind;
  bool is_jpeg = false;  // `capture` returns encoded images
  cv::VideoCapture capture;

  bool open() {
    try {
      if (!capture.open(from, kind == VideoKind::device ? cv::CAP_V4L2 : cv::CAP_ANY)) return false;
    } catch (const cv::Exception&) {
      return false;
    }
    return !is_jpeg || give_packets();
  }

  /// Sets OpenCV to return encoded images.
  bool give_packets() { return capture.set(cv::CAP_PROP_FORMAT, -1); }

  void set_up_device() {
    capture.set(cv::CAP_PROP_FOURCC, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'));
    capture.set(cv::CAP_PROP_FRAME_WIDTH, device_width);
    capture.set(cv::CAP_PROP_FRAME_HEIGHT, device_height);
    capture.set(cv::CAP_PROP_FPS, device_rate);
    capture.set(cv::CAP_PROP_BUFFERSIZE, 1);
  }

  cv::Mat next() {
    cv::Mat out;
    try {
      if (!capture.read(out)) return {};
    } catch (const cv::Exception&) {
      return {};
    }
    return out;
  }

  /// Returns the next decodable image; empty at the end or after many undecodable ones.
  cv::Mat next_decoded() {
    if (!is_jpeg) return next();
    constexpr int most_broken = 30;
    for (int broken = 0; broken < most_broken; ++broken) {
      const cv::Mat packet = next();
      if (packet.empty()) break;
      if (cv::Mat image = decoded(packet); !image.empty()) return image;
    }
    return {};
  }
};

VideoReader::VideoReader(std::string address, std::string from, VideoKind kind)
    : address_(std::move(address)),
      video_(std::make_unique<Video>(Video{std::move(from), kind, false, cv::VideoCapture()})) {
  // OpenCV prints to the terminal why each of its readers rejects a file. Our own errors name the file
  // instead.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  if (!rewind()) return;
  if (kind == VideoKind::device) {
    video_->set_up_device();
    return;
  }
  check_size(address_, video_->capture.get(cv::CAP_PROP_FRAME_WIDTH),
             video_->capture.get(cv::CAP_PROP_FRAME_HEIGHT));
  video_->is_jpeg = video_->give_packets() && starts_as_jpeg(video_->next());
  rewind();
}

VideoReader::~VideoReader() = default;
VideoReader::VideoReader(VideoReader&& other) noexcept = default;

bool VideoReader::rewind() {
  return video_->open();
}

bool VideoReader::is_open() const {
  return video_->capture.isOpened();
}

double VideoReader::stated_rate() const {
  return video_->capture.get(cv::CAP_PROP_FPS);
}

double VideoReader::stated_ms() const {
  return video_->capture.get(cv::CAP_PROP_POS_MSEC);
}

bool VideoReader::skip() {
  try {
    return video_->capture.grab();
  } catch (const cv::Exception&) {
    return false;
  }
}

std::optional<Image> VideoReader::read() {
  try {
    const cv::Mat image = video_->next_decoded();
    if (image.empty()) return std::nullopt;
    check_size(address_, image.cols, image.rows);
    const int channels = image.channels();
    if (image.depth() != CV_8U || (channels != 1 && channels != 3 && channels != 4))
      throw InputError(
          fmt::format("{}: the images have {} channels of {} bits; 8 bits in 1, 3 or 4 channels are allowed: "
                      "convert the video",
                      address_, channels, 8 * image.elemSize1()));
    return image_of(image);
  } catch (const std::bad_alloc&) {
    throw InputError(fmt::format("{}: the images do not fit into memory: scale the video down", address_));
  }
}

}  // namespace prosector
