#pragma once
// Where the outside of a body that can be cut is drawn and touched. It is as far from the boundary of its
// tetrahedra as the finer surface is that it has while it is whole.

#include <array>
#include <cstdint>
#include <vector>

#include "common/mesh.h"
#include "server/physics/cutting/tet_complex.h"

namespace prosector {

/// Offsets of the compiled mesh's boundary: of its nodes and of its edges' middles, quadratic in between, so
/// continuous from face to face. Whatever cuts make of the boundary has a place on it.
class OuterShape {
 public:
  /// A node of the boundary, or a point between two or three of one of its faces.
  struct Place {
    std::array<NodeId, 3> node{};
    std::array<double, 3> weight{};
    std::uint32_t nodes = 0;  // 0: inside the body
  };

  OuterShape() = default;  // the boundary itself
  /// Measures from each node and each edge's middle along the boundary's normal to the surface, three
  /// quarters of an edge's length at most. It goes less far where triangles beyond fit_outer_shape.cpp's
  /// bounds would come of it. `surface`: at rest, m.
  OuterShape(const TetComplex& uncut, const TriangleMesh& surface);

  bool is_boundary() const { return offset_.empty(); }
  Place place(NodeId node) const;  // of the compiled mesh
  Place between(const Place& a, const Place& b, double t) const;
  Vec3 offset(const Place& place) const;  // m, from the boundary at rest
  /// Tells whether that edge's middle is drawn: the surface is not straight between the ends.
  bool has_middle(const Place& a, const Place& b) const;

 private:
  struct Edge {
    NodeId high = 0;  // end; the lower one's edges are together
    std::array<NodeId, 2> beyond{};
    Vec3 sag = Vec3::Zero();  // of the middle from half way between the ends, m
    bool middle = false;
  };
  class Fit;
  const Edge* edge(NodeId a, NodeId b) const;

  std::vector<Vec3> offset_;          // by node, m
  std::vector<std::uint8_t> outer_;   // by node
  std::vector<std::uint32_t> begin_;  // of its edges, by lower node
  std::vector<Edge> edges_;           // ascending
};

}  // namespace prosector
