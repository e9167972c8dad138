#pragma once
// A sheet or rope as elements that meet one another: triangles, or segments.

#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/collision/closest_points.h"
#include "server/physics/collision/surface_tree.h"
#include "server/physics/contact/contact.h"

namespace prosector {

/// Of sheets the triangles of the cells, each once; of ropes the pieces, as triangles whose last two corners
/// are one. Their corners are nodes. The tree over them is built at rest and refitted.
class ElementSurface {
 public:
  explicit ElementSurface(const Anatomy& anatomy);
  /// To the nodes' positions x (3n, m).
  void move(const VecX& x);

  const SurfaceTree& tree() const { return tree_; }
  const SurfaceTree::Corners& corners(std::uint32_t element) const { return elements_[element]; }
  Triangle now(std::uint32_t element) const { return triangle(element, positions_); }
  Triangle at_rest(std::uint32_t element) const { return triangle(element, rest_); }
  /// Elements that share a corner with this one, and itself; ascending.
  std::span<const std::uint32_t> around(std::uint32_t element) const {
    return {around_.data() + around_begin_[element], around_.data() + around_begin_[element + 1]};
  }
  /// Which corner, edge or face of the surface the point with these weights lies on: the same for all
  /// elements that share it. Below features().
  std::uint32_t feature(std::uint32_t element, const Vec3& weights) const;
  std::size_t features() const { return rest_.size() + edges_.size() + elements_.size(); }
  /// Adds the point with these weights of the element's corners.
  void add(std::uint32_t element, const Vec3& weights, ContactSide& side) const;

 private:
  Triangle triangle(std::uint32_t element, const std::vector<Vec3>& of) const {
    const auto& c = elements_[element];
    return {of[c[0]], of[c[1]], of[c[2]]};
  }
  void find_edges();
  void find_neighbours();

  std::vector<SurfaceTree::Corners> elements_;
  std::vector<std::array<std::uint32_t, 2>> edges_;  // ascending
  std::vector<Vec3> rest_, positions_;               // by node
  std::vector<std::uint32_t> around_begin_, around_;
  SurfaceTree tree_;
};

}  // namespace prosector
