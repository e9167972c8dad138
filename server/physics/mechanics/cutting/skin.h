#pragma once
// Surface of a body that can be cut: the boundary of its tetrahedra, including the walls of cuts. The outside
// is drawn at the outer shape (outer_shape.h). Vertices and triangles have slots that are never reused. The
// surface is closed: each edge has two triangles of consistent orientation, so walls join the outside without
// a seam.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "server/physics/mechanics/cutting/outer_shape.h"
#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector::cutting {

class Skin {
 public:
  /// Surface vertex at a node or at the midpoint of an edge. Midpoints are used for edges at which the outer
  /// shape is curved, and for edges that a cut has opened but not yet at their ends. Such an opened edge has
  /// two pairs of adjacent triangles, one on each side of the cut; their midpoints keep the pairs distinct.
  struct Vertex {
    std::array<NodeId, 4> node{};    // nodes that carry the vertex; those of weight 0 are ignored
    std::array<double, 4> weight{};  // sum: 1
    bool operator==(const Vertex&) const = default;
  };
  struct Triangle {
    // Vertex slots, counter-clockwise from outside; equal: the triangle was removed.
    std::array<std::uint32_t, 3> corners{};
    bool inner = false;  // whether the triangle is a wall of a cut
    bool operator==(const Triangle&) const = default;
    bool gone() const { return corners[0] == corners[1]; }
  };
  /// Changes that one update made to the surface: appended vertices, and changed triangles. Vertices are only
  /// appended.
  struct Change {
    std::uint32_t first_vertex = 0;  // slot of the first of `vertices`
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> slots;  // slots of the changed triangles, ascending
    std::vector<Triangle> triangles;   // their new values
  };

  /// Builds the surface of a body. It stays empty for a sheet, which is its own surface. `shape`: the outer
  /// shape, at which the outside is drawn; null to draw the boundary of the tetrahedra.
  explicit Skin(const TetComplex& complex, std::shared_ptr<const OuterShape> shape = nullptr);
  /// Updates the whole surface after a cut or an undone cut, and returns the changes. After an undone cut,
  /// triangles that still exist have their previous values in the same slots (permanent indices).
  Change update(const TetComplex& complex);
  /// Updates the surface after a cut, or an undone cut, with the same result as update(), but examines only
  /// the tetrahedra in `touched`, which the cut changed (touched.h). Returns the changes.
  Change follow(const TetComplex& complex, std::span<const TetId> touched);

  std::span<const Vertex> vertices() const { return vertices_; }      // by slot
  std::span<const Triangle> triangles() const { return triangles_; }  // by slot
  /// Returns the id of the tetrahedron with the face to which the triangle in this slot (permanent triangle
  /// index) belongs.
  TetId tet(std::uint32_t slot) const { return static_cast<TetId>(key_[slot] / 16); }

 private:
  using Edge = std::array<NodeId, 2>;         // ascending
  using Face = std::array<std::uint32_t, 2>;  // tetrahedron, and index of its face
  /// Identity of a surface vertex in the mesh. `edge`: the two nodes of its edge, or the same node twice for
  /// a vertex at a node. `carrier`: the corners of the tetrahedron that carries the vertex, which a cut may
  /// change.
  struct Name {
    Edge edge{};
    std::array<NodeId, 4> carrier{};
    bool operator==(const Name&) const = default;
  };
  Change begin(const TetComplex& complex);
  void end(Change& change) const;
  void find_double_edges(const TetComplex& complex, std::span<const Face> faces);
  std::vector<Face> faces_near(const TetComplex& complex, std::span<const TetId> touched);
  void put_face(const TetComplex& complex, TetId tet, std::size_t k, Change& change);
  bool has_middle(const TetComplex& complex, const Edge& edge);
  std::uint32_t corner(const TetComplex& complex, NodeId node);
  std::uint32_t middle(const TetComplex& complex, TetId tet, std::size_t k, const Edge& edge);
  std::uint32_t vertex(const TetComplex& complex, const Edge& edge, TetId carrier);
  const OuterShape::Place& place(const TetComplex& complex, NodeId node);
  Vec3 offset(const TetComplex& complex, const Edge& edge);
  void set(std::uint64_t key, const Triangle& triangle, Change& change);
  void clear_unseen(std::uint32_t slot, Change& change);

  std::shared_ptr<const OuterShape> shape_;
  std::vector<OuterShape::Place> place_;  // by node, computed when needed
  std::vector<std::uint8_t> placed_;      // by node: whether place_ was computed
  std::vector<Vertex> vertices_;
  std::vector<Name> name_;             // of each vertex
  std::vector<std::uint32_t> next_;    // of each vertex: the next vertex with the same lower node
  std::vector<std::uint32_t> newest_;  // by lower node: the first of these vertices
  std::vector<Triangle> triangles_;
  std::vector<std::uint64_t> key_;        // of each triangle: 16·tet + 4·face + part
  std::vector<std::uint32_t> slot_of_;    // by key
  std::vector<std::uint32_t> vertex_of_;  // by node, and the update in which it was found
  std::vector<std::uint32_t> found_;
  std::vector<std::uint32_t> seen_;  // by slot: the last update in which it was part of the boundary
  std::uint32_t now_ = 0;
  std::vector<Edge> double_edges_;  // ascending
};

}  // namespace prosector::cutting
