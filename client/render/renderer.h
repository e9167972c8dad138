#pragma once
// Draws a DrawList with OpenGL 3.3 core. The only consumer of DrawList, and the only code with shaders.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "client/render/gl_context.h"
#include "client/view/draw_list.h"

namespace prosector {

/// 8-bit sRGB, rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

class Renderer {
 public:
  /// `shaders` is the folder with the GLSL files. Throws InputError with file and line when one does not
  /// compile.
  Renderer(GlContext& context, const std::filesystem::path& shaders);
  ~Renderer();

  void draw(const DrawList& list);
  Image read_pixels();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Throws InputError when the file cannot be written.
void write_png(const Image& image, const std::filesystem::path& file);

}  // namespace prosector
