// Wire conversion of topology changes of soft bodies: TopologyRevision.

#include "idl/wire/fields.h"

namespace prosector {
namespace {

constexpr auto max_float_coordinate = static_cast<float>(max_coordinate);
constexpr float max_vertex_weight = 16;  // of a point in a vertex; more than 1 for vertices outside the mesh
constexpr float weight_slack = 1e-4f;    // | sum of weights − 1 |

bool is_in_room(const Eigen::Vector3f& x) {
  return x.allFinite() && x.cwiseAbs().maxCoeff() <= max_float_coordinate;
}

bool sound_weights(const std::array<float, 4>& weights) {
  float sum = 0;
  for (const float weight : weights) {
    if (!(std::abs(weight) <= max_vertex_weight)) return false;
    sum += weight;
  }
  return std::abs(sum - 1) < weight_slack;
}

/// Returns whether the slots are ascending, without duplicates, and below `limit`.
template <class Entry>
bool is_ascending_below(const std::vector<Entry>& entries, std::size_t limit) {
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (entries[i].slot >= limit || (i > 0 && entries[i].slot <= entries[i - 1].slot)) return false;
  return true;
}

Refusal check(const SurfacePatch& patch) {
  Checks checks;
  checks.that(patch.points.size() <= max_streamed_points, "too many points")
      .that(is_ascending_below(patch.vertices, max_surface_vertices),
            "the vertices of a surface patch are not in ascending order or out of range")
      .that(is_ascending_below(patch.triangles, max_surface_triangles),
            "the triangles of a surface patch are not in ascending order or out of range");
  for (const auto& point : patch.points)
    checks.that(is_in_room(point.rest) && is_in_room(point.now), "position out of range");
  for (const auto& vertex : patch.vertices) {
    checks.that(is_in_room(vertex.rest), "position out of range")
        .that(sound_weights(vertex.weight),
              "the weights of a surface vertex are out of range or their sum is not 1");
    for (const std::uint32_t point : vertex.point)
      checks.that(point < max_streamed_points, "point out of range");
  }
  for (const auto& triangle : patch.triangles)
    for (const std::uint32_t corner : triangle.corners)
      checks.that(corner < max_surface_vertices, "corner out of range");
  return checks.refusal();
}

template <class Io>
void fields(Io& io, MessageOf<Io, SurfacePatch::Point>& m, WireOf<Io, prosector_PatchPoint>& w) {
  for (int k = 0; k < 3; ++k) {
    io(m.rest[k], w.rest[k]);
    io(m.now[k], w.now[k]);
  }
}

template <class Io>
void fields(Io& io, MessageOf<Io, SurfacePatch::Vertex>& m, WireOf<Io, prosector_PatchVertex>& w) {
  io(m.slot, w.slot);
  for (int k = 0; k < 3; ++k) io(m.rest[k], w.rest[k]);
  for (std::size_t k = 0; k < 4; ++k) {
    io(m.point[k], w.point[k]);
    io(m.weight[k], w.weight[k]);
  }
}

template <class Io>
void fields(Io& io, MessageOf<Io, SurfacePatch::Triangle>& m, WireOf<Io, prosector_PatchTriangle>& w) {
  io(m.slot, w.slot);
  for (std::size_t k = 0; k < 3; ++k) io(m.corners[k], w.corners[k]);
  io(m.inner, w.inner);
}

template <class Io>
void fields(Io& io, MessageOf<Io, TopologyRevision>& m, WireOf<Io, prosector_TopologyRevision>& w) {
  io(m.body, w.body);
  io(m.revision, w.revision);
  io(m.previous_hash, w.previous_hash);
  io(m.chain_hash, w.chain_hash);
  io(m.content_hash, w.content_hash);
  io(m.time, w.time);
  io(m.cause, w.cause);
  io(m.author, w.author);
  io(m.piece_of, w.piece_of);
  io(m.surface_hash, w.surface_hash);
  io(m.mesh, w.mesh);
  io(m.map, w.embedding);
  const auto item = [](auto& items, auto& entry, auto& field) { fields(items, entry, field); };
  io.list(m.patch.points, w.points, max_streamed_points, "too many points", item);
  io.list(m.patch.vertices, w.vertices, max_surface_vertices, "too many vertices", item);
  io.list(m.patch.triangles, w.triangles, max_surface_triangles, "too many triangles", item);
}

}  // namespace

PROSECTOR_WIRE_BY_FIELDS(TopologyRevision);

Refusal check(TopologyRevision& m) {
  if (const Refusal patch = check(m.patch)) return patch;
  return Checks()
      .that(m.body < max_bodies, "no such body")
      .that(m.revision != 0 || m.previous_hash == 0, "revision 0 with a predecessor")
      .that(enum_within(m.cause, TopologyCause::rewind), "unknown cause")
      .that(m.piece_of >= -1 && m.piece_of < static_cast<std::int64_t>(max_bodies),
            "piece of a nonexistent body")
      .that(m.keyframe() == (m.map != ContentHash{}), "incomplete keyframe")
      .refusal();
}

}  // namespace prosector
