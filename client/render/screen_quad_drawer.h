#pragma once
// Draws ScreenVertex triangles with one shader. Private to client/render.

#include <filesystem>
#include <vector>

#include "client/render/screen_quads.h"
#include "client/render/shader_program.h"

namespace prosector {

class ScreenQuadDrawer {
 public:
  /// Compiles `shader`: "screen" covers, "text" blends with what is there by how much of a pixel the line
  /// takes.
  ScreenQuadDrawer(const Gl& gl, const std::filesystem::path& shaders, const std::string& shader);
  ~ScreenQuadDrawer();
  ScreenQuadDrawer(const ScreenQuadDrawer&) = delete;
  ScreenQuadDrawer& operator=(const ScreenQuadDrawer&) = delete;

  void draw(const std::vector<ScreenVertex>& vertices, bool depth_test) const;

 private:
  const Gl& gl_;
  ShaderProgram program_;
  GLuint vertex_array_ = 0, buffer_ = 0;
};

}  // namespace prosector
