#pragma once
// Video file writer.

#include <filesystem>
#include <memory>

#include "client/render/renderer.h"

namespace prosector {

/// Video of frames at a fixed rate. A full disk ends the recording with a message, but not the session.
class Recorder {
 public:
  /// Begins an `.avi` (motion JPEG) or `.mp4` file. With 0 × 0 pixels the first image sets the size. Throws
  /// InputError for another extension, or if the file cannot be created.
  Recorder(const std::filesystem::path& file, int width, int height, double frames_per_second);
  ~Recorder();

  void add(const Image& image);
  /// Returns why the recording ended early; empty: no error.
  const std::string& failure() const;
  std::size_t frames() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
