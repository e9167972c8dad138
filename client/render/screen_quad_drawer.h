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
  /// Draws only those parts of the triangles that surfaces occlude, with the given opacity (0 … 1), over
  /// these surfaces.
  void draw_hidden(const std::vector<ScreenVertex>& vertices, float opacity) const;

 private:
  const Gl& gl_;
  ShaderProgram program_;
  VertexStream stream_;
};

}  // namespace prosector
