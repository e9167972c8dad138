#include "server/physics/stations/touching/surface_point.h"

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/soft/elements/edge_nodes.h"
#include "server/physics/mechanics/soft/mesh_follower.h"

namespace prosector {
namespace {

constexpr std::size_t corners_of_tet = 4;

contact::ContactSide side_of_body(const Tissue& tissue) {
  contact::ContactSide out;
  out.kind = contact::ContactSide::Kind::soft;
  out.body = tissue.index;
  return out;
}

/// Adds `share` of a row, in terms of element corners: an edge node is the mean of its ends.
void add_corners(const SparseMap::Row& row, double share, const soft::EdgeNodes& edges,
                 contact::ContactSide& out) {
  for (std::size_t k = 0; k < row.node.size(); ++k) {
    if (row.weight[k] == 0) continue;
    if (row.node[k] < edges.vertices()) {
      out.add({{row.node[k]}, {row.weight[k]}}, share);
      continue;
    }
    const auto [a, b] = edges.ends(row.node[k]);
    out.add({{a, b}, {row.weight[k] / 2, row.weight[k] / 2}}, share);
  }
}

/// Converts a point of a tetrahedron from corner weights to quadratic shape functions. Returns false, and
/// adds nothing, if the corners don't belong to one tetrahedron.
bool add_quadratic(const contact::ContactSide& corners, const soft::EdgeNodes& edges,
                   contact::ContactSide& out) {
  if (corners.nodes > corners_of_tet) return false;
  contact::ContactSide made = out;
  const auto put = [&](std::uint32_t node, double weight) {
    made.node[made.nodes] = node;
    made.weight[made.nodes++] = weight;
  };
  for (std::size_t a = 0; a < corners.nodes; ++a) {
    const double of_a = corners.weight[a];
    put(corners.node[a], of_a * (2 * of_a - 1));
    for (std::size_t b = 0; b < a; ++b) {
      const std::uint32_t middle = edges.find(corners.node[a], corners.node[b]);
      if (middle == soft::EdgeNodes::none) return false;
      put(middle, 4 * of_a * corners.weight[b]);
    }
  }
  out = made;
  return true;
}

/// Returns the point of surface vertices with these weights.
contact::ContactSide point_of(const Tissue& tissue, const std::array<std::uint32_t, 3>& vertices,
                              const Vec3& weights) {
  const SparseMap& embedding = tissue.anatomy().embedding;
  contact::ContactSide out = side_of_body(tissue);
  const soft::EdgeNodes* edges = tissue.solver->follower().edge_nodes();
  const auto for_vertices = [&](const auto& f) {
    for (std::size_t k = 0; k < vertices.size(); ++k)
      if (const double share = weights[static_cast<Eigen::Index>(k)]; share != 0)
        f(embedding.rows[vertices[k]], share);
  };
  if (edges) {
    contact::ContactSide corners;
    bool few = true;
    for_vertices([&](const SparseMap::Row& row, double share) {
      few = few && corners.nodes <= corners_of_tet;
      if (few) add_corners(row, share, *edges, corners);
    });
    if (few && add_quadratic(corners, *edges, out)) return out;
  }
  for_vertices([&](const SparseMap::Row& row, double share) { out.add(row, share); });
  return out;
}

/// Set of corner nodes of elements.
class Corners {
 public:
  std::size_t count() const { return count_; }

  void add(std::uint32_t node) {
    const auto end = nodes_.begin() + static_cast<std::ptrdiff_t>(count_);
    if (std::find(nodes_.begin(), end, node) == end) nodes_[count_++] = node;
  }

  void add(const Corners& other) {
    for (std::size_t k = 0; k < other.count_; ++k) add(other.nodes_[k]);
  }

  /// Returns the side (m) of the square whose diagonal is the longest distance between two corners.
  double size(const std::vector<Vec3>& positions) const {
    double squared = 0;
    for (std::size_t a = 0; a < count_; ++a)
      for (std::size_t b = 0; b < a; ++b)
        squared = std::max(squared, (positions[nodes_[a]] - positions[nodes_[b]]).squaredNorm());
    return std::sqrt(squared / 2);
  }

 private:
  std::array<std::uint32_t, 3 * contact::ContactSide::most_nodes> nodes_{};
  std::size_t count_ = 0;
};

/// Returns the corners that carry a surface vertex; ignores weights at the level of rounding.
Corners corners_of(const SparseMap::Row& row, const soft::EdgeNodes* edges) {
  constexpr double carries = 1e-9;  // weight
  Corners out;
  for (std::size_t k = 0; k < row.node.size(); ++k) {
    if (std::abs(row.weight[k]) < carries) continue;
    if (!edges || row.node[k] < edges->vertices())
      out.add(row.node[k]);
    else
      for (const std::uint32_t end : edges->ends(row.node[k])) out.add(end);
  }
  return out;
}

}  // namespace

contact::ContactSide surface_side(const Tissue& tissue, std::uint32_t triangle, const Vec3& weights) {
  return point_of(tissue, tissue.anatomy().surface.triangles[triangle], weights);
}

contact::ContactSide surface_side(const Tissue& tissue, std::uint32_t vertex) {
  return point_of(tissue, {vertex, vertex, vertex}, Vec3::UnitX());
}

double element_size(const Tissue& tissue, std::uint32_t triangle) {
  const Anatomy& anatomy = tissue.anatomy();
  const soft::EdgeNodes* edges = tissue.solver->follower().edge_nodes();
  std::array<Corners, 3> own;  // of each vertex
  Corners all;
  std::size_t most = 0;  // corners of one vertex
  for (std::size_t k = 0; k < own.size(); ++k) {
    own[k] = corners_of(anatomy.embedding.rows[anatomy.surface.triangles[triangle][k]], edges);
    all.add(own[k]);
    most = std::max(most, own[k].count());
  }
  // Four corners are those of one element, or of two faces with a common edge.
  if (all.count() < corners_of_tet || (all.count() == corners_of_tet && most == corners_of_tet))
    return all.size(anatomy.tets.positions);
  double sum = 0;  // m, of vertices in elements or faces; others lie on edges or are nodes
  int count = 0;
  for (const Corners& corners : own) {
    if (corners.count() < most) continue;
    sum += corners.size(anatomy.tets.positions);
    ++count;
  }
  return sum / count;
}

Vec3 place_of(const contact::ContactSide& side, const Tissue& tissue) {
  Vec3 at = Vec3::Zero();
  for (std::size_t k = 0; k < side.nodes; ++k)
    at += side.weight[k] * tissue.state.motion.x.segment<3>(3 * static_cast<Eigen::Index>(side.node[k]));
  return at;
}

}  // namespace prosector
