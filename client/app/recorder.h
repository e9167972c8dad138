#pragma once
// Video files of what was drawn.

#include <filesystem>
#include <memory>

#include "client/render/renderer.h"

namespace prosector {

/// A film of frames at a fixed rate. A full disk ends the recording with a message, never the session.
class Recorder {
 public:
  /// Begins a `.avi` (motion JPEG) or `.mp4`; of 0 × 0 pixels: as large as its first picture. Throws
  /// InputError for another ending, or when the file cannot be begun.
  Recorder(const std::filesystem::path& file, int width, int height, double frames_per_second);
  ~Recorder();

  void add(const Image& image);
  /// Returns what ended the recording early; empty while all is well.
  const std::string& failure() const;
  std::size_t frames() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
