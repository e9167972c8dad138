#pragma once
// Bounding volume hierarchy of a mesh's triangles, for ray casting.

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "client/view/draw_list.h"
#include "client/view/pick.h"

namespace prosector {

class SurfaceTree {
 public:
  struct Hit {
    double distance = 0;  // in lengths of the ray's direction
    std::uint32_t triangle = 0;
  };

  /// Updates the bounding volume hierarchy for the mesh: rebuilds it if triangles changed, refits the boxes
  /// if vertices moved.
  void follow(const DrawMesh& mesh);
  /// Returns where the ray, given in the mesh's frame, first meets the front side of the mesh; nullopt if it
  /// does not. `mesh` must be the one passed to the last follow().
  std::optional<Hit> meet(const DrawMesh& mesh, const Ray& ray) const;

 private:
  /// Node of the bounding volume hierarchy. If `count` is not 0, it is a leaf with `count` triangles of
  /// order_, from `first` on. Otherwise it is an inner node, whose children are the next node and `other`.
  struct Node {
    Eigen::AlignedBox3f box;
    std::uint32_t first = 0, count = 0, other = 0;
  };
  std::vector<Node> nodes_;  // parents come before their children
  std::vector<std::uint32_t> order_;
  std::optional<std::uint64_t> revision_, positions_revision_;

  void sort(const DrawMesh& mesh);
  void divide(const std::vector<Eigen::Vector3f>& middles, std::uint32_t first, std::uint32_t count);
  void fit(const DrawMesh& mesh);
};

/// Bounding volume hierarchies of all meshes that were ray-cast, by mesh id.
class SurfaceTrees {
 public:
  /// Returns where the ray (world frame) first meets the front side of the item, in the world frame; nullopt
  /// if it does not.
  std::optional<SurfacePoint> meet(const Ray& ray, const DrawItem& item);

 private:
  std::map<std::uint64_t, SurfaceTree> trees_;
};

}  // namespace prosector
