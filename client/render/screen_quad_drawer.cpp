#include "client/render/screen_quad_drawer.h"

#include <cstddef>

namespace prosector {

ScreenQuadDrawer::ScreenQuadDrawer(const Gl& gl, const std::filesystem::path& shaders,
                                   const std::string& shader)
    : gl_(gl), program_(gl, shaders, shader) {
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.BindVertexArray(vertex_array_);
  gl_.GenBuffers(1, &buffer_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  constexpr GLsizei stride = sizeof(ScreenVertex);
  gl_.EnableVertexAttribArray(0);
  gl_.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, nullptr);
  gl_.EnableVertexAttribArray(1);
  gl_.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride,
                          reinterpret_cast<const void*>(offsetof(ScreenVertex, color)));
  gl_.EnableVertexAttribArray(2);
  gl_.VertexAttribPointer(2, 4, GL_FLOAT, GL_FALSE, stride,
                          reinterpret_cast<const void*>(offsetof(ScreenVertex, pen)));
  gl_.BindVertexArray(0);
}

ScreenQuadDrawer::~ScreenQuadDrawer() {
  gl_.DeleteVertexArrays(1, &vertex_array_);
  gl_.DeleteBuffers(1, &buffer_);
}

void ScreenQuadDrawer::draw(const std::vector<ScreenVertex>& vertices, bool depth_test) const {
  if (vertices.empty()) return;
  (depth_test ? gl_.Enable : gl_.Disable)(GL_DEPTH_TEST);
  program_.use();
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(ScreenVertex)),
                 vertices.data(), GL_DYNAMIC_DRAW);
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
}

}  // namespace prosector
