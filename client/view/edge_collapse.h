#pragma once
// Fewer triangles over the same vertices: edges collapse into one of their ends, first where that moves the
// surface least. Each vertex adds up how far what it stands for has moved. So do Klein, Liebich, Straßer,
// Mesh reduction with error control, IEEE Visualization 1996; here it is by distances at vertices alone.

#include <array>
#include <cstdint>
#include <queue>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// A surface while its edges collapse. Vertices on open edges, and where more than two triangles meet in an
/// edge, stay. The result depends on nothing but what it was given.
class EdgeCollapser {
 public:
  /// Takes `positions` that outlive it.
  EdgeCollapser(std::span<const Eigen::Vector3f> positions, const Triangles& triangles);

  /// Collapses edges until that many triangles are left. Returns false where no more edges can collapse
  /// without a triangle turning over or the surface changing its topology.
  bool reduce_to(std::size_t triangles);
  bool is_gone(std::size_t triangle) const { return gone_[triangle]; }
  /// Returns the vertex that `v` collapsed into, and that in turn; itself while it is there.
  std::uint32_t stand_in(std::uint32_t v) const;

 private:
  struct Candidate {
    float cost;   // m²
    float moved;  // m, that the surface at `from` will have, altogether
    std::uint32_t from, into;
    bool operator>(const Candidate& o) const { return cost != o.cost ? cost > o.cost : from > o.from; }
  };

  std::span<const Eigen::Vector3f> at_;
  Triangles triangles_;
  std::vector<bool> gone_;  // by triangle
  std::size_t left_;
  std::vector<std::vector<std::uint32_t>> around_;  // triangles at each vertex; some may be gone
  std::vector<bool> stays_, changed_;  // by vertex; changed_: near it, since its candidate was queued
  std::vector<std::uint32_t> into_;    // by vertex; itself: it is there
  std::vector<float> moved_;           // m, by vertex: how far the surface that it stands for did
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;

  void keep_borders();
  std::vector<std::uint32_t> neighbours(std::uint32_t v) const;
  void enqueue(std::uint32_t from);
  bool may_collapse(std::uint32_t from, std::uint32_t into) const;
  Candidate candidate(std::uint32_t from, std::uint32_t into) const;
  void collapse(const Candidate& edge);
};

}  // namespace prosector
