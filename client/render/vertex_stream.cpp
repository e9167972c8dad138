#include "client/render/vertex_stream.h"

#include <stdexcept>

namespace prosector {

VertexStream::VertexStream(const Gl& gl, const std::vector<int>& attributes) : gl_(gl) {
  for (const int floats : attributes) stride_ += sizeof(float) * static_cast<std::size_t>(floats);
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.BindVertexArray(vertex_array_);
  gl_.GenBuffers(1, &buffer_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  std::size_t offset = 0;
  for (GLuint k = 0; k < attributes.size(); ++k) {
    gl_.EnableVertexAttribArray(k);
    gl_.VertexAttribPointer(k, attributes[k], GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride_),
                            reinterpret_cast<const void*>(offset));
    offset += sizeof(float) * static_cast<std::size_t>(attributes[k]);
  }
  gl_.BindVertexArray(0);
}

VertexStream::~VertexStream() {
  gl_.DeleteVertexArrays(1, &vertex_array_);
  gl_.DeleteBuffers(1, &buffer_);
}

void VertexStream::draw(const void* vertices, std::size_t count, std::size_t bytes) const {
  if (bytes != stride_)
    throw std::logic_error("VertexStream: the size of a vertex differs from that of the stream's attributes");
  if (count == 0) return;
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * bytes), vertices, GL_DYNAMIC_DRAW);
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(count));
}

}  // namespace prosector
