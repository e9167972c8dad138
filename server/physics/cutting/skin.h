#pragma once
// The surface of a body that can be cut: the tetrahedra's own boundary, walls of cuts included. Its outside
// is drawn at its shape (outer_shape.h). It is kept as slots that are never used again. Closed: each edge has
// two triangles, which agree; so walls meet the outside without a seam.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "server/physics/cutting/outer_shape.h"
#include "server/physics/cutting/tet_complex.h"

namespace prosector {

class Skin {
 public:
  /// A vertex at a node, or half way between two: of an edge with a middle, or where a cut has opened an edge
  /// but neither of its ends yet. There the two pairs of triangles that meet must not be confused.
  struct Vertex {
    std::array<NodeId, 4> node{};    // that it hangs on; those of weight 0 don't count
    std::array<double, 4> weight{};  // sum: 1
    bool operator==(const Vertex&) const = default;
  };
  struct Triangle {
    std::array<std::uint32_t, 3> corners{};  // vertex slots, counter-clockwise from outside; equal: gone
    bool inner = false;                      // a cut laid it bare
    bool operator==(const Triangle&) const = default;
    bool gone() const { return corners[0] == corners[1]; }
  };
  /// What an update changed. Vertices are only ever appended.
  struct Change {
    std::uint32_t first_vertex = 0;  // slot of the first of `vertices`
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> slots;  // of triangles that were set, ascending
    std::vector<Triangle> triangles;   // what they are now
  };

  /// Builds the skin; of a sheet, which is its own surface, nothing. `shape`: that of the outside; none: the
  /// boundary itself.
  explicit Skin(const TetComplex& complex, std::shared_ptr<const OuterShape> shape = nullptr);
  /// Follows the complex: after a cut, and after one was taken back, when live triangles are what they were,
  /// in the same slots.
  Change update(const TetComplex& complex);
  /// Updates the skin as update() does, looking only where the cut, or the cuts taken back, touched it
  /// (touched.h).
  Change follow(const TetComplex& complex, std::span<const TetId> touched);

  std::span<const Vertex> vertices() const { return vertices_; }      // by slot
  std::span<const Triangle> triangles() const { return triangles_; }  // by slot
  /// Returns, of a triangle's slot, the tetrahedron whose face the triangle is a part of.
  TetId tet(std::uint32_t slot) const { return static_cast<TetId>(key_[slot] / 16); }

 private:
  using Edge = std::array<NodeId, 2>;         // ascending
  using Face = std::array<std::uint32_t, 2>;  // tetrahedron, and which of its faces
  /// What a vertex is, as the mesh is: ends of its edge, or a node twice. With them goes the tetrahedron that
  /// it hangs on, by its corners, which a cut may change.
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
  std::vector<OuterShape::Place> place_;  // by node, where it was asked for
  std::vector<std::uint8_t> placed_;      // whether it was
  std::vector<Vertex> vertices_;
  std::vector<Name> name_;             // of each vertex
  std::vector<std::uint32_t> next_;    // of each vertex: another one of the same lower node
  std::vector<std::uint32_t> newest_;  // by lower node: the first of these
  std::vector<Triangle> triangles_;
  std::vector<std::uint64_t> key_;        // of each triangle: 16·tet + 4·face + part
  std::vector<std::uint32_t> slot_of_;    // by key
  std::vector<std::uint32_t> vertex_of_;  // by node, and when it was found
  std::vector<std::uint32_t> found_;
  std::vector<std::uint32_t> seen_;  // by slot: when last part of the boundary
  std::uint32_t now_ = 0;
  std::vector<Edge> double_edges_;  // ascending
};

}  // namespace prosector
