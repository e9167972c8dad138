#pragma once
// The hierarchical functions (bubbles.h) that a body's elements lack first, with which the body's stress is
// tested. Private to server/accuracy.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "server/accuracy/bubbles.h"
#include "server/accuracy/estimated_body.h"
#include "server/accuracy/outer_surface.h"

namespace prosector::estimation {

/// Index of the hierarchical functions: numbers edges and faces by their sorted corners.
class FunctionIndex {
 public:
  using Key = std::array<std::uint32_t, 3>;  // for an edge: its second corner twice
  static Key key(std::span<const std::size_t> corners, std::span<const std::uint32_t> nodes) {
    Key out{nodes[corners[0]], nodes[corners[1]], nodes[corners.back()]};
    std::sort(out.begin(), out.end());
    return out;
  }
  void add(const Key& key) { keys_.push_back(key); }
  void close() {
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  }
  std::size_t size() const { return keys_.size(); }
  const Key& operator[](std::size_t k) const { return keys_[k]; }
  std::uint32_t find(const Key& key) const {
    return static_cast<std::uint32_t>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin());
  }

 private:
  std::vector<Key> keys_;
};

/// The shape functions of the next higher order, which a body's elements lack. Contains each function's index
/// in every element and outer face that has it, and its compliance (displacement per force, m/N).
struct MissingFunctions {
  explicit MissingFunctions(const EstimatedBody& body);

  BubbleTable table;
  FunctionIndex index;
  std::vector<std::uint32_t> of_element;  // by element and table.of_tet
  std::vector<std::uint32_t> owner;       // by function: the element whose rotation applies
  std::vector<Mat3> compliance;           // m/N, by function: K⁻¹ at rest
  std::vector<OuterFace> faces;
  std::vector<std::uint32_t> of_face;  // by face and table.of_face
  std::vector<double> area;            // m², by vertex: its share of the outer faces

  std::size_t size() const { return index.size(); }

 private:
  void number(const EstimatedBody& body);
  void find_faces(const EstimatedBody& body);
  void make_compliance(const EstimatedBody& body);
};

}  // namespace prosector::estimation
