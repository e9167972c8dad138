#pragma once
// DrawMeshes on the GPU, by id. Private to client/render.

#include <unordered_map>

#include "client/render/gl.h"
#include "client/render/projection.h"

namespace prosector {

// Attribute locations, the same in every shader that draws meshes.
inline constexpr GLuint position_attribute = 0, normal_attribute = 1, rest_attribute = 2,
                        hollow_attribute = 3;

class MeshCache {
 public:
  struct Entry {
    GLuint vertex_array = 0, positions = 0, normals = 0, rest = 0, hollows = 0, triangles = 0;
    struct Level {
      GLsizeiptr offset;  // bytes, in `triangles`
      GLsizei indices;
    };
    std::vector<Level> levels;  // the finest first
    std::shared_ptr<const Detail> detail;
    std::uint64_t revision = 0, positions_revision = 0;
    Sphere bounds;            // in the mesh's frame
    Eigen::AlignedBox3f box;  // in the mesh's frame
    std::uint64_t last_frame = 0;
  };

  explicit MeshCache(const Gl& gl) : gl_(gl) {}
  ~MeshCache();
  MeshCache(const MeshCache&) = delete;
  MeshCache& operator=(const MeshCache&) = delete;

  /// Starts a frame, and frees the GPU buffers of meshes that were not drawn in the last `frames_kept`
  /// frames.
  void begin_frame();
  /// Uploads the parts of the mesh and of its coarser levels that changed since the last upload, and returns
  /// its GPU buffers. Throws std::invalid_argument if the mesh's arrays have inconsistent sizes.
  const Entry& upload(const DrawMesh& mesh, const std::shared_ptr<const Detail>& detail = nullptr);
  /// Draws an uploaded mesh with the shader program in use. `level` 0 selects the mesh's own triangles;
  /// higher levels are coarser, limited to the available ones.
  void draw(const Entry& entry, std::size_t level) const;

 private:
  static constexpr std::uint64_t frames_kept = 300;

  Entry& upload_mesh(const DrawMesh& mesh);
  void upload_triangles(const DrawMesh& mesh, Entry& entry) const;
  void release(const Entry& entry) const;

  const Gl& gl_;
  std::uint64_t frame_ = 0;
  std::unordered_map<std::uint64_t, Entry> entries_;
};

}  // namespace prosector
