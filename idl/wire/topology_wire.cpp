// Wire conversion of topology changes of soft bodies: TopologyRevision.

#include "idl/wire/primitives.h"

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

}  // namespace

void to_wire(const TopologyRevision& m, prosector_TopologyRevision& w, WireArena& arena) {
  w.body = m.body;
  w.revision = m.revision;
  w.previous_hash = m.previous_hash;
  w.chain_hash = m.chain_hash;
  w.content_hash = m.content_hash;
  w.time = to_wire(m.time);
  w.cause = static_cast<std::uint8_t>(m.cause);
  w.author = m.author;
  w.piece_of = m.piece_of;
  w.surface_hash = m.surface_hash;
  w.mesh = to_wire(m.mesh);
  w.embedding = to_wire(m.map);
  make_sequence<prosector_PatchPoint>(w.points, m.patch.points.size(), arena);
  for (std::size_t i = 0; i < m.patch.points.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      w.points._buffer[i].rest[k] = m.patch.points[i].rest[k];
      w.points._buffer[i].now[k] = m.patch.points[i].now[k];
    }
  make_sequence<prosector_PatchVertex>(w.vertices, m.patch.vertices.size(), arena);
  for (std::size_t i = 0; i < m.patch.vertices.size(); ++i) {
    const SurfacePatch::Vertex& from = m.patch.vertices[i];
    prosector_PatchVertex& to = w.vertices._buffer[i];
    to.slot = from.slot;
    for (int k = 0; k < 3; ++k) to.rest[k] = from.rest[k];
    std::copy(from.point.begin(), from.point.end(), to.point);
    std::copy(from.weight.begin(), from.weight.end(), to.weight);
  }
  make_sequence<prosector_PatchTriangle>(w.triangles, m.patch.triangles.size(), arena);
  for (std::size_t i = 0; i < m.patch.triangles.size(); ++i) {
    const SurfacePatch::Triangle& from = m.patch.triangles[i];
    prosector_PatchTriangle& to = w.triangles._buffer[i];
    to.slot = from.slot;
    std::copy(from.corners.begin(), from.corners.end(), to.corners);
    to.inner = from.inner;
  }
}

Refusal from_wire(const prosector_TopologyRevision& w, TopologyRevision& m) {
  if (!sequence_within(w.points, max_streamed_points)) return "too many points";
  if (!sequence_within(w.vertices, max_surface_vertices)) return "too many vertices";
  if (!sequence_within(w.triangles, max_surface_triangles)) return "too many triangles";
  m.body = w.body;
  m.revision = w.revision;
  m.previous_hash = w.previous_hash;
  m.chain_hash = w.chain_hash;
  m.content_hash = w.content_hash;
  m.time = from_wire(w.time);
  m.cause = static_cast<TopologyCause>(w.cause);
  m.author = w.author;
  m.piece_of = w.piece_of;
  m.surface_hash = w.surface_hash;
  m.mesh = from_wire(w.mesh);
  m.map = from_wire(w.embedding);
  m.patch = {};
  for (std::uint32_t i = 0; i < w.points._length; ++i) {
    const prosector_PatchPoint& from = w.points._buffer[i];
    m.patch.points.push_back(
        {Eigen::Map<const Eigen::Vector3f>(from.rest), Eigen::Map<const Eigen::Vector3f>(from.now)});
  }
  for (std::uint32_t i = 0; i < w.vertices._length; ++i) {
    const prosector_PatchVertex& from = w.vertices._buffer[i];
    SurfacePatch::Vertex& to = m.patch.vertices.emplace_back();
    to.slot = from.slot;
    to.rest = Eigen::Map<const Eigen::Vector3f>(from.rest);
    std::copy(std::begin(from.point), std::end(from.point), to.point.begin());
    std::copy(std::begin(from.weight), std::end(from.weight), to.weight.begin());
  }
  for (std::uint32_t i = 0; i < w.triangles._length; ++i) {
    const prosector_PatchTriangle& from = w.triangles._buffer[i];
    SurfacePatch::Triangle& to = m.patch.triangles.emplace_back();
    to.slot = from.slot;
    std::copy(std::begin(from.corners), std::end(from.corners), to.corners.begin());
    to.inner = from.inner != 0;
  }
  return {};
}

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
