#include "drivers/camera/video_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <thread>

#include "common/clock.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr int wanted_width = 640, wanted_height = 480;
constexpr double wanted_rate = 30;
constexpr double usual_delay =
    0.03;  // s from mid-exposure until a driver hands a picture out, where it doesn't say

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Returns what the kernel calls a video device; empty where it doesn't say.
std::string model_of(const std::string& device) {
  const std::string name = device.substr(device.rfind('/') + 1);
  std::ifstream file("/sys/class/video4linux/" + name + "/name");
  std::string model;
  std::getline(file, model);
  return model;
}

Frame frame_of(const cv::Mat& bgr) {
  cv::Mat rgb;
  if (bgr.channels() == 1)
    cv::cvtColor(bgr, rgb, cv::COLOR_GRAY2RGB);
  else
    cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
  Frame frame;
  frame.image.width = rgb.cols;
  frame.image.height = rgb.rows;
  frame.image.rgb.assign(rgb.datastart, rgb.dataend);
  return frame;
}

/// A device that is plugged in, or a stream: it sets the pace.
class LiveVideo final : public Camera {
 public:
  LiveVideo(std::string address, cv::VideoCapture video, std::string identity)
      : address_(std::move(address)), identity_(std::move(identity)), video_(std::move(video)) {}

  std::optional<Frame> next(std::chrono::milliseconds) override {
    cv::Mat picture;
    if (!video_.read(picture) || picture.empty() || picture.depth() != CV_8U)
      throw InputError(fmt::format("{}: gives no more pictures: is it plugged in?", address_));
    Frame frame = frame_of(picture);
    // V4L2 tells a picture's time on the monotonic clock; others tell none, or a time of their own.
    const std::int64_t now_ns = monotonic_ns();
    const auto told_ns = static_cast<std::int64_t>(1e6 * video_.get(cv::CAP_PROP_POS_MSEC));
    constexpr std::int64_t latest_ns = 500'000'000;
    frame.time_ns = told_ns > now_ns - latest_ns && told_ns <= now_ns
                        ? told_ns
                        : now_ns - static_cast<std::int64_t>(1e9 * usual_delay);
    frame.number = number_++;
    return frame;
  }
  std::string identity() const override { return identity_; }

 private:
  std::string address_, identity_;
  cv::VideoCapture video_;
  std::uint64_t number_ = 0;
};

/// A file: its own rate sets the pace, and it begins anew at its end.
class FileVideo final : public Camera {
 public:
  FileVideo(std::string file, cv::VideoCapture video) : file_(std::move(file)), video_(std::move(video)) {
    const double told = video_.get(cv::CAP_PROP_FPS);
    rate_ = told > 0.1 && told < 1000 ? told : wanted_rate;
    start_ns_ = monotonic_ns();
  }

  std::optional<Frame> next(std::chrono::milliseconds patience) override {
    const auto due_ns = [&] {
      return start_ns_ + static_cast<std::int64_t>(1e9 * (static_cast<double>(number_) + 0.5) / rate_);
    };
    // Who comes late gets the newest.
    while (due_ns() + static_cast<std::int64_t>(1e9 / rate_) < monotonic_ns()) {
      if (!video_.grab()) rewind();
      ++number_;
    }
    const std::int64_t wait_ns = due_ns() - monotonic_ns();
    if (wait_ns > patience.count() * 1'000'000) {
      std::this_thread::sleep_for(patience);
      return std::nullopt;
    }
    if (wait_ns > 0) std::this_thread::sleep_for(std::chrono::nanoseconds(wait_ns));
    cv::Mat picture;
    if (!video_.read(picture) || picture.empty()) {
      rewind();
      if (!video_.read(picture) || picture.empty())
        throw InputError(fmt::format("{}: holds no picture that can be read", file_));
    }
    Frame frame = frame_of(picture);
    frame.time_ns = due_ns();
    frame.number = number_++;
    return frame;
  }
  std::string identity() const override { return file_; }

 private:
  void rewind() { video_.open(file_); }

  std::string file_;
  cv::VideoCapture video_;
  double rate_ = wanted_rate;
  std::int64_t start_ns_ = 0;
  std::uint64_t number_ = 0;
};

}  // namespace

std::unique_ptr<Camera> open_video(const std::string& address) {
  const std::string device = is_number(address) ? "/dev/video" + address : address;
  const bool is_device = device.starts_with("/dev/");
  const bool is_stream = address.find("://") != std::string::npos;
  cv::VideoCapture video;
  try {
    video.open(device, is_device ? cv::CAP_V4L2 : cv::CAP_ANY);
  } catch (const cv::Exception&) {
    // It says so below.
  }
  if (!video.isOpened()) throw InputError(fmt::format("{}: can't be opened as a camera or a video", address));
  if (!is_device && !is_stream) return std::make_unique<FileVideo>(device, std::move(video));
  if (is_device) {
    video.set(cv::CAP_PROP_FOURCC, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'));
    video.set(cv::CAP_PROP_FRAME_WIDTH, wanted_width);
    video.set(cv::CAP_PROP_FRAME_HEIGHT, wanted_height);
    video.set(cv::CAP_PROP_FPS, wanted_rate);
    video.set(cv::CAP_PROP_BUFFERSIZE, 1);
  }
  const std::string model = is_device ? model_of(device) : "";
  return std::make_unique<LiveVideo>(address, std::move(video), model.empty() ? address : model);
}

}  // namespace prosector
