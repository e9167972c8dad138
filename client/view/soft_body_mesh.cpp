#include "client/view/soft_body_mesh.h"

#include <algorithm>
#include <utility>

#include "client/view/body_mesh.h"
#include "client/view/normals.h"

namespace prosector {

SoftBodyMesh::SoftBodyMesh(const SoftReplica& soft, double tube_diameter, std::uint64_t first_id)
    : tube_diameter_(tube_diameter),
      shape_(soft.shape()),
      outer_(soft_mesh(soft.rest(), tube_diameter, first_id)) {
  inner_->id = first_id + 1;
  reshape(soft);
}

void SoftBodyMesh::follow(const SoftReplica& soft, bool moved) {
  if (shape_ != soft.shape()) {
    shape_ = soft.shape();
    ++outer_->revision;
    ++inner_->revision;
    reshape(soft);
  } else if (!moved) {
    return;
  }
  move_soft_mesh(soft.surface(), tube_diameter_, *outer_);
  for (std::size_t v = 0; v < inner_vertices_.size(); ++v)
    inner_->positions[v] = soft.surface()[inner_vertices_[v]];
  smooth_normals(inner_->positions, inner_->triangles, inner_->normals);
  ++inner_->positions_revision;
}

/// Rebuilds the triangles. Removed triangles have coincident corners.
void SoftBodyMesh::reshape(const SoftReplica& soft) {
  const TriangleMesh& rest = soft.rest();
  if (tube_diameter_ > 0 && !rest.positions.empty()) return;  // a rope's axis has no inside
  constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> inner_of(rest.positions.size(), none);
  outer_->triangles.clear();
  inner_->triangles.clear();
  inner_vertices_.clear();
  outer_->rest_positions.clear();
  for (const Vec3& x : rest.positions) outer_->rest_positions.push_back(x.cast<float>());
  for (std::size_t t = 0; t < rest.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners = rest.triangles[t];
    if (corners[0] == corners[1] && corners[1] == corners[2]) continue;
    if (rest.inner.empty() || rest.inner[t] == 0) {
      outer_->triangles.push_back(corners);
      continue;
    }
    for (std::uint32_t& corner : corners) {
      std::uint32_t& here = inner_of[corner];
      if (here == none) {
        here = static_cast<std::uint32_t>(inner_vertices_.size());
        inner_vertices_.push_back(corner);
      }
      corner = here;
    }
    inner_->triangles.push_back(corners);
  }
  inner_->rest_positions.clear();
  for (const std::uint32_t v : inner_vertices_) inner_->rest_positions.push_back(outer_->rest_positions[v]);
  inner_->positions = inner_->rest_positions;
  smooth_normals(inner_->positions, inner_->triangles, inner_->normals);
}

Appearance inner_appearance(const Appearance& outer) {
  Appearance out = outer;
  out.color = outer.color.cwiseProduct(Vec3(0.7, 0.5, 0.5));
  out.roughness = std::min(outer.roughness, 0.35);
  out.wetness = std::max(outer.wetness, 0.9);
  if (out.surface == Surface::skin) out.surface = Surface::tissue;
  return out;
}

}  // namespace prosector
