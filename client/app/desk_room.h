#pragma once
// What the desk asks of the room that its user sees.

#include <functional>
#include <optional>

#include "client/view/pick.h"

namespace prosector {

struct DeskRoom {
  /// Returns what a ray meets first: of bodies, other than those that the user's own hand holds.
  std::function<std::optional<Picked>(const Ray&)> surface;
  /// Returns the box around a body, m, world frame.
  std::function<Eigen::AlignedBox3d(BodyId)> box;
  /// Tells whether a section opens the body; empty: any.
  std::function<bool(BodyId)> opens = {};
};

}  // namespace prosector
