#pragma once
// Textures into which a client of the simulated OpenXR runtime renders, and their export as image files.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace prosector {

/// Rectangle of an image: lower left corner, width and height, in pixels counted from the image's lower left.
struct ImageRect {
  int x = 0, y = 0, width = 0, height = 0;
};

class SimulatedSwapchain {
 public:
  using FindFunction = void (*(*)(const char* name))();

  /// Creates three textures of this size and OpenGL format in the current OpenGL context. `find` looks up
  /// OpenGL functions by name.
  SimulatedSwapchain(FindFunction find, int width, int height, std::int64_t format);
  ~SimulatedSwapchain();
  SimulatedSwapchain(const SimulatedSwapchain&) = delete;
  SimulatedSwapchain& operator=(const SimulatedSwapchain&) = delete;

  const std::array<unsigned, 3>& textures() const { return textures_; }
  /// Acquires the next texture for the client to render into, and returns the texture's index.
  std::uint32_t acquire();
  void release();
  bool acquired() const { return acquired_; }
  bool holds(const ImageRect& part) const;
  /// Writes a part of the texture that the client released last to an image file (PPM).
  void write(const ImageRect& part, const std::string& file) const;

 private:
  FindFunction find_;
  int width_, height_;
  std::array<unsigned, 3> textures_{};
  std::uint32_t next_ = 0, last_ = 0;
  bool acquired_ = false;
};

}  // namespace prosector
