#pragma once
// Draws controls, their letters and pictures flat over the whole picture, without a scene.

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "client/render/gl_context.h"
#include "client/render/image.h"

namespace prosector {

struct InterfaceVertex {
  Eigen::Vector2f at;     // pixels of the picture, from its top left
  Eigen::Vector2f place;  // in its texture, 0 … 1 from the top left
  Eigen::Vector4f shade;  // sRGB and opacity, 0 … 1
};

/// Triangles with one texture, and the rectangle outside which nothing of them is drawn.
struct InterfaceDraw {
  std::uint32_t texture = 0;
  int left = 0, top = 0, right = 0, bottom = 0;  // pixels, from the top left
  std::vector<InterfaceVertex> vertices;         // three a triangle
};

class InterfacePainter {
 public:
  /// Takes a `context` that outlives the painter. Throws InputError as the renderer does.
  InterfacePainter(GlContext& context, const std::filesystem::path& shaders);
  ~InterfacePainter();

  /// Makes a texture of RGBA bytes, rows from the top, and returns what it is called from now on.
  std::uint32_t add_texture(int width, int height, const std::uint8_t* rgba);
  /// Gives a texture another picture, which may have another size.
  void change_texture(std::uint32_t texture, int width, int height, const std::uint8_t* rgba);
  /// Draws on a ground of that colour (sRGB); in a window, shows it there, too (call present()).
  void draw(const Eigen::Vector3f& ground, const std::vector<InterfaceDraw>& draws);
  /// Reads what was drawn last.
  Image read_pixels() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
