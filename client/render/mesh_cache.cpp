#include "client/render/mesh_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "client/render/curvature.h"

namespace prosector {
namespace {

using Points = std::vector<Eigen::Vector3f>;
static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));

void check(const DrawMesh& mesh) {
  const std::size_t n = mesh.positions.size();
  const auto refuse = [&](const char* what) {
    throw std::invalid_argument(
        fmt::format("DrawMesh {}: the {} do not match the mesh's {} positions", mesh.id, what, n));
  };
  if (mesh.normals.size() != n) refuse("normals");
  if (!mesh.rest_positions.empty() && mesh.rest_positions.size() != n) refuse("rest positions");
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t index : triangle)
      if (index >= n) refuse("triangles");
}

template <class T>
GLsizeiptr bytes(const std::vector<T>& v) {
  return static_cast<GLsizeiptr>(v.size() * sizeof(T));
}

/// Uploads the curvature of the rest shape, which changes only with the triangles.
void upload_curvature(const Gl& gl, GLuint& buffer, const DrawMesh& mesh) {
  const std::vector<float> hollows =
      curvature_of(mesh.rest_positions.empty() ? mesh.positions : mesh.rest_positions, mesh.triangles);
  if (buffer == 0) gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, bytes(hollows), hollows.data(), GL_STATIC_DRAW);
  gl.EnableVertexAttribArray(hollow_attribute);
  gl.VertexAttribPointer(hollow_attribute, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void upload_points(const Gl& gl, GLuint& buffer, GLuint attribute, const Points& points, GLenum usage) {
  if (buffer == 0) gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, bytes(points), points.data(), usage);
  gl.EnableVertexAttribArray(attribute);
  gl.VertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
}

}  // namespace

MeshCache::~MeshCache() {
  for (auto& [id, entry] : entries_) release(entry);
}

void MeshCache::begin_frame() {
  ++frame_;
  std::erase_if(entries_, [this](const auto& item) {
    const bool unused = item.second.last_frame + frames_kept < frame_;
    if (unused) release(item.second);
    return unused;
  });
}

const MeshCache::Entry& MeshCache::upload(const DrawMesh& mesh, const std::shared_ptr<const Detail>& detail) {
  Entry& entry = upload_mesh(mesh);
  if (entry.detail != detail) {
    entry.detail = detail;
    upload_triangles(mesh, entry);
  }
  return entry;
}

/// Uploads the triangles of the mesh, then those of its coarser levels.
void MeshCache::upload_triangles(const DrawMesh& mesh, Entry& entry) const {
  std::vector<const Triangles*> lists = {&mesh.triangles};
  if (entry.detail)
    for (const CoarserList& list : entry.detail->coarser) lists.push_back(&list.triangles);
  GLsizeiptr total = 0;
  entry.levels.clear();
  for (const Triangles* list : lists) {
    entry.levels.push_back({total, static_cast<GLsizei>(3 * list->size())});
    total += bytes(*list);
  }
  gl_.BindVertexArray(entry.vertex_array);
  if (entry.triangles == 0) gl_.GenBuffers(1, &entry.triangles);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, entry.triangles);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, total, nullptr, GL_STATIC_DRAW);
  for (std::size_t k = 0; k < lists.size(); ++k)
    gl_.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, entry.levels[k].offset, bytes(*lists[k]), lists[k]->data());
  gl_.BindVertexArray(0);
}

MeshCache::Entry& MeshCache::upload_mesh(const DrawMesh& mesh) {
  const auto [found, is_new] = entries_.try_emplace(mesh.id);
  Entry& entry = found->second;
  entry.last_frame = frame_;
  const bool topology_changed = is_new || entry.revision != mesh.revision;
  if (!topology_changed && entry.positions_revision == mesh.positions_revision) return entry;
  try {
    check(mesh);
  } catch (...) {
    if (is_new) entries_.erase(found);
    throw;
  }
  if (is_new) gl_.GenVertexArrays(1, &entry.vertex_array);
  gl_.BindVertexArray(entry.vertex_array);
  upload_points(gl_, entry.positions, position_attribute, mesh.positions, GL_DYNAMIC_DRAW);
  if (topology_changed) {
    // Without a rest shape, textures use the current positions.
    if (mesh.rest_positions.empty()) {
      gl_.EnableVertexAttribArray(rest_attribute);
      gl_.VertexAttribPointer(rest_attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    } else {
      upload_points(gl_, entry.rest, rest_attribute, mesh.rest_positions, GL_STATIC_DRAW);
    }
    upload_curvature(gl_, entry.hollows, mesh);
  }
  upload_points(gl_, entry.normals, normal_attribute, mesh.normals, GL_DYNAMIC_DRAW);
  gl_.BindVertexArray(0);
  if (topology_changed) {
    entry.detail = nullptr;
    upload_triangles(mesh, entry);
  }
  entry.bounds = bounds_of(mesh.positions);
  entry.box = box_of(mesh.positions);
  entry.revision = mesh.revision;
  entry.positions_revision = mesh.positions_revision;
  return entry;
}

void MeshCache::draw(const Entry& entry, std::size_t level) const {
  const auto& [offset, indices] = entry.levels[std::min(level, entry.levels.size() - 1)];
  gl_.BindVertexArray(entry.vertex_array);
  gl_.DrawElements(GL_TRIANGLES, indices, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
}

void MeshCache::release(const Entry& entry) const {
  gl_.DeleteVertexArrays(1, &entry.vertex_array);
  for (const GLuint buffer : {entry.positions, entry.normals, entry.rest, entry.hollows, entry.triangles})
    if (buffer != 0) gl_.DeleteBuffers(1, &buffer);
}

}  // namespace prosector
