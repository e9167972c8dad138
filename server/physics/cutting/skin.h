#pragma once
// The surface of a body that can be cut: the tetrahedra's own boundary, walls of cuts included, as slots that
// are never used again. Closed: each edge has two triangles, which agree; so walls meet the outside without a
// seam.

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "server/physics/cutting/tet_complex.h"

namespace prosector {

class Skin {
 public:
  /// Hangs on one node, or half way between two: where a cut has opened an edge but neither of its ends yet,
  /// the two pairs of triangles that meet there have a vertex each, so that none is confused.
  struct Vertex {
    std::array<NodeId, 2> node{};  // equal: one node
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

  explicit Skin(const TetComplex& complex);  // of a sheet, which is its own surface, nothing
  /// Follows the complex: after a cut, and after one was taken back, when live triangles are what they were,
  /// in the same slots.
  Change update(const TetComplex& complex);
  /// The same, looking only where the cut, or the cuts taken back, touched it (touched.h).
  Change follow(const TetComplex& complex, std::span<const TetId> touched);

  std::span<const Vertex> vertices() const { return vertices_; }      // by slot
  std::span<const Triangle> triangles() const { return triangles_; }  // by slot
  /// Of a triangle's slot: the tetrahedron whose face it is a part of.
  TetId tet(std::uint32_t slot) const { return static_cast<TetId>(key_[slot] / 16); }

 private:
  using Edge = std::array<NodeId, 2>;         // ascending
  using Face = std::array<std::uint32_t, 2>;  // tetrahedron, and which of its faces
  Change begin(const TetComplex& complex);
  void end(Change& change) const;
  void find_double_edges(const TetComplex& complex, std::span<const Face> faces);
  std::vector<Face> faces_near(const TetComplex& complex, std::span<const TetId> touched) const;
  void put_face(const TetComplex& complex, TetId tet, std::size_t k, Change& change);
  std::uint32_t corner(NodeId node);
  std::uint32_t middle(const TetComplex& complex, TetId tet, std::size_t k, const Edge& edge);
  void set(std::uint64_t key, const Triangle& triangle, Change& change);
  void clear_unseen(std::uint32_t slot, Change& change);

  std::vector<Vertex> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint64_t> key_;        // of each triangle: 16·tet + 4·face + part
  std::vector<std::uint32_t> slot_of_;    // by key
  std::vector<std::uint32_t> vertex_of_;  // by node
  std::map<std::array<std::uint64_t, 3>, std::uint32_t> middle_of_;  // by pair of faces and edge; few
  std::vector<std::uint32_t> seen_;  // by slot: when last part of the boundary
  std::uint32_t now_ = 0;
  std::vector<Edge> double_edges_;  // ascending
};

}  // namespace prosector
