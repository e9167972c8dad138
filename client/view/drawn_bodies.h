#pragma once
// The bodies in a draw list, and what a ray meets of them.

#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "client/view/draped_line.h"
#include "client/view/draw_list.h"
#include "client/view/pick.h"
#include "client/view/surface_tree.h"
#include "common/ids.h"

namespace prosector {

/// Bodies that are drawn as items of a DrawList, with their bounding volume hierarchies, so that rays can be
/// intersected with what is drawn of them. The list must be the one whose items were added.
class DrawnBodies {
 public:
  /// One item of the draw list that draws a body.
  struct Item {
    BodyId body = 0;
    std::size_t index = 0;  // index in DrawList::items
    bool inner = false;     // a cut surface
  };

  /// Removes all items and parts, before the draw list is rebuilt. The hierarchies of unchanged meshes stay.
  void clear();
  /// Adds the draw list's item with this index, which draws the body; `inner`: a cut surface of the body.
  void add(BodyId body, std::size_t index, bool inner) { items_.push_back({body, index, inner}); }
  /// Marks a body as a part of the anatomy, for part_at().
  void add_part(BodyId body) { parts_.insert(body); }
  const std::vector<Item>& items() const { return items_; }

  /// Returns the point at which the ray (world frame) first meets one of the bodies for which `counts` is
  /// true; nullopt if it meets none. What the list's section removes is ignored.
  std::optional<Picked> nearest(const DrawList& list, const Ray& ray,
                                const std::function<bool(BodyId)>& counts);
  /// Returns the anatomical part that the ray (world frame) meets first; nullopt if it meets none.
  std::optional<BodyId> part_at(const DrawList& list, const Ray& ray);
  /// Returns the point at which the ray (world frame) first meets a body, ignoring the bodies of `without`;
  /// nullopt if it meets none.
  std::optional<Picked> surface_at(const DrawList& list, const Ray& ray, const std::vector<BodyId>& without);
  /// Returns a function that finds where a ray meets a body: the one given to it, or any but those of `held`.
  /// It refers to `list` and to this object.
  FindSurface finder_without(const DrawList& list, std::vector<BodyId> held);
  /// Returns the bounding box of a body as drawn, m, world frame; an empty box if the body is not drawn.
  Eigen::AlignedBox3d box_of(const DrawList& list, BodyId body) const;

 private:
  std::vector<Item> items_;
  std::set<BodyId> parts_;
  SurfaceTrees trees_;

  std::optional<SurfacePoint> meet(const DrawList& list, const Ray& ray, const DrawItem& item);
};

}  // namespace prosector
