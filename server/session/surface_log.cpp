#include "server/session/surface_log.h"

#include <algorithm>
#include <utility>

namespace prosector {
namespace {

constexpr std::uint32_t none = ~0u;

std::uint32_t number_of(const std::vector<std::uint32_t>& numbers, std::size_t index) {
  return numbers.empty() ? static_cast<std::uint32_t>(index) : numbers[index];
}

/// Of each point that nothing hangs on any more: one of its chunk that is in use, else any; none where the
/// body has become nothing. The others follow themselves.
std::vector<std::uint32_t> leaders(const std::vector<bool>& used, std::uint32_t chunk_points) {
  std::vector<std::uint32_t> out(used.size(), none);
  const auto first = static_cast<std::uint32_t>(std::find(used.begin(), used.end(), true) - used.begin());
  if (first == used.size()) return out;
  std::uint32_t leader = first;
  for (std::uint32_t begin = 0; begin < used.size(); begin += chunk_points) {
    const auto end = std::min(begin + chunk_points, static_cast<std::uint32_t>(used.size()));
    for (std::uint32_t i = begin; i < end; ++i)
      if (used[i]) {
        leader = i;
        break;
      }
    for (std::uint32_t i = begin; i < end; ++i) out[i] = leader = used[i] ? i : leader;
  }
  return out;
}

}  // namespace

std::uint32_t SurfaceLog::Slots::at(std::uint32_t number) {
  if (number >= of.size()) of.resize(number + std::size_t{1}, none);
  if (of[number] == none) of[number] = count++;
  return of[number];
}

SurfaceLog::SurfaceLog(const Anatomy& anatomy, const Numbering& numbering, const TopologyChange& change,
                       SimTime time) {
  SurfaceStream stream = make_surface_stream(anatomy, static_cast<std::uint32_t>(soft_chunk_points));
  const auto& numbers = stream.of_nodes ? numbering.nodes : numbering.vertices;
  for (const std::uint32_t carrier : stream.carriers) points_.at(number_of(numbers, carrier));
  for (std::size_t v = 0; v < anatomy.surface.positions.size(); ++v)
    vertices_.at(number_of(numbering.vertices, v));
  for (std::size_t t = 0; t < anatomy.surface.triangles.size(); ++t)
    triangles_.at(number_of(numbering.triangles, t));
  surface_ = rounded(anatomy.surface, std::move(stream.surface));
  stream.surface = surface_.streamed;
  stream_ = std::make_shared<const SurfaceStream>(std::move(stream));
  note(change, time);
}

void SurfaceLog::follow(const Anatomy& anatomy, const Numbering& numbering, const VecX& x,
                        const TopologyChange& change, SimTime time) {
  DrawnSurface next = surface_;
  SurfaceStream stream = {.sources = {},
                          .surface = {},
                          .points = 0,
                          .chunk_points = stream_->chunk_points,
                          .of_nodes = stream_->of_nodes,
                          .carriers = {},
                          .leaders = {}};
  place_points(anatomy, numbering, next, stream);
  place_vertices(anatomy, numbering, stream, next);
  place_triangles(anatomy, numbering, next);
  SurfacePatch patch = difference(surface_, next);
  for (std::size_t i = 0; i < patch.points.size(); ++i)
    patch.points[i].now = stream.sources.apply(surface_.streamed.rest.size() + i, x.data()).cast<float>();
  surface_ = std::move(next);
  stream.surface = surface_.streamed;
  stream_ = std::make_shared<const SurfaceStream>(std::move(stream));
  newest_.patch = std::move(patch);
  newest_.previous_hash = newest_.chain_hash;
  note(change, time);
}

/// A point that is gone keeps its place in its chunk, at rest and as it is told.
void SurfaceLog::place_points(const Anatomy& anatomy, const Numbering& numbering, DrawnSurface& surface,
                              SurfaceStream& stream) {
  const std::vector<SparseMap::Row>& W = anatomy.embedding.rows;
  const auto& numbers = stream.of_nodes ? numbering.nodes : numbering.vertices;
  const std::vector<Vec3>& rest = stream.of_nodes ? anatomy.tets.positions : anatomy.surface.positions;
  stream.carriers.assign(points_.count, none);
  const auto carry = [&](std::uint32_t carrier) {
    const std::uint32_t slot = points_.at(number_of(numbers, carrier));
    if (slot == surface.streamed.rest.size()) {
      surface.streamed.rest.push_back(to_float(rest[carrier]));
      stream.carriers.push_back(none);
    }
    stream.carriers[slot] = carrier;
  };
  for (std::uint32_t v = 0; v < W.size(); ++v) {
    if (!stream.of_nodes) carry(v);
    for (std::size_t k = 0; stream.of_nodes && k < 4; ++k)
      if (W[v].weight[k] != 0) carry(W[v].node[k]);
  }
  stream.points = points_.count;
  std::vector<bool> used;
  for (const std::uint32_t carrier : stream.carriers) {
    used.push_back(carrier != none);
    SparseMap::Row row;  // of a point that is gone: nothing
    if (carrier != none) row = stream.of_nodes ? SparseMap::Row{{carrier}, {1}} : W[carrier];
    stream.sources.rows.push_back(row);
  }
  if (std::find(used.begin(), used.end(), false) != used.end())
    stream.leaders = leaders(used, stream.chunk_points);
}

void SurfaceLog::place_vertices(const Anatomy& anatomy, const Numbering& numbering,
                                const SurfaceStream& stream, DrawnSurface& surface) {
  const auto point_of = [&](std::uint32_t node) { return points_.at(number_of(numbering.nodes, node)); };
  for (std::uint32_t v = 0; v < anatomy.surface.positions.size(); ++v) {
    const std::uint32_t number = number_of(numbering.vertices, v);
    const std::uint32_t slot = vertices_.at(number);
    if (slot == surface.rest.positions.size()) {
      surface.rest.positions.emplace_back();
      surface.streamed.map.rows.emplace_back();
    }
    surface.rest.positions[slot] = to_float(anatomy.surface.positions[v]);
    SparseMap::Row& row = surface.streamed.map.rows[slot];
    row = stream.of_nodes ? anatomy.embedding.rows[v] : SparseMap::Row{{points_.at(number)}, {1}};
    for (std::size_t k = 0; k < 4; ++k) {
      row.weight[k] = to_float(row.weight[k]);
      if (stream.of_nodes) row.node[k] = anatomy.embedding.rows[v].weight[k] != 0 ? point_of(row.node[k]) : 0;
    }
  }
}

void SurfaceLog::place_triangles(const Anatomy& anatomy, const Numbering& numbering, DrawnSurface& surface) {
  const TriangleMesh& from = anatomy.surface;
  TriangleMesh& to = surface.rest;
  std::fill(to.triangles.begin(), to.triangles.end(), std::array<std::uint32_t, 3>{});
  if (!from.inner.empty() && to.inner.empty()) to.inner.resize(to.triangles.size(), 0);
  std::fill(to.inner.begin(), to.inner.end(), std::uint8_t{0});
  for (std::size_t t = 0; t < from.triangles.size(); ++t) {
    const std::uint32_t slot = triangles_.at(number_of(numbering.triangles, t));
    if (slot == to.triangles.size()) {
      to.triangles.emplace_back();
      if (!to.inner.empty()) to.inner.push_back(0);
    }
    for (std::size_t k = 0; k < 3; ++k)
      to.triangles[slot][k] = vertices_.at(number_of(numbering.vertices, from.triangles[t][k]));
    if (!from.inner.empty()) to.inner[slot] = from.inner[t];
  }
}

void SurfaceLog::note(const TopologyChange& change, SimTime time) {
  newest_.body = change.body;
  newest_.revision = change.revision;
  newest_.content_hash = change.content_hash;
  newest_.time = time;
  newest_.cause = change.cause;
  newest_.author = change.author;
  newest_.piece_of = change.piece_of ? static_cast<std::int32_t>(*change.piece_of) : -1;
  newest_.surface_hash = hash(surface_);
  newest_.chain_hash = chain_hash_of(newest_);
}

}  // namespace prosector
