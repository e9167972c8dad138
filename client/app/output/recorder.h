#pragma once
// Video file writer.

#include <filesystem>
#include <memory>

#include "client/render/renderer.h"

namespace prosector {

/// Video file of frames at a fixed rate. A full disk ends the recording, with the reason in failure(), but
/// not the session.
class Recorder {
 public:
  /// Creates an `.avi` (motion JPEG) or `.mp4` video file with frames of `width` × `height` pixels. With 0 ×
  /// 0 the first image sets the size. Throws InputError for another extension, or if the file cannot be
  /// created.
  Recorder(const std::filesystem::path& file, int width, int height, double frames_per_second);
  ~Recorder();

  void add(const Image& image);
  /// Returns the reason why the recording ended early, for instance a full disk; empty if there was no error.
  const std::string& failure() const;
  std::size_t frames() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
