#pragma once
// Draws ScreenVertex triangles with their vertex colours. Private to client/render.

#include <filesystem>
#include <vector>

#include "client/render/screen_quads.h"
#include "client/render/shader_program.h"
#include "client/render/vertex_stream.h"

namespace prosector {

class ScreenQuadDrawer {
 public:
  ScreenQuadDrawer(const Gl& gl, const std::filesystem::path& shaders);

  void draw(const std::vector<ScreenVertex>& vertices, bool depth_test) const;
  /// Draws the occluded parts of the triangles with the given opacity.
  void draw_hidden(const std::vector<ScreenVertex>& vertices, float opacity) const;

 private:
  const Gl& gl_;
  ShaderProgram program_;
  VertexStream stream_;
};

}  // namespace prosector
