#include "server/physics/mechanics/soft/mesh_follower.h"

#include "server/physics/mechanics/soft/implicit_stepper.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/integrators/substepper.h"
#include "server/physics/mechanics/soft/recovery_law.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/mechanics/soft/soft_body_setup.h"
#include "server/physics/mechanics/soft/soft_matter.h"

namespace prosector::soft {
namespace {

/// Replaces the node indices of an embedding by the present indices; those of removed vertices are undefined.
void renumber(const Kept& nodes, SparseMap& embedding) {
  if (nodes.all_unmoved()) return;
  const std::vector<std::uint32_t> now = nodes.destinations();
  for (SparseMap::Row& row : embedding.rows)
    for (std::size_t k = 0; k < row.node.size(); ++k)
      if (row.weight[k] != 0) row.node[k] = now[row.node[k]];
}

void follow_embedding(const Kept& nodes, const SurfaceEdit& surface, SparseMap& embedding) {
  renumber(nodes, embedding);
  prosector::apply(surface.vertices, surface.rows, embedding.rows);
}

/// Recomputes the rows of added vertices, and the rows between whose nodes edges may have been added or
/// removed. The quadratic elements must be updated before.
void divide_again(const QuadraticNodes& nodes, const MeshEdit& edit, const SurfaceEdit& surface,
                  SparseMap& embedding) {
  std::vector<char> met(edit.kept_nodes.now, 0), other(embedding.rows.size(), 0);
  for (const std::uint32_t node : edit.nodes) met[node] = 1;
  for (const std::uint32_t vertex : surface.vertices.come) other[vertex] = 1;
  for (std::size_t vertex = 0; vertex < other.size(); ++vertex) {
    const SparseMap::Row& row = nodes.embedding.rows[vertex];
    for (std::size_t k = 0; k < 4; ++k)
      if (row.weight[k] != 0 && met[row.node[k]]) other[vertex] = 1;
    if (other[vertex]) embedding.rows[vertex] = divided(row, nodes.edges);
  }
}

}  // namespace

const EdgeNodes* MeshFollower::edge_nodes() const {
  const auto& quadratic = parts_.matter.quadratic;
  return quadratic ? &quadratic->edges : nullptr;
}

MeshEdit MeshFollower::edit_of_nodes(const MeshEdit& edit) const {
  const SoftMatter& m = parts_.matter;
  if (!m.quadratic) return edit;
  return EdgeNodes(m.quadratic->edges).follow(m.anatomy.tets, edit);
}

bool MeshFollower::can_follow(const MeshEdit& edit) const {
  const SoftMatter& m = parts_.matter;
  return mesh_kind(m.anatomy) == MeshKind::tets && m.vertex_count() == edit.kept_nodes.before &&
         m.model->can_follow(edit);
}

void MeshFollower::follow(const MeshEdit& edit, TriangleMesh surface, SparseMap embedding) {
  SoftMatter& m = parts_.matter;
  m.anatomy.surface = std::move(surface);
  m.area = vertex_areas(m.anatomy);
  follow(edit, std::move(embedding));
}

void MeshFollower::follow(const MeshEdit& edit, SparseMap embedding) {
  SoftMatter& m = parts_.matter;
  m.anatomy.embedding = std::move(embedding);
  if (!m.quadratic) return follow_nodes(edit);
  m.quadratic->embedding = m.anatomy.embedding;
  const MeshEdit nodes = m.quadratic->edges.follow(m.anatomy.tets, edit);
  for (SparseMap::Row& row : m.anatomy.embedding.rows) row = divided(row, m.quadratic->edges);
  follow_nodes(nodes);
}

void MeshFollower::follow(const MeshEdit& edit, const SurfaceEdit& surface) {
  SoftMatter& m = parts_.matter;
  prosector::apply(surface, m.anatomy.surface);
  follow_vertex_areas(m.anatomy.surface, surface, m.area);
  if (!m.quadratic) {
    follow_embedding(edit.kept_nodes, surface, m.anatomy.embedding);
    return follow_nodes(edit);
  }
  const MeshEdit nodes = m.quadratic->edges.follow(m.anatomy.tets, edit);
  follow_embedding(edit.kept_nodes, surface, m.quadratic->embedding);
  follow_embedding(nodes.kept_nodes, surface, m.anatomy.embedding);
  divide_again(*m.quadratic, edit, surface, m.anatomy.embedding);
  follow_nodes(nodes);
}

/// Applies an edit of all nodes.
void MeshFollower::follow_nodes(const MeshEdit& edit) {
  SoftMatter& m = parts_.matter;
  apply(edit, m.anatomy.tets);
  if (m.quadratic) follow_divided(m.anatomy.tets, m.quadratic->edges, edit, m.quadratic->eighths);
  m.model->follow(m.desc.material, m.anatomy.tets, edit);
  m.pattern.follow(edit);
  if (parts_.substepper) parts_.substepper->follow(m.anatomy.tets, edit);
  fit();
}

bool MeshFollower::can_follow_sheet(const Kept& nodes) const {
  const SoftMatter& m = parts_.matter;
  return mesh_kind(m.anatomy) == MeshKind::sheet && m.node_count() == nodes.before &&
         m.model->can_follow_sheet();
}

void MeshFollower::follow_sheet(Anatomy sheet, const Kept& nodes, std::span<const std::uint32_t> touched) {
  SoftMatter& m = parts_.matter;
  m.anatomy = std::move(sheet);
  m.area = vertex_areas(m.anatomy);
  m.pattern.follow(nodes, m.model->follow_sheet(m.desc.material, m.anatomy, nodes, touched));
  fit();
}

void MeshFollower::fit() {
  parts_.matter.fit();
  parts_.recovery.fit();
  parts_.potential.fit();
  parts_.stepper.reset();
  if (parts_.substepper) parts_.substepper->fit();
}

}  // namespace prosector::soft
