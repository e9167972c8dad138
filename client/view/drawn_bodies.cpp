#include "client/view/drawn_bodies.h"

#include <algorithm>
#include <utility>

#include "client/view/section.h"

namespace prosector {

void DrawnBodies::clear() {
  items_.clear();
  parts_.clear();
}

/// Returns where the ray first meets the part of the item that the section leaves.
std::optional<SurfacePoint> DrawnBodies::meet(const DrawList& list, const Ray& ray, const DrawItem& item) {
  if (!is_opened(item, list)) return trees_.meet(ray, item);
  const SectionPlane& section = *list.section;
  const double height = section.height(ray.from), sinks = -section.normal.dot(ray.along);
  if (height <= 0) {
    const auto point = trees_.meet(ray, item);
    return point && section.height(point->at) <= 0 ? point : std::nullopt;
  }
  if (sinks <= 0) return std::nullopt;
  const double way = height / sinks;
  auto point = trees_.meet({ray.from + way * ray.along, ray.along}, item);
  if (point) point->distance += way;
  return point;
}

std::optional<Picked> DrawnBodies::nearest(const DrawList& list, const Ray& ray,
                                           const std::function<bool(BodyId)>& counts) {
  std::optional<Picked> nearest;
  for (const auto& [body, index, inner] : items_) {
    if (!counts(body)) continue;
    const auto point = meet(list, ray, list.items[index]);
    if (point && (!nearest || point->distance < nearest->distance)) nearest = Picked{*point, body, inner};
  }
  return nearest;
}

std::optional<BodyId> DrawnBodies::part_at(const DrawList& list, const Ray& ray) {
  const auto found = nearest(list, ray, [&](BodyId body) { return parts_.contains(body); });
  return found ? std::optional(found->body) : std::nullopt;
}

std::optional<Picked> DrawnBodies::surface_at(const DrawList& list, const Ray& ray,
                                              const std::vector<BodyId>& without) {
  return nearest(list, ray, [&](BodyId body) { return std::ranges::find(without, body) == without.end(); });
}

FindSurface DrawnBodies::finder_without(const DrawList& list, std::vector<BodyId> held) {
  return [this, &list, held = std::move(held)](const Ray& ray, std::optional<BodyId> only) {
    return nearest(list, ray, [&](BodyId body) {
      return only ? body == *only : std::ranges::find(held, body) == held.end();
    });
  };
}

Eigen::AlignedBox3d DrawnBodies::box_of(const DrawList& list, BodyId body) const {
  Eigen::AlignedBox3d box;
  for (const auto& [id, index, inner] : items_)
    if (id == body)
      for (const auto& x : list.items[index].mesh->positions)
        box.extend(list.items[index].shape * (list.items[index].pose * x.cast<double>().eval()));
  return box;
}

}  // namespace prosector
