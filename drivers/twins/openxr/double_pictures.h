#pragma once
// The textures that a client of the simulated OpenXR runtime draws into, and its pictures as files.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace prosector {

/// A part of a picture, pixels from the lower left.
struct PictureRect {
  int x = 0, y = 0, width = 0, height = 0;
};

class DoublePictures {
 public:
  using FindFunction = void (*(*)(const char* name))();

  /// Makes textures in the current context.
  DoublePictures(FindFunction find, int width, int height, std::int64_t format);
  ~DoublePictures();
  DoublePictures(const DoublePictures&) = delete;
  DoublePictures& operator=(const DoublePictures&) = delete;

  const std::array<unsigned, 3>& textures() const { return textures_; }
  /// Goes on to the next texture, and returns which it is.
  std::uint32_t acquire();
  void release();
  bool acquired() const { return acquired_; }
  bool holds(const PictureRect& part) const;
  /// Writes a part of the texture that was released last.
  void write(const PictureRect& part, const std::string& file) const;

 private:
  FindFunction find_;
  int width_, height_;
  std::array<unsigned, 3> textures_{};
  std::uint32_t next_ = 0, last_ = 0;
  bool acquired_ = false;
};

}  // namespace prosector
