#pragma once
// The elements of a sheet or rope for contact of thin bodies: triangles or segments.

#include <algorithm>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/collision/primitives/closest_points.h"
#include "server/physics/mechanics/collision/surface/surface_tree.h"
#include "server/physics/mechanics/contact/contact.h"

namespace prosector {

/// Contact elements of a thin body. A sheet's cells are triangles, each stored once. A rope's segments are
/// triangles whose last two corners are equal. Corners are nodes. The bounding-volume tree is built at rest
/// and refitted.
class ElementSurface {
 public:
  explicit ElementSurface(const Anatomy& anatomy);
  /// Moves the surface to the node positions x (3n, m).
  void move(const VecX& x);

  const SurfaceTree& tree() const { return tree_; }
  const SurfaceTree::Corners& corners(std::uint32_t element) const { return elements_[element]; }
  Triangle now(std::uint32_t element) const { return triangle(element, positions_); }
  Triangle at_rest(std::uint32_t element) const { return triangle(element, rest_); }
  /// Returns the elements that share a corner with this one, including itself; ascending.
  std::span<const std::uint32_t> around(std::uint32_t element) const {
    return {around_.data() + around_begin_[element], around_.data() + around_begin_[element + 1]};
  }
  /// Returns whether a chain of neighbouring elements connects the two, all nearer than `reach` (m) to
  /// `element` at rest. Computes the set of an element when it is first queried and caches it. Not
  /// thread-safe.
  bool hang_together(std::uint32_t element, std::uint32_t other, double reach) const;
  /// Returns the index of the corner, edge or face on which the point with these weights lies. All elements
  /// that share the feature return the same index. The index is less than features().
  std::uint32_t feature(std::uint32_t element, const Vec3& weights) const;
  /// Returns whether the surface near the point lies behind the point in direction `n` (unit). For a corner
  /// or an edge: whether n is in its normal cone, within `slack` rad. For a face: always.
  bool crest_at(std::uint32_t element, const Vec3& weights, const Vec3& n, double slack) const;
  /// Returns whether a face with that point is perpendicular to n, within `slack` rad.
  bool level_at(std::uint32_t element, const Vec3& weights, const Vec3& n, double slack) const;
  std::size_t features() const { return rest_.size() + edges_.size() + elements_.size(); }
  /// Returns the unit mean normal of the faces with that point, oriented along n; 0 for a rope.
  Vec3 normal_at(std::uint32_t element, const Vec3& weights, const Vec3& n) const;
  /// Returns whether the element is a segment of a rope.
  bool thread(std::uint32_t element) const { return elements_[element][1] == elements_[element][2]; }
  /// Adds the point with these barycentric weights to a contact side.
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
  /// Cached sets of hang_together() for the last reach, by element; each contains the element, ascending.
  /// Empty: not computed.
  mutable std::vector<std::vector<std::uint32_t>> together_;
  mutable double reach_ = 0;
  SurfaceTree tree_;
};

}  // namespace prosector
