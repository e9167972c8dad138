#include "client/app/output/recorder.h"

#include <fmt/format.h>

#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "common/error.h"

namespace prosector {
namespace {

// OpenCV's writers do not report a full disk; they continue and leave a broken file. Therefore the free space
// is checked before each frame.
constexpr std::uintmax_t least_free_bytes = 8u << 20;

int codec_of(const std::filesystem::path& file) {
  if (file.extension() == ".avi") return cv::VideoWriter::fourcc('M', 'J', 'P', 'G');
  if (file.extension() == ".mp4") return cv::VideoWriter::fourcc('m', 'p', '4', 'v');
  throw InputError(fmt::format("video {}: the ending must be .avi or .mp4", file.string()));
}

std::string no_room(const std::filesystem::path& file) {
  std::error_code error;
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  const auto space = std::filesystem::space(folder, error);
  if (error) return fmt::format("{}: {}", folder.string(), error.message());
  if (space.available < least_free_bytes)
    return fmt::format("{}: only {} KiB free on the disk; recording a video needs 8 MiB", folder.string(),
                       space.available >> 10);
  return "";
}

}  // namespace

struct Recorder::Impl {
  std::filesystem::path file;
  double frames_per_second = 0;
  cv::VideoWriter writer;
  cv::Size size;
  std::size_t frames = 0;
  std::string failure;

  void open() {
    if (!writer.open(file.string(), codec_of(file), frames_per_second, size))
      throw InputError(fmt::format(
          "video {}: cannot be written; check that the folder exists and is writable", file.string()));
  }
};

Recorder::Recorder(const std::filesystem::path& file, int width, int height, double frames_per_second)
    : impl_(std::make_unique<Impl>()) {
  impl_->file = file;
  impl_->frames_per_second = frames_per_second;
  (void)codec_of(file);
  if (std::string why = no_room(file); !why.empty())
    throw InputError(fmt::format("video {}: {}", file.string(), why));
  impl_->size = cv::Size(width, height);
  if (!impl_->size.empty()) impl_->open();
}

Recorder::~Recorder() = default;

void Recorder::add(const Image& image) {
  if (!impl_->failure.empty()) return;
  if (std::string why = no_room(impl_->file); !why.empty()) {
    impl_->failure = fmt::format("recording ended after {} frames: {}", impl_->frames, why);
    impl_->writer.release();
    return;
  }
  if (impl_->size.empty()) {
    impl_->size = cv::Size(image.width, image.height);
    try {
      impl_->open();
    } catch (const InputError& error) {
      impl_->failure = error.what();
      return;
    }
  }
  const cv::Mat rgb(image.height, image.width, CV_8UC3, const_cast<std::uint8_t*>(image.rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  // A video has a fixed size; the frames of a resized window do not.
  if (bgr.size() != impl_->size) cv::resize(bgr, bgr, impl_->size, 0, 0, cv::INTER_AREA);
  impl_->writer.write(bgr);
  ++impl_->frames;
}

const std::string& Recorder::failure() const {
  return impl_->failure;
}
std::size_t Recorder::frames() const {
  return impl_->frames;
}

}  // namespace prosector
