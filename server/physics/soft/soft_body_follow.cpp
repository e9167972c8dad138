// A soft body follows what cuts, and what takes them back, make of its mesh.

#include "server/physics/soft/rungs.h"
#include "server/physics/soft/soft_body_impl.h"
#include "server/physics/soft/soft_body_setup.h"

namespace prosector {
namespace {

/// What a surface hangs on, by the nodes' indices now; of vertices that go, anything.
void renumber(const Kept& nodes, SparseMap& embedding) {
  if (nodes.all_unmoved()) return;
  const std::vector<std::uint32_t> now = nodes.destinations();
  for (SparseMap::Row& row : embedding.rows)
    for (std::size_t k = 0; k < row.node.size(); ++k)
      if (row.weight[k] != 0) row.node[k] = now[row.node[k]];
}

void follow_embedding(const Kept& nodes, const SurfaceEdit& surface, SparseMap& embedding) {
  renumber(nodes, embedding);
  apply(surface.vertices, surface.rows, embedding.rows);
}

/// Of quadratic elements, which have followed: rows that come, and those between whose nodes edges may have
/// come or gone.
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

void SoftBody::Impl::fit() {
  symmetric.fit(pattern);
  mass = lumped_mass(desc.density, model->volume());
  ties = prosector::attachment_stiffness(desc.attach, model->rest(), model->volume());
  weigh();
  recovery.reset();
  diagonal = bounding_diagonal(model->rest());
  elements.fit();
  damping.fit(node_count());
  hessian->fit();
  node_sum = NodeSum(node_count());
  start_anew();
  if (substepper) substepper->fit();
}

/// `edit`: of all nodes.
void SoftBody::Impl::follow(const MeshEdit& edit) {
  apply(edit, anatomy.tets);
  if (quadratic) follow_divided(anatomy.tets, quadratic->edges, edit, quadratic->eighths);
  model->follow(desc, anatomy.tets, edit);
  pattern.follow(edit);
  if (substepper) substepper->follow(anatomy.tets, edit);
  fit();
}

bool SoftBody::can_follow(const MeshEdit& edit) const {
  const Impl& m = *impl_;
  return mesh_kind(m.anatomy) == MeshKind::tets && m.vertex_count() == edit.kept_nodes.before &&
         m.model->can_follow(edit);
}

const EdgeNodes* SoftBody::edge_nodes() const {
  return impl_->quadratic ? &impl_->quadratic->edges : nullptr;
}

MeshEdit SoftBody::edit_of_nodes(const MeshEdit& edit) const {
  if (!impl_->quadratic) return edit;
  return EdgeNodes(impl_->quadratic->edges).follow(impl_->anatomy.tets, edit);
}

void SoftBody::follow(const MeshEdit& edit, TriangleMesh surface, SparseMap embedding) {
  Impl& m = *impl_;
  m.anatomy.surface = std::move(surface);
  m.anatomy.embedding = std::move(embedding);
  m.area = vertex_areas(m.anatomy);
  if (!m.quadratic) return m.follow(edit);
  m.quadratic->embedding = m.anatomy.embedding;
  const MeshEdit nodes = m.quadratic->edges.follow(m.anatomy.tets, edit);
  for (SparseMap::Row& row : m.anatomy.embedding.rows) row = divided(row, m.quadratic->edges);
  m.follow(nodes);
}

void SoftBody::follow(const MeshEdit& edit, const SurfaceEdit& surface) {
  Impl& m = *impl_;
  apply(surface, m.anatomy.surface);
  follow_vertex_areas(m.anatomy.surface, surface, m.area);
  if (!m.quadratic) {
    follow_embedding(edit.kept_nodes, surface, m.anatomy.embedding);
    return m.follow(edit);
  }
  const MeshEdit nodes = m.quadratic->edges.follow(m.anatomy.tets, edit);
  follow_embedding(edit.kept_nodes, surface, m.quadratic->embedding);
  follow_embedding(nodes.kept_nodes, surface, m.anatomy.embedding);
  divide_again(*m.quadratic, edit, surface, m.anatomy.embedding);
  m.follow(nodes);
}

bool SoftBody::can_follow_sheet(const Kept& nodes) const {
  const Impl& m = *impl_;
  return mesh_kind(m.anatomy) == MeshKind::sheet && m.node_count() == nodes.before &&
         m.model->can_follow_sheet();
}

void SoftBody::follow_sheet(Anatomy sheet, const Kept& nodes, std::span<const std::uint32_t> touched) {
  Impl& m = *impl_;
  m.anatomy = std::move(sheet);
  m.area = vertex_areas(m.anatomy);
  m.pattern.follow(nodes, m.model->follow_sheet(m.desc, m.anatomy, nodes, touched));
  m.fit();
}

}  // namespace prosector
