#pragma once
// Stores rendered frames: screenshots at their times, a video in real time, and a contact sheet.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/app/output/recorder.h"
#include "client/app/run/options.h"
#include "client/render/timed_sheet.h"

namespace prosector {

class FrameOutput {
 public:
  explicit FrameOutput(const ClientOptions& options);

  /// Reports whether a frame at `seconds` after joining would be stored.
  bool wants(double seconds) const;
  void take(const Image& image, double seconds);
  /// Requests a screenshot of the next frame in `file`.
  void ask(const std::filesystem::path& file) { pending_.push_back({file, 0.0}); }
  /// Reports whether a screenshot waits for the last frame.
  bool wants_last() const { return !pending_.empty(); }
  /// Stores the last frame for the screenshots without a time or with a time not reached.
  void finish(const Image& image);
  /// Writes the contact sheet if it was requested and has images.
  void finish_sheet();
  /// Reports whether anything requested could not be written.
  bool failed() const { return failed_; }
  /// Returns the error messages since the last call.
  std::vector<std::string> take_failures();

 private:
  std::vector<Screenshot> pending_;
  double frames_per_second_;
  bool left_eye_recorded_;  // only the left half of side-by-side frames is recorded
  std::unique_ptr<Recorder> recorder_;
  std::optional<double> recording_since_;
  std::filesystem::path sheet_file_;
  std::optional<TimedSheet> sheet_;
  bool failure_told_ = false, failed_ = false;
  std::vector<std::string> failures_;

  void write(const Image& image, const std::filesystem::path& file);
  void fail(const std::string& why);
};

}  // namespace prosector
