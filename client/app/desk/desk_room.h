#pragma once
// Queries of the displayed room that the desk needs.

#include <functional>
#include <optional>

#include "client/view/pick.h"
#include "common/ids.h"

namespace prosector {

struct DeskRoom {
  /// Returns the first body that a ray hits, except bodies held by the user's own hand.
  std::function<std::optional<Picked>(const Ray&)> surface;
  /// Returns a body's bounding box, m, world frame.
  std::function<Eigen::AlignedBox3d(BodyId)> box;
  /// Reports whether the clipping plane opens the body; empty: it opens all.
  std::function<bool(BodyId)> opens = {};
};

}  // namespace prosector
