#pragma once
// The elements of a sheet or rope for contact of thin bodies: triangles or segments.

#include <algorithm>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/collision/primitives/closest_points.h"
#include "server/physics/mechanics/collision/surface/surface_tree.h"
#include "server/physics/mechanics/contact/contact.h"

namespace prosector::contact {

/// Elements of a thin body for contact: the triangles of a sheet, each stored once, or the segments of a
/// rope. A segment is stored as a triangle whose last two corners are equal. Corners are nodes of the body.
/// The bounding volume tree is built at rest and refitted to moved nodes.
class ElementSurface {
 public:
  explicit ElementSurface(const Anatomy& anatomy);
  /// Moves the corners to the current node positions x (three coordinates per node, m) and refits the tree.
  void move(const VecX& x);

  const collision::SurfaceTree& tree() const { return tree_; }
  const collision::SurfaceTree::Corners& corners(std::uint32_t element) const { return elements_[element]; }
  collision::Triangle now(std::uint32_t element) const { return triangle(element, positions_); }
  collision::Triangle at_rest(std::uint32_t element) const { return triangle(element, rest_); }
  /// Returns the indices of the elements that share a corner with this element, itself included; ascending.
  std::span<const std::uint32_t> around(std::uint32_t element) const {
    return {around_.data() + around_begin_[element], around_.data() + around_begin_[element + 1]};
  }
  /// Returns whether a chain of neighbouring elements connects `element` with `other`, all of them closer to
  /// `element` than `reach` (m) at rest. The result for an element is computed at its first query and cached,
  /// so the function is not thread-safe.
  bool hang_together(std::uint32_t element, std::uint32_t other, double reach) const;
  /// Returns the index of the surface's corner, edge or face on which the point with these barycentric
  /// weights of the element is located. All elements that share this corner or edge return the same index. It
  /// is less than features().
  std::uint32_t feature(std::uint32_t element, const Vec3& weights) const;
  /// Returns whether the surface around a point of an element recedes in direction −n (n unit), as at a
  /// crest. At a corner or on an edge, this means that n is in the normal cone, within `slack` rad. Inside a
  /// face it is always true. `weights`: the point's barycentric weights.
  bool crest_at(std::uint32_t element, const Vec3& weights, const Vec3& n, double slack) const;
  /// Returns whether any element that contains the point with these barycentric weights is perpendicular to
  /// the unit vector n, within `slack` rad.
  bool level_at(std::uint32_t element, const Vec3& weights, const Vec3& n, double slack) const;
  std::size_t features() const { return rest_.size() + edges_.size() + elements_.size(); }
  /// Returns the unit mean normal of all triangles that contain the point with these barycentric weights of
  /// the element. Each normal is flipped to the side of n before the mean is taken. Returns 0 for a rope,
  /// whose segments have no normal.
  Vec3 normal_at(std::uint32_t element, const Vec3& weights, const Vec3& n) const;
  /// Returns whether the element is a segment of a rope rather than a triangle of a sheet.
  bool thread(std::uint32_t element) const { return elements_[element][1] == elements_[element][2]; }
  /// Adds the nodes of the element's point with these barycentric weights to a side of a contact, so that the
  /// side's force acts on them.
  void add(std::uint32_t element, const Vec3& weights, ContactSide& side) const;

 private:
  collision::Triangle triangle(std::uint32_t element, const std::vector<Vec3>& of) const {
    const auto& c = elements_[element];
    return {of[c[0]], of[c[1]], of[c[2]]};
  }
  /// Nodes of an element whose weights at a point are not zero: one for a corner, two for an edge, three for
  /// a face.
  struct Support {
    std::array<std::uint32_t, 3> node{};
    std::size_t count = 0;
    bool has(std::uint32_t n) const {
      return std::find(node.begin(), node.begin() + count, n) != node.begin() + count;
    }
    bool within(const collision::SurfaceTree::Corners& c) const {
      return std::all_of(node.begin(), node.begin() + count,
                         [&](std::uint32_t n) { return std::find(c.begin(), c.end(), n) != c.end(); });
    }
  };
  Support support(std::uint32_t element, const Vec3& weights) const;
  Vec3 doubled_area(std::uint32_t element) const;  // m², along the normal
  void find_edges();
  void find_neighbours();

  std::vector<collision::SurfaceTree::Corners> elements_;
  std::vector<std::array<std::uint32_t, 2>> edges_;  // ascending
  std::vector<Vec3> rest_, positions_;               // by node
  std::vector<std::uint32_t> around_begin_, around_;
  /// For each element, the cached result of hang_together() for the last `reach`: the connected elements,
  /// itself included, ascending. Empty if it was not computed.
  mutable std::vector<std::vector<std::uint32_t>> together_;
  mutable double reach_ = 0;
  collision::SurfaceTree tree_;
};

}  // namespace prosector::contact
