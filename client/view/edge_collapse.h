#pragma once
// Mesh simplification over the same vertices: edges collapse into one of their ends, in order of the least
// surface displacement. Each vertex accumulates the displacement of the surface that it represents. Method:
// Klein, Liebich, Straßer, Mesh reduction with error control, IEEE Visualization 1996, but with distances at
// vertices only.

#include <array>
#include <cstdint>
#include <queue>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Surface mesh that is simplified by collapsing edges into one of their vertices. Vertices on open edges and
/// on non-manifold edges (more than two triangles) stay. The result depends only on the arguments.
class EdgeCollapser {
 public:
  /// Prepares the simplification of a surface mesh. Stores a reference to `positions`, which must outlive
  /// this object.
  EdgeCollapser(std::span<const Eigen::Vector3f> positions, const Triangles& triangles);

  /// Collapses edges until at most `triangles` triangles are left. Returns false if that is impossible,
  /// because each further collapse would flip a triangle or change the surface's topology.
  bool reduce_to(std::size_t triangles);
  bool is_gone(std::size_t triangle) const { return gone_[triangle]; }
  /// Returns the remaining vertex into which vertex `v` collapsed, directly or through others; `v` itself if
  /// it remains.
  std::uint32_t replacement_of(std::uint32_t v) const;

 private:
  struct Candidate {
    float cost;   // m²
    float moved;  // m: accumulated displacement of the surface at `from` after the collapse
    std::uint32_t from, into;
    bool operator>(const Candidate& o) const { return cost != o.cost ? cost > o.cost : from > o.from; }
  };

  std::span<const Eigen::Vector3f> at_;
  Triangles triangles_;
  std::vector<bool> gone_;  // by triangle
  std::size_t left_;
  std::vector<std::vector<std::uint32_t>> around_;  // triangles at each vertex; some may be removed
  // By vertex; changed_: its surroundings changed since its candidate was queued.
  std::vector<bool> stays_, changed_;
  std::vector<std::uint32_t> into_;  // by vertex; its own index if it remains
  std::vector<float> moved_;  // m, by vertex: accumulated displacement of the surface that it represents
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;

  void keep_borders();
  std::vector<std::uint32_t> neighbours(std::uint32_t v) const;
  void enqueue(std::uint32_t from);
  bool may_collapse(std::uint32_t from, std::uint32_t into) const;
  Candidate candidate(std::uint32_t from, std::uint32_t into) const;
  void collapse(const Candidate& edge);
};

}  // namespace prosector
