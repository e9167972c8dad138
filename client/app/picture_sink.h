#pragma once
// Where pictures go besides the screen: screenshots at their times, a video in real time, and a contact
// sheet.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/app/options.h"
#include "client/app/recorder.h"
#include "client/render/timed_sheet.h"

namespace prosector {

class PictureSink {
 public:
  explicit PictureSink(const ClientOptions& options);

  /// Tells whether a picture taken at `seconds` after joining would be kept.
  bool wants(double seconds) const;
  void take(const Image& image, double seconds);
  /// Asks for the next picture in `file`.
  void ask(const std::filesystem::path& file) { pending_.push_back({file, 0.0}); }
  /// Tells whether a screenshot waits for the last picture.
  bool wants_last() const { return !pending_.empty(); }
  /// Takes the last picture, for screenshots without a time, or whose time never came.
  void finish(const Image& image);
  /// Writes the contact sheet, where one was asked for and there were pictures.
  void finish_sheet();
  /// Tells whether something asked for could not be kept.
  bool failed() const { return failed_; }
  /// Returns what went wrong since the last call, for people.
  std::vector<std::string> take_failures();

 private:
  std::vector<Screenshot> pending_;
  double frames_per_second_;
  bool left_eye_recorded_;  // of pictures that hold both side by side
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
