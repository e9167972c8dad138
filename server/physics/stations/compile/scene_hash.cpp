#include "server/physics/stations/compile/scene_hash.h"

#include "common/byte_stream.h"
#include "common/scene/field_values.h"

namespace prosector {
namespace {

void add_mesh(const TriangleMesh& mesh, ByteWriter& out) {
  out.add(static_cast<std::uint64_t>(mesh.positions.size()));
  for (const Vec3& x : mesh.positions) out.add(x);
  out.add_all(mesh.triangles);
}

void add_rigid(const RigidModel& r, ByteWriter& out) {
  add_mesh(r.surface, out);
  out.add(r.center);
  out.add(r.start);
  out.add(r.setup.mass);
  out.add(r.setup.inertia);
  out.add(static_cast<std::uint64_t>(r.shape.parts.size()));
  for (const collision::ShapePart& part : r.shape.parts) {
    out.add(part.kind);
    out.add(part.half);
    out.add(part.pose);
    if (part.mesh) add_mesh(*part.mesh, out);
  }
}

void add_soft(const soft::SoftBody& s, ByteWriter& out) {
  out.add(s.content_hash());
  add_mesh(s.anatomy().surface, out);
  out.add(s.anatomy().thickness);
  out.add(s.attachment_stiffness());
}

}  // namespace

ContentHash hash_of(const Model& model, std::span<const CompiledTissue> soft) {
  ByteWriter out;
  add_values(model.scene, out);
  for (const RigidModel& r : model.rigid) add_rigid(r, out);
  for (const CompiledTissue& tissue : soft) add_soft(*tissue.solver, out);
  return content_hash(std::as_bytes(std::span(out.bytes())));
}

}  // namespace prosector
