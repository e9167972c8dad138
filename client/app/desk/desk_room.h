#pragma once
// Queries of the displayed room that the desk needs.

#include <functional>
#include <optional>

#include "client/view/pick.h"
#include "common/ids.h"

namespace prosector {

struct DeskRoom {
  /// Function that returns the first point at which a ray (world frame) meets a body, ignoring bodies that
  /// the user's own hand holds.
  std::function<std::optional<Picked>(const Ray&)> surface;
  /// Function that returns the bounding box of a body as drawn, m, world frame; an empty box if it is not
  /// drawn.
  std::function<Eigen::AlignedBox3d(BodyId)> box;
  /// Function that returns whether the section plane opens the body. An empty function means that it opens
  /// all bodies.
  std::function<bool(BodyId)> opens = {};
};

}  // namespace prosector
