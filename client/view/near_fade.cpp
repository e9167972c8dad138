#include "client/view/near_fade.h"

#include <algorithm>
#include <limits>

namespace prosector {
namespace {

constexpr double gone_at = 0.05;      // m ahead of the eye; more than any camera's near plane
constexpr double fade_margin = 0.09;  // m outside the view frustum: edge length of the fading items

/// Returns the distance ahead of the eye, m, of the item's nearest vertex within the view or its margin.
double nearest_in(const DrawItem& item, const DrawCamera& camera) {
  const Pose eye = camera.pose.inverse();
  double out = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3f& at : item.mesh->positions) {
    const Vec3 x = eye * (item.shape * (item.pose * at.cast<double>().eval()));
    const double ahead = -x.z(), wide = std::max(ahead, 0.0);
    if (ahead < -fade_margin || ahead >= out) continue;
    if (x.x() > camera.left * wide - fade_margin && x.x() < camera.right * wide + fade_margin &&
        x.y() > camera.bottom * wide - fade_margin && x.y() < camera.top * wide + fade_margin)
      out = ahead;
  }
  return out;
}

}  // namespace

void fade_near_eyes(DrawList& list, std::span<const std::size_t> items) {
  for (const std::size_t index : items) {
    DrawItem& item = list.items[index];
    double nearest = std::numeric_limits<double>::infinity();
    for (const DrawCamera& camera : list.cameras)
      if (!camera.inset) nearest = std::min(nearest, nearest_in(item, camera));
    item.opacity *= std::clamp((nearest - gone_at) / (near_fade_begins - gone_at), 0.0, 1.0);
  }
}

}  // namespace prosector
