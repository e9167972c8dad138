#pragma once
// Stores rendered frames: screenshots at their times, a video in real time, and a contact sheet.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/app/output/recorder.h"
#include "client/app/run/display_options.h"
#include "client/app/run/output_options.h"
#include "client/render/timed_sheet.h"

namespace prosector {

class FrameOutput {
 public:
  /// Prepares to store frames of this display.
  FrameOutput(const OutputOptions& options, const DisplayOptions& display);

  /// Returns whether a frame at `seconds` after joining would be stored: in a video, in the contact sheet, or
  /// as a screenshot that is due.
  bool wants(double seconds) const;
  void take(const Image& image, double seconds);
  /// Requests that the next frame is stored as a screenshot in `file`.
  void ask(const std::filesystem::path& file) { pending_.push_back({file, 0.0}); }
  /// Returns whether screenshots are still pending, for which the session's last frame must be rendered.
  bool wants_last() const { return !pending_.empty(); }
  /// Stores the session's last frame as all pending screenshots: those requested for the end, or for a time
  /// that was not reached.
  void finish(const Image& image);
  /// Writes the contact sheet (small images of the session in one image) if it was requested and has images.
  void finish_sheet();
  /// Returns whether a requested screenshot, video or contact sheet could not be written.
  bool failed() const { return failed_; }
  /// Returns and removes the error messages on writing screenshots, videos and contact sheets since the last
  /// call.
  std::vector<std::string> take_failures();

 private:
  std::vector<Screenshot> pending_;
  double frames_per_second_;
  bool left_eye_recorded_;  // only the left half of side-by-side frames is recorded
  std::unique_ptr<Recorder> recorder_;
  std::optional<double> recording_since_;
  std::filesystem::path sheet_file_;
  std::optional<TimedSheet> sheet_;
  bool failure_reported_ = false, failed_ = false;
  std::vector<std::string> failures_;

  void write(const Image& image, const std::filesystem::path& file);
  void fail(const std::string& why);
};

}  // namespace prosector
