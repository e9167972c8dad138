#pragma once
// Outer shape of a body that can be cut: the surface at which its outside is drawn and touched. It is offset
// from the boundary of the tetrahedra towards the finer surface that the uncut body has.

#include <array>
#include <cstdint>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector {

/// Offsets of the compiled mesh's boundary, given at nodes and edge midpoints and quadratic in between, so
/// continuous from face to face. All parts of the boundary after cuts have a place on it.
class OuterShape {
 public:
  /// A point of the compiled boundary: a node, or a point between two or three nodes of one face.
  struct Place {
    std::array<NodeId, 3> node{};
    std::array<double, 3> weight{};
    std::uint32_t nodes = 0;  // number of nodes; 0: the point is inside the body
  };

  OuterShape() = default;  // no offset: the boundary itself
  /// Measures the offset from each node and each edge midpoint along the boundary's normal to the surface, at
  /// most three quarters of an edge's length. Offsets are reduced where a drawn triangle would violate the
  /// bounds in fit_outer_shape.cpp. `surface`: in the rest shape, m.
  OuterShape(const TetComplex& uncut, const TriangleMesh& surface);

  bool is_boundary() const { return offset_.empty(); }
  Place place(NodeId node) const;  // node of the compiled mesh
  Place between(const Place& a, const Place& b, double t) const;
  Vec3 offset(const Place& place) const;  // m, from the boundary in the rest shape
  /// Returns whether the edge's midpoint is drawn, since the surface is curved between the ends.
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

}  // namespace prosector
