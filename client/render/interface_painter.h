#pragma once
// Draws controls, their text and images over the whole frame, without a scene.

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "client/render/gl_context.h"
#include "client/render/image.h"

namespace prosector {

struct InterfaceVertex {
  Eigen::Vector2f at;     // pixels of the frame, from its top left
  Eigen::Vector2f place;  // texture coordinates, 0 … 1 from the top left
  Eigen::Vector4f shade;  // sRGB and opacity, 0 … 1
};

/// Triangles with one texture, and their clipping rectangle.
struct InterfaceDraw {
  std::uint32_t texture = 0;
  int left = 0, top = 0, right = 0, bottom = 0;  // pixels, from the top left
  std::vector<InterfaceVertex> vertices;         // three per triangle
};

class InterfacePainter {
 public:
  /// Stores a reference to `context`, which must outlive the painter. Throws InputError as the renderer does.
  InterfacePainter(GlContext& context, const std::filesystem::path& shaders);
  ~InterfacePainter();

  /// Makes a texture of RGBA bytes, rows from the top, and returns its id.
  std::uint32_t add_texture(int width, int height, const std::uint8_t* rgba);
  /// Replaces a texture's image; its size may change.
  void change_texture(std::uint32_t texture, int width, int height, const std::uint8_t* rgba);
  /// Draws on a background of the given colour (sRGB). In a window, call present() to show the result.
  void draw(const Eigen::Vector3f& ground, const std::vector<InterfaceDraw>& draws);
  /// Reads the latest frame.
  Image read_pixels() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
