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

/// Triangles of the user interface that share a texture and a clipping rectangle.
struct InterfaceDraw {
  std::uint32_t texture = 0;
  int left = 0, top = 0, right = 0, bottom = 0;  // pixels, from the top left
  std::vector<InterfaceVertex> vertices;         // three per triangle
};

class InterfacePainter {
 public:
  /// Creates the painter. It stores a reference to `context`, which must outlive it. Throws InputError if an
  /// OpenGL function is missing or a shader does not compile; `shaders` is the folder with the GLSL files,
  /// empty for the embedded ones.
  InterfacePainter(GlContext& context, const std::filesystem::path& shaders);
  ~InterfacePainter();

  /// Creates a texture from RGBA bytes, rows from the top, and returns its id for InterfaceDraw::texture.
  std::uint32_t add_texture(int width, int height, const std::uint8_t* rgba);
  /// Replaces the image of a texture by RGBA bytes, rows from the top. `texture` is an id from add_texture().
  /// The size may change.
  void change_texture(std::uint32_t texture, int width, int height, const std::uint8_t* rgba);
  /// Draws a frame: the triangles of `draws`, in order, on a background of the colour `ground` (sRGB, 0 … 1).
  /// In a window, the context's present() must follow to show it.
  void draw(const Eigen::Vector3f& ground, const std::vector<InterfaceDraw>& draws);
  /// Returns the latest frame that draw() drew, read back from the GPU.
  Image read_pixels() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
