#pragma once
// The elementary changes that the result of a cut consists of, as plain data: what the log carries. Each can
// be applied to a TetComplex and taken back exactly.

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

namespace prosector {

/// Ids within one body; never reused, not after an undo either. Nodes and tetrahedra of the compiled mesh
/// have their indices as ids.
using NodeId = std::uint32_t;
using TetId = std::uint32_t;

/// The edge a–b gets a node at a + t·(b − a), and each tetrahedron with both becomes two. Of the i-th such
/// tetrahedron in ascending order, `first + 2i` keeps a and `first + 2i + 1` keeps b.
struct SplitEdge {
  NodeId a = 0, b = 0;
  NodeId node = 0;          // the new one
  double t = 0;             // in (0, 1)
  TetId first = 0;          // of the new tetrahedra
  std::uint32_t count = 0;  // tetrahedra that become two
  bool operator==(const SplitEdge&) const = default;
};

/// Pairs of tetrahedra that had a face in common and no longer do; each has a boundary face there from now
/// on.
struct SlitFaces {
  std::vector<std::array<TetId, 2>> faces;
  bool operator==(const SlitFaces&) const = default;
};

/// A node whose tetrahedra no longer hold together becomes several: each copy takes its tetrahedra with it,
/// what isn't listed stays at `node`.
struct PartNode {
  struct Copy {
    NodeId node = 0;          // new
    std::vector<TetId> tets;  // ascending
    bool operator==(const Copy&) const = default;
  };
  NodeId node = 0;
  std::vector<Copy> copies;
  bool operator==(const PartNode&) const = default;
};

using TopologyOp = std::variant<SplitEdge, SlitFaces, PartNode>;

}  // namespace prosector
