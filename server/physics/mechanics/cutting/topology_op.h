#pragma once
// Elementary topology changes that make up a cut, as plain data for the log. Each can be applied to a
// TetComplex and undone exactly.

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

namespace prosector::cutting {

/// Ids of nodes and tetrahedra within one body. They are never reused, not even after an undo. Nodes and
/// tetrahedra of the compiled mesh have their indices as ids.
using NodeId = std::uint32_t;
using TetId = std::uint32_t;

/// Topology change that splits edge a–b at a + t·(b − a), and each tetrahedron around the edge into two. The
/// i-th of these tetrahedra, in ascending order, is replaced by `first + 2i`, which keeps corner a, and
/// `first + 2i + 1`, which keeps corner b.
struct SplitEdge {
  NodeId a = 0, b = 0;
  NodeId node = 0;          // new node
  double t = 0;             // in (0, 1)
  TetId first = 0;          // first of the new tetrahedra
  std::uint32_t count = 0;  // number of tetrahedra that are split
  bool operator==(const SplitEdge&) const = default;
};

/// Topology change that separates pairs of tetrahedra at their common face; each of the two gets a boundary
/// face there.
struct SlitFaces {
  std::vector<std::array<TetId, 2>> faces;
  bool operator==(const SlitFaces&) const = default;
};

/// Topology change that duplicates a node whose tetrahedra are no longer connected through faces. Each copy
/// takes over its listed tetrahedra; the others keep `node`.
struct PartNode {
  struct Copy {
    NodeId node = 0;          // new node
    std::vector<TetId> tets;  // ascending
    bool operator==(const Copy&) const = default;
  };
  NodeId node = 0;
  std::vector<Copy> copies;
  bool operator==(const PartNode&) const = default;
};

using TopologyOp = std::variant<SplitEdge, SlitFaces, PartNode>;

}  // namespace prosector::cutting
