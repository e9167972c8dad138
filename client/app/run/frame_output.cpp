#include "client/app/run/frame_output.h"

#include <algorithm>
#include <utility>

#include "common/error.h"

namespace prosector {
namespace {

Image left_half(const Image& image) {
  Image out{image.width / 2, image.height, {}};
  for (int y = 0; y < image.height; ++y)
    out.rgb.insert(out.rgb.end(), image.pixel(0, y), image.pixel(out.width, y));
  return out;
}

}  // namespace

FrameOutput::FrameOutput(const OutputOptions& options, const DisplayOptions& display)
    : pending_(options.screenshots),
      frames_per_second_(display.frames_per_second),
      left_eye_recorded_(display.kind == Display::openxr),
      sheet_file_(options.sheet) {
  if (!sheet_file_.empty()) sheet_.emplace(options.sheet_interval);
  if (options.video.empty()) return;
  if (left_eye_recorded_)
    recorder_ = std::make_unique<Recorder>(options.video, 0, 0, frames_per_second_);
  else
    recorder_ = std::make_unique<Recorder>(options.video, display.width, display.height, frames_per_second_);
}

bool FrameOutput::wants(double seconds) const {
  return recorder_ || (sheet_ && sheet_->wants(seconds)) ||
         std::any_of(pending_.begin(), pending_.end(),
                     [&](const Screenshot& s) { return s.at && *s.at <= seconds; });
}

void FrameOutput::take(const Image& image, double seconds) {
  for (const Screenshot& s : pending_)
    if (s.at && *s.at <= seconds) write(image, s.file);
  std::erase_if(pending_, [&](const Screenshot& s) { return s.at && *s.at <= seconds; });

  if (sheet_ && sheet_->wants(seconds)) {
    sheet_->take(image, seconds);
    if (sheet_->pictures() == 1) finish_sheet();  // so that a missing folder is reported immediately
  }
  if (!recorder_) return;
  if (!recording_since_) recording_since_ = seconds;
  // A video has a fixed frame rate: a slow frame is repeated for the time that it took.
  const auto due = static_cast<std::size_t>((seconds - *recording_since_) * frames_per_second_) + 1;
  std::optional<Image> left;
  if (left_eye_recorded_) left = left_half(image);
  const Image& recorded = left ? *left : image;
  while (recorder_->frames() < due && recorder_->failure().empty()) recorder_->add(recorded);
  if (!recorder_->failure().empty() && !std::exchange(failure_reported_, true)) fail(recorder_->failure());
}

void FrameOutput::finish(const Image& image) {
  for (const Screenshot& s : pending_) write(image, s.file);
  pending_.clear();
}

void FrameOutput::finish_sheet() {
  if (sheet_ && sheet_->pictures() > 0) write(sheet_->sheet(), sheet_file_);
}

void FrameOutput::write(const Image& image, const std::filesystem::path& file) {
  try {
    write_png(image, file);
  } catch (const InputError& error) {
    fail(error.what());
  }
}

void FrameOutput::fail(const std::string& why) {
  failures_.push_back(why);
  failed_ = true;
}

std::vector<std::string> FrameOutput::take_failures() {
  return std::exchange(failures_, {});
}

}  // namespace prosector
