#pragma once
// Outer shape of a body that can be cut: the surface at which its outside is drawn and touched. It is offset
// from the boundary of the tetrahedra towards the finer surface that the uncut body has.

#include <array>
#include <cstdint>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector::cutting {

/// Outer shape of a body that can be cut: offsets from the boundary of the compiled mesh to the finer surface
/// at which the body is drawn and touched. They are given at nodes and edge midpoints and quadratic in
/// between, so continuous from face to face. All parts of the outer boundary after cuts have a position on
/// it.
class OuterShape {
 public:
  /// Point of the compiled mesh's boundary, as a weighted mean of the nodes of one face: a node, or a point
  /// between two or three nodes.
  struct Place {
    std::array<NodeId, 3> node{};
    std::array<double, 3> weight{};
    std::uint32_t nodes = 0;  // number of nodes; 0: the point is inside the body
  };

  OuterShape() = default;  // no offset: the boundary itself
  /// Computes the offsets from the boundary of the mesh `uncut` to `surface`, m, in the rest shape. They are
  /// measured from each node and each edge midpoint along the boundary's normal, up to three quarters of the
  /// edge length. They are reduced where a drawn triangle would be inverted or badly shaped (bounds in
  /// fit_outer_shape.cpp).
  OuterShape(const TetComplex& uncut, const TriangleMesh& surface);

  bool is_boundary() const { return offset_.empty(); }
  Place place(NodeId node) const;  // node of the compiled mesh
  Place between(const Place& a, const Place& b, double t) const;
  Vec3 offset(const Place& place) const;  // m, from the boundary in the rest shape
  /// Returns whether the surface is so curved between nodes a and b of a boundary edge that the edge's
  /// midpoint is drawn as an additional vertex. Returns false unless a and b are nodes of one edge of the
  /// compiled boundary.
  bool has_middle(const Place& a, const Place& b) const;

 private:
  struct Edge {
    NodeId high = 0;  // higher end; edges are grouped by their lower end
    std::array<NodeId, 2> beyond{};
    Vec3 sag = Vec3::Zero();  // offset of the midpoint relative to the mean offset of the ends, m
    bool middle = false;
  };
  class Fit;
  const Edge* edge(NodeId a, NodeId b) const;

  std::vector<Vec3> offset_;          // by node, m
  std::vector<std::uint8_t> outer_;   // by node
  std::vector<std::uint32_t> begin_;  // start of its edges, by lower node
  std::vector<Edge> edges_;           // ascending
};

}  // namespace prosector::cutting
