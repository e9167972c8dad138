#pragma once
// Boxes around boxes of a mesh's triangles, so that a ray meets few of them.

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

  /// Follows the mesh: sorts its triangles anew where they changed, and only grows or shrinks the boxes where
  /// its vertices moved.
  void follow(const DrawMesh& mesh);
  /// Returns where the ray first meets the outside of the mesh that was followed last, in the mesh's frame.
  std::optional<Hit> meet(const DrawMesh& mesh, const Ray& ray) const;

 private:
  /// A box around `count` triangles of order_, or, with none, around the next node and the node `other`.
  struct Node {
    Eigen::AlignedBox3f box;
    std::uint32_t first = 0, count = 0, other = 0;
  };
  std::vector<Node> nodes_;  // a node comes before those in it
  std::vector<std::uint32_t> order_;
  std::optional<std::uint64_t> revision_, positions_revision_;

  void sort(const DrawMesh& mesh);
  void divide(const std::vector<Eigen::Vector3f>& middles, std::uint32_t first, std::uint32_t count);
  void fit(const DrawMesh& mesh);
};

/// The trees of all meshes that rays were tried on, by the meshes' ids.
class SurfaceTrees {
 public:
  /// Returns where the ray first meets the item's outside, in the room.
  std::optional<SurfacePoint> meet(const Ray& ray, const DrawItem& item);

 private:
  std::map<std::uint64_t, SurfaceTree> trees_;
};

}  // namespace prosector
