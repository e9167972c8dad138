#pragma once
// A sheet or rope as elements that meet one another: triangles, or segments.

#include <algorithm>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/collision/primitives/closest_points.h"
#include "server/physics/collision/surface/surface_tree.h"
#include "server/physics/contact/contact.h"

namespace prosector {

/// The elements of a thin body as others meet them: a sheet's cells as triangles, each once; a rope's pieces,
/// as triangles whose last two corners are one. Their corners are nodes. The tree over them is built at rest
/// and refitted.
class ElementSurface {
 public:
  explicit ElementSurface(const Anatomy& anatomy);
  /// Moves the surface to the nodes' positions x (3n, m).
  void move(const VecX& x);

  const SurfaceTree& tree() const { return tree_; }
  const SurfaceTree::Corners& corners(std::uint32_t element) const { return elements_[element]; }
  Triangle now(std::uint32_t element) const { return triangle(element, positions_); }
  Triangle at_rest(std::uint32_t element) const { return triangle(element, rest_); }
  /// Returns the elements that share a corner with this one, and itself; ascending.
  std::span<const std::uint32_t> around(std::uint32_t element) const {
    return {around_.data() + around_begin_[element], around_.data() + around_begin_[element + 1]};
  }
  /// Tells whether elements lead from the one to the other that at rest are nearer than `reach` (m) to it.
  /// Found when first asked for, all of one at once: not by several threads at the same time.
  bool hang_together(std::uint32_t element, std::uint32_t other, double reach) const;
  /// Returns which corner, edge or face of the surface the point with these weights lies on: the same for all
  /// elements that share it. Below features().
  std::uint32_t feature(std::uint32_t element, const Vec3& weights) const;
  /// Tells whether the surface leads no nearer to what lies in direction `n` (unit) of that point. At a
  /// corner or an edge it does so where n is in its normal cone, but for `slack` rad; on a face always.
  bool crest_at(std::uint32_t element, const Vec3& weights, const Vec3& n, double slack) const;
  /// Tells whether a face with that point is square to n, but for `slack` rad.
  bool level_at(std::uint32_t element, const Vec3& weights, const Vec3& n, double slack) const;
  std::size_t features() const { return rest_.size() + edges_.size() + elements_.size(); }
  /// Returns the mean normal, unit and along n, of the faces with that point; 0 for a rope.
  Vec3 normal_at(std::uint32_t element, const Vec3& weights, const Vec3& n) const;
  /// Tells whether the element is a rope's piece.
  bool thread(std::uint32_t element) const { return elements_[element][1] == elements_[element][2]; }
  /// Adds the point with these weights of the element's corners.
  void add(std::uint32_t element, const Vec3& weights, ContactSide& side) const;

 private:
  Triangle triangle(std::uint32_t element, const std::vector<Vec3>& of) const {
    const auto& c = elements_[element];
    return {of[c[0]], of[c[1]], of[c[2]]};
  }
  /// The nodes that carry a point: one, two or three.
  struct Support {
    std::array<std::uint32_t, 3> node{};
    std::size_t count = 0;
    bool has(std::uint32_t n) const {
      return std::find(node.begin(), node.begin() + count, n) != node.begin() + count;
    }
    bool within(const SurfaceTree::Corners& c) const {
      return std::all_of(node.begin(), node.begin() + count,
                         [&](std::uint32_t n) { return std::find(c.begin(), c.end(), n) != c.end(); });
    }
  };
  Support support(std::uint32_t element, const Vec3& weights) const;
  Vec3 doubled_area(std::uint32_t element) const;  // m², along the normal
  void find_edges();
  void find_neighbours();

  std::vector<SurfaceTree::Corners> elements_;
  std::vector<std::array<std::uint32_t, 2>> edges_;  // ascending
  std::vector<Vec3> rest_, positions_;               // by node
  std::vector<std::uint32_t> around_begin_, around_;
  /// The elements that hang_together() leads to, by element, for the last reach asked for; with itself,
  /// ascending; empty: not asked for.
  mutable std::vector<std::vector<std::uint32_t>> together_;
  mutable double reach_ = 0;
  SurfaceTree tree_;
};

}  // namespace prosector
