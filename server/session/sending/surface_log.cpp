#include "server/session/sending/surface_log.h"

#include <algorithm>
#include <utility>

#include "common/assert.h"

namespace prosector {
namespace {

constexpr std::uint32_t none = ~0u;

std::uint32_t number_of(const std::vector<std::uint32_t>& numbers, std::size_t index) {
  PROSECTOR_ASSERT(numbers.empty() || index < numbers.size());
  return numbers.empty() ? static_cast<std::uint32_t>(index) : numbers[index];
}

/// Counts the nodes that have numbers; later nodes are on edges of quadratic elements.
std::size_t numbered_nodes(const Anatomy& anatomy) {
  if (anatomy.tets.tets.empty()) return anatomy.tets.positions.size();
  std::size_t count = 0;
  for (const auto& tet : anatomy.tets.tets)
    for (const std::uint32_t corner : tet) count = std::max(count, corner + std::size_t{1});
  return count;
}

/// Returns the nodes or vertices that determine the surface, in the order of their first use.
std::vector<std::uint32_t> carriers_of(const Anatomy& anatomy, bool of_nodes) {
  std::vector<std::uint32_t> out;
  std::vector<bool> seen(anatomy.tets.positions.size());
  for (std::uint32_t v = 0; v < anatomy.embedding.rows.size(); ++v) {
    if (!of_nodes) out.push_back(v);
    const SparseMap::Row& row = anatomy.embedding.rows[v];
    for (std::size_t k = 0; of_nodes && k < 4; ++k) {
      if (row.weight[k] == 0 || seen[row.node[k]]) continue;
      seen[row.node[k]] = true;
      out.push_back(row.node[k]);
    }
  }
  return out;
}

/// Returns a leader for each point. A point in use leads itself. An unused one gets a used point of its chunk
/// if possible, else any used point; none where no point is in use.
std::vector<std::uint32_t> leaders(const std::vector<bool>& used, std::uint32_t chunk_points) {
  PROSECTOR_ASSERT(chunk_points > 0);
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
  PROSECTOR_ASSERT(number != none);
  if (number >= of.size()) of.resize(number + std::size_t{1}, none);
  if (of[number] == none) of[number] = count++;
  return of[number];
}

SurfaceLog::SurfaceLog(const Anatomy& anatomy, const Numbering& numbering, const TopologyChange& change,
                       SimTime time, Streamed streamed) {
  SurfaceStream stream =
      make_surface_stream(anatomy, static_cast<std::uint32_t>(soft_chunk_points), streamed);
  slots_of(stream.carriers, stream.of_nodes, anatomy, numbering);
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
  std::vector<std::uint32_t> slot_of;
  place_points(anatomy, numbering, next, stream, slot_of);
  place_vertices(anatomy, numbering, stream, slot_of, next);
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

std::vector<std::uint32_t> SurfaceLog::slots_of(std::span<const std::uint32_t> carriers, bool of_nodes,
                                                const Anatomy& anatomy, const Numbering& numbering) {
  const std::size_t numbered = of_nodes ? numbered_nodes(anatomy) : anatomy.surface.positions.size();
  const auto& numbers = of_nodes ? numbering.nodes : numbering.vertices;
  std::vector<std::uint32_t> out(of_nodes ? anatomy.tets.positions.size() : numbered, none);
  std::map<std::array<float, 3>, std::size_t> met;
  for (const std::uint32_t carrier : carriers) {
    if (carrier < numbered) {
      out[carrier] = points_.at(number_of(numbers, carrier));
      continue;
    }
    const Eigen::Vector3f rest = anatomy.tets.positions[carrier].cast<float>();
    const std::array<float, 3> place{rest.x(), rest.y(), rest.z()};
    std::vector<std::uint32_t>& slots = edge_points_[place];
    const std::size_t here = met[place]++;
    if (here == slots.size()) slots.push_back(points_.count++);
    out[carrier] = slots[here];
  }
  return out;
}

/// Updates the streamed points. A removed point keeps its slot, at the rest position that clients have.
void SurfaceLog::place_points(const Anatomy& anatomy, const Numbering& numbering, DrawnSurface& surface,
                              SurfaceStream& stream, std::vector<std::uint32_t>& slot_of) {
  const std::vector<SparseMap::Row>& W = anatomy.embedding.rows;
  const std::vector<Vec3>& rest = stream.of_nodes ? anatomy.tets.positions : anatomy.surface.positions;
  const std::vector<std::uint32_t> carriers = carriers_of(anatomy, stream.of_nodes);
  slot_of = slots_of(carriers, stream.of_nodes, anatomy, numbering);
  stream.carriers.assign(points_.count, none);
  surface.streamed.rest.resize(points_.count);
  for (const std::uint32_t carrier : carriers) {
    const std::uint32_t slot = slot_of[carrier];
    if (slot >= surface_.streamed.rest.size()) surface.streamed.rest[slot] = to_float(rest[carrier]);
    stream.carriers[slot] = carrier;
  }
  stream.points = points_.count;
  std::vector<bool> used;
  for (const std::uint32_t carrier : stream.carriers) {
    used.push_back(carrier != none);
    SparseMap::Row row;  // empty for a removed point
    if (carrier != none) row = stream.of_nodes ? SparseMap::Row{{carrier}, {1}} : W[carrier];
    stream.sources.rows.push_back(row);
  }
  if (std::find(used.begin(), used.end(), false) != used.end())
    stream.leaders = leaders(used, stream.chunk_points);
}

void SurfaceLog::place_vertices(const Anatomy& anatomy, const Numbering& numbering,
                                const SurfaceStream& stream, const std::vector<std::uint32_t>& slot_of,
                                DrawnSurface& surface) {
  for (std::uint32_t v = 0; v < anatomy.surface.positions.size(); ++v) {
    const std::uint32_t slot = vertices_.at(number_of(numbering.vertices, v));
    if (slot == surface.rest.positions.size()) {
      surface.rest.positions.emplace_back();
      surface.streamed.map.rows.emplace_back();
    }
    surface.rest.positions[slot] = to_float(anatomy.surface.positions[v]);
    SparseMap::Row& row = surface.streamed.map.rows[slot];
    row = stream.of_nodes ? anatomy.embedding.rows[v] : SparseMap::Row{{slot_of[v]}, {1}};
    for (std::size_t k = 0; k < 4; ++k) {
      row.weight[k] = to_float(row.weight[k]);
      if (stream.of_nodes) row.node[k] = anatomy.embedding.rows[v].weight[k] != 0 ? slot_of[row.node[k]] : 0;
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
