#include "drivers/camera/capture/video_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <thread>
#include <utility>

#include "common/clock.h"
#include "common/error.h"
#include "drivers/camera/base/image_reader.h"
#include "drivers/camera/capture/video_reader.h"

namespace prosector {
namespace {

constexpr double default_rate = 30;  // images per second, for files that don't state their rate
constexpr double default_delay =
    0.03;  // s from mid-exposure to delivery, for drivers that don't state the time

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Returns the kernel's name of a video device; empty if unknown.
std::string model_of(const std::string& device) {
  const std::string name = device.substr(device.rfind('/') + 1);
  std::ifstream file("/sys/class/video4linux/" + name + "/name");
  std::string model;
  std::getline(file, model);
  return model;
}

/// A connected device or a stream, which determines the rate.
class LiveVideo final : public Camera {
 public:
  LiveVideo(std::string address, VideoReader video, std::string identity)
      : address_(std::move(address)), identity_(std::move(identity)), video_(std::move(video)) {}

  std::optional<Frame> next(std::chrono::milliseconds) override {
    auto image = video_.read();
    if (!image)
      throw InputError(
          fmt::format("{}: the camera delivers no more images: check that it is connected", address_));
    Frame frame{*std::move(image)};
    // V4L2 states an image's time on the monotonic clock. Other sources state none, or a time on another
    // clock.
    const std::int64_t now_ns = monotonic_ns();
    const auto stated_ns = static_cast<std::int64_t>(1e6 * video_.stated_ms());
    constexpr std::int64_t latest_ns = 500'000'000;
    frame.time_ns = stated_ns > now_ns - latest_ns && stated_ns <= now_ns
                        ? stated_ns
                        : now_ns - static_cast<std::int64_t>(1e9 * default_delay);
    frame.number = number_++;
    return frame;
  }
  std::string identity() const override { return identity_; }

 private:
  std::string address_, identity_;
  VideoReader video_;
  std::uint64_t number_ = 0;
};

/// A video file, played at its own rate and restarted at its end.
class VideoFile final : public Camera {
 public:
  VideoFile(std::string file, VideoReader video) : file_(std::move(file)), video_(std::move(video)) {
    const double file_rate = video_.stated_rate();
    rate_ = file_rate > 0.1 && file_rate < 1000 ? file_rate : default_rate;
    start_ns_ = monotonic_ns();
  }

  std::optional<Frame> next(std::chrono::milliseconds time_limit) override {
    catch_up();
    const std::int64_t wait_ns = due_ns() - monotonic_ns();
    if (wait_ns > time_limit.count() * 1'000'000) {
      std::this_thread::sleep_for(time_limit);
      return std::nullopt;
    }
    if (wait_ns > 0) std::this_thread::sleep_for(std::chrono::nanoseconds(wait_ns));
    auto image = video_.read();
    if (!image && video_.rewind()) image = video_.read();
    if (!image) throw InputError(fmt::format("{}: contains no readable image", file_));
    Frame frame{*std::move(image)};
    frame.time_ns = due_ns();
    frame.number = number_++;
    return frame;
  }
  std::string identity() const override { return file_; }

 private:
  static constexpr std::int64_t longest_catch_up_ns = 100'000'000;

  std::int64_t due_ns() const {
    return start_ns_ + static_cast<std::int64_t>(1e9 * (static_cast<double>(number_) + 0.5) / rate_);
  }
  std::int64_t overdue_ns() const {
    return monotonic_ns() - due_ns() - static_cast<std::int64_t>(1e9 / rate_);
  }

  /// Skips overdue images, so that slow callers get the newest one. If skipping is slower than the video, as
  /// when a short file is reopened repeatedly, playback is delayed instead.
  void catch_up() {
    const std::int64_t begin_ns = monotonic_ns();
    while (overdue_ns() > 0 && monotonic_ns() - begin_ns < longest_catch_up_ns) {
      if (!video_.skip()) video_.rewind();
      ++number_;
    }
    start_ns_ += std::max<std::int64_t>(overdue_ns(), 0);
  }

  std::string file_;
  VideoReader video_;
  double rate_ = default_rate;
  std::int64_t start_ns_ = 0;
  std::uint64_t number_ = 0;
};

/// A still image as a camera that shows it at `default_rate`.
class StillImage final : public Camera {
 public:
  StillImage(std::string file, Image image) : file_(std::move(file)) { frame_.image = std::move(image); }

  std::optional<Frame> next(std::chrono::milliseconds time_limit) override {
    constexpr auto step_ns = static_cast<std::int64_t>(1e9 / default_rate);
    const std::int64_t now_ns = monotonic_ns();
    if (frame_.time_ns > 0) {
      const std::int64_t missed = std::max<std::int64_t>((now_ns - frame_.time_ns) / step_ns, 1);
      const std::int64_t wait_ns = frame_.time_ns + missed * step_ns - now_ns;
      if (wait_ns > time_limit.count() * 1'000'000) {
        std::this_thread::sleep_for(time_limit);
        return std::nullopt;
      }
      if (wait_ns > 0) std::this_thread::sleep_for(std::chrono::nanoseconds(wait_ns));
      frame_.time_ns += missed * step_ns;
      frame_.number += static_cast<std::uint64_t>(missed);
    } else {
      frame_.time_ns = now_ns;
    }
    return frame_;
  }
  std::string identity() const override { return file_; }

 private:
  std::string file_;
  Frame frame_;
};

/// Opens a file as a video if two images can be read from it, else as a still image.
std::unique_ptr<Camera> open_file(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  const bool is_pattern = file.find('%') != std::string::npos;  // a sequence of images, such as image%03d.png
  if (!std::filesystem::exists(status) && !is_pattern)
    throw InputError(fmt::format("{}: cannot be opened as a camera or a video: no such file", file));
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw InputError(fmt::format(
        "{}: cannot be opened as a camera: give a video device, a video or image file, or a stream URL",
        file));
  VideoReader video(file, file, VideoKind::other);
  if (video.is_open()) {
    std::optional<Image> first = video.read();
    if (first && video.read() && video.rewind()) return std::make_unique<VideoFile>(file, std::move(video));
    if (first) return std::make_unique<StillImage>(file, *std::move(first));
  }
  if (auto image = try_read_image(file)) return std::make_unique<StillImage>(file, *std::move(image));
  throw InputError(
      fmt::format("{}: cannot be opened as a camera or a video: it contains no readable image", file));
}

}  // namespace

std::unique_ptr<Camera> open_video(const std::string& address) {
  constexpr std::string_view file_url = "file://";
  const std::string device = is_number(address) ? "/dev/video" + address : address;
  const bool is_device = device.starts_with("/dev/");
  if (device.starts_with(file_url)) return open_file(device.substr(file_url.size()));
  if (!is_device && address.find("://") == std::string::npos) return open_file(device);
  VideoReader video(address, device, is_device ? VideoKind::device : VideoKind::other);
  if (!video.is_open())
    throw InputError(fmt::format(
        "{}: cannot be opened as a camera or a video: check that it exists and that you have permission",
        address));
  const std::string model = is_device ? model_of(device) : "";
  return std::make_unique<LiveVideo>(address, std::move(video), model.empty() ? address : model);
}

}  // namespace prosector
