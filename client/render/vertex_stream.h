#pragma once
// Triangles that are rebuilt for each frame. Private to client/render.

#include <vector>

#include "client/render/gl.h"

namespace prosector {

class VertexStream {
 public:
  /// Creates an empty vertex buffer. `attributes` is the number of floats of each vertex attribute, in order;
  /// a vertex consists only of these floats.
  VertexStream(const Gl& gl, const std::vector<int>& attributes);
  ~VertexStream();
  VertexStream(const VertexStream&) = delete;
  VertexStream& operator=(const VertexStream&) = delete;

  /// Uploads the vertices, three per triangle, and draws them with the shader program in use.
  template <class Vertex>
  void draw(const std::vector<Vertex>& vertices) const {
    static_assert(std::is_trivially_destructible_v<Vertex> && alignof(Vertex) % alignof(float) == 0);
    draw(vertices.data(), vertices.size(), sizeof(Vertex));
  }

 private:
  void draw(const void* vertices, std::size_t count, std::size_t bytes) const;

  const Gl& gl_;
  GLuint vertex_array_ = 0, buffer_ = 0;
  std::size_t stride_ = 0;  // bytes
};

}  // namespace prosector
