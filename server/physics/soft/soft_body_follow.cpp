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

void SoftBody::Impl::follow(const MeshEdit& edit) {
  apply(edit, anatomy.tets);
  model->follow(desc, anatomy.tets, edit);
  pattern.follow(edit);
  if (substepper) substepper->follow(anatomy.tets, edit);
  fit();
}

bool SoftBody::can_follow(const MeshEdit& edit) const {
  const Impl& m = *impl_;
  return mesh_kind(m.anatomy) == MeshKind::tets && m.eighths.tets.empty() &&
         m.node_count() == edit.kept_nodes.before && m.model->can_follow(edit);
}

void SoftBody::follow(const MeshEdit& edit, TriangleMesh surface, SparseMap embedding) {
  Impl& m = *impl_;
  m.anatomy.surface = std::move(surface);
  m.anatomy.embedding = std::move(embedding);
  m.area = vertex_areas(m.anatomy);
  m.follow(edit);
}

void SoftBody::follow(const MeshEdit& edit, const SurfaceEdit& surface) {
  Impl& m = *impl_;
  apply(surface, m.anatomy.surface);
  renumber(edit.kept_nodes, m.anatomy.embedding);
  apply(surface.vertices, surface.rows, m.anatomy.embedding.rows);
  follow_vertex_areas(m.anatomy.surface, surface, m.area);
  m.follow(edit);
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
