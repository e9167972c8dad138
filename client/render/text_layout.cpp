#include "client/render/text_layout.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "client/render/projection.h"
#include "client/view/set_text.h"

namespace prosector {
namespace {

/// Places a text; nullopt: its point is behind the eye.
std::optional<PlacedText> place(const DrawText& text, const SetText& set, const DrawCamera& camera,
                                double scale, const Eigen::Matrix4d& clip_from_room) {
  const Eigen::Vector2d size(set.width(), set.height());
  if (text.overlay) {
    const Eigen::Vector2d at = scale * text.at.head<2>();
    return PlacedText{&text, set, text.centred ? Eigen::Vector2d(at - size / 2) : at, size};
  }
  const Eigen::Vector4d clip = clip_from_room * text.at.homogeneous();
  if (clip.w() <= 0) return std::nullopt;
  const Eigen::Vector2d at((clip.x() / clip.w() + 1) / 2 * camera.width,
                           (1 - clip.y() / clip.w()) / 2 * camera.height);
  // Rounded to whole pixels, so that a moving text keeps its appearance.
  return PlacedText{&text, set, (at - Eigen::Vector2d(size.x() / 2, size.y())).array().round(), size};
}

bool cover(const PlacedText& a, const PlacedText& b, const Eigen::Vector2d& margin) {
  const auto apart = [&](int axis) {
    return a.origin[axis] + a.size[axis] + margin[axis] <= b.origin[axis] ||
           b.origin[axis] + b.size[axis] + margin[axis] <= a.origin[axis];
  };
  return !apart(0) && !apart(1);
}

/// Moves the text up until it overlaps none of `others`. Each lift clears one of them permanently.
void lift_clear_of(const std::vector<PlacedText>& others, const Eigen::Vector2d& margin, PlacedText& text) {
  for (bool moved = true; moved;) {
    moved = false;
    for (const PlacedText& other : others) {
      if (!cover(text, other, margin)) continue;
      const double up = std::ceil(text.origin.y() + text.size.y() + margin.y() - other.origin.y());
      text.origin.y() -= up;
      text.lift += up;
      moved = true;
    }
  }
}

/// Returns the distance between texts, in whole pixels, at which their backgrounds are `text_margin` apart.
Eigen::Vector2d margin_of(double scale) {
  const Eigen::Vector2d grounds(ground_beside, ground_above);
  return (scale * (2 * grounds.array() + text_margin)).ceil();
}

}  // namespace

std::vector<PlacedText> place_texts(const DrawList& list, const DrawCamera& camera, Typesetter& typesetter) {
  const DrawCamera& first = list.cameras.empty() ? camera : list.cameras.front();
  const Eigen::Matrix4d into_first = view_projection_of(first), into_this = view_projection_of(camera);
  std::vector<PlacedText> in_first, out;
  for (const DrawText& text : list.texts) {
    if (text.surface) continue;
    const SetText set = set_text(typesetter, text, list.scale);
    auto lifted = place(text, set, first, list.scale, into_first);
    if (lifted && !text.overlay) {
      lift_clear_of(in_first, margin_of(list.scale), *lifted);
      in_first.push_back(*lifted);
    }
    auto placed = place(text, set, camera, list.scale, into_this);
    if (!placed) continue;
    if (lifted) {
      placed->lift = lifted->lift;
      placed->origin.y() -= lifted->lift;
    }
    out.push_back(*placed);
  }
  return out;
}

}  // namespace prosector
