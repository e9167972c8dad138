#include "server/session/sending/surface_stream.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "common/assert.h"
#include "common/surface_patch.h"

namespace prosector {
namespace {

constexpr std::uint32_t unused = ~0u;

/// Halves `items` across the longest side of their box, at a multiple of the chunk size, until each part is
/// one chunk.
void sort_into_chunks(std::span<std::uint32_t> items, const std::vector<Vec3>& x, std::size_t chunk) {
  const std::size_t chunks = (items.size() + chunk - 1) / chunk;
  if (chunks <= 1) {
    std::sort(items.begin(), items.end());
    return;
  }
  Eigen::AlignedBox3d box;
  for (auto i : items) box.extend(x[i]);
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto middle = static_cast<std::ptrdiff_t>((chunks + 1) / 2 * chunk);
  std::nth_element(items.begin(), items.begin() + middle, items.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(x[a][axis], a) < std::pair(x[b][axis], b);
  });
  sort_into_chunks(items.subspan(0, static_cast<std::size_t>(middle)), x, chunk);
  sort_into_chunks(items.subspan(static_cast<std::size_t>(middle)), x, chunk);
}

SparseMap::Row one(std::uint32_t node) {
  SparseMap::Row row;
  row.node[0] = node;
  row.weight[0] = 1;
  return row;
}

}  // namespace

SparseMap sources_of(const SurfaceStream& of_vertices, const SparseMap& embedding) {
  PROSECTOR_ASSERT(!of_vertices.of_nodes);
  SparseMap out;
  for (const std::uint32_t vertex : of_vertices.carriers)
    out.rows.push_back(vertex == unused ? SparseMap::Row() : embedding.rows[vertex]);
  return out;
}

SurfaceStream make_surface_stream(const Anatomy& anatomy, std::uint32_t chunk_points, Streamed what) {
  PROSECTOR_ASSERT(chunk_points > 0);
  const std::vector<SparseMap::Row>& W = anatomy.embedding.rows;
  std::vector<std::uint32_t> new_index(anatomy.tets.positions.size(), unused);
  std::vector<std::uint32_t> streamed;  // nodes, or surface vertices
  for (const auto& row : W)
    for (std::size_t k = 0; k < 4; ++k)
      if (row.weight[k] != 0 && new_index[row.node[k]] == unused) {
        new_index[row.node[k]] = 0;
        streamed.push_back(row.node[k]);
      }
  if (W.empty()) streamed.push_back(0);  // an empty body: a stream needs a point
  const bool nodes = W.empty() || (what == Streamed::fewest && streamed.size() <= W.size());
  if (!nodes) {
    streamed.resize(W.size());
    std::iota(streamed.begin(), streamed.end(), 0u);
    new_index.assign(W.size(), unused);
  }
  const std::vector<Vec3>& rest = nodes ? anatomy.tets.positions : anatomy.surface.positions;
  sort_into_chunks(streamed, rest, chunk_points);
  for (std::uint32_t i = 0; i < streamed.size(); ++i) new_index[streamed[i]] = i;

  SurfaceStream out;
  out.points = static_cast<std::uint32_t>(streamed.size());
  out.chunk_points = chunk_points;
  out.of_nodes = nodes;
  for (auto i : streamed) {
    out.sources.rows.push_back(nodes ? one(i) : W[i]);
    out.surface.rest.push_back(to_float(rest[i]));
  }
  for (std::uint32_t v = 0; v < W.size(); ++v) {
    SparseMap::Row row = nodes ? W[v] : one(new_index[v]);
    if (nodes)
      for (std::size_t k = 0; k < 4; ++k) row.node[k] = row.weight[k] != 0 ? new_index[row.node[k]] : 0;
    out.surface.map.rows.push_back(row);
  }
  out.carriers = std::move(streamed);
  return out;
}

}  // namespace prosector
