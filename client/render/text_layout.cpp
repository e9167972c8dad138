#include "client/render/text_layout.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "client/render/projection.h"
#include "client/render/stroke_font.h"

namespace prosector {
namespace {

constexpr double text_margin = 4;  // points between two texts

Eigen::Vector2d size_of(const DrawText& text, double scale) {
  const std::string lines = lines_of(text);
  const auto more_lines = static_cast<double>(std::count(lines.begin(), lines.end(), '\n'));
  const double height = scale * text.height;
  return {text_width(lines, height), height + more_lines * line_spacing(height)};
}

/// Places a text; none where its place is behind the eye.
std::optional<PlacedText> place(const DrawText& text, const DrawCamera& camera, double scale,
                                const Eigen::Matrix4d& clip_from_room) {
  const Eigen::Vector2d size = size_of(text, scale);
  if (text.overlay) return PlacedText{&text, scale * text.at.head<2>(), size};
  const Eigen::Vector4d clip = clip_from_room * text.at.homogeneous();
  if (clip.w() <= 0) return std::nullopt;
  const Eigen::Vector2d at((clip.x() / clip.w() + 1) / 2 * camera.width,
                           (1 - clip.y() / clip.w()) / 2 * camera.height);
  // Whole pixels, so that strokes stay crisp.
  return PlacedText{&text, (at - Eigen::Vector2d(size.x() / 2, size.y())).array().round(), size};
}

bool cover(const PlacedText& a, const PlacedText& b, double margin) {
  const auto apart = [&](int axis) {
    return a.origin[axis] + a.size[axis] + margin <= b.origin[axis] ||
           b.origin[axis] + b.size[axis] + margin <= a.origin[axis];
  };
  return !apart(0) && !apart(1);
}

/// Upwards until it covers none of `others`. Each lift clears one of them for good.
void lift_clear_of(const std::vector<PlacedText>& others, double margin, PlacedText& text) {
  for (bool moved = true; moved;) {
    moved = false;
    for (const PlacedText& other : others) {
      if (!cover(text, other, margin)) continue;
      const double up = std::ceil(text.origin.y() + text.size.y() + margin - other.origin.y());
      text.origin.y() -= up;
      text.lift += up;
      moved = true;
    }
  }
}

}  // namespace

std::string lines_of(const DrawText& text) {
  return text.wrap > 0 ? wrapped(text.text, text.height, text.wrap) : text.text;
}

std::vector<PlacedText> place_texts(const DrawList& list, const DrawCamera& camera) {
  const DrawCamera& first = list.cameras.empty() ? camera : list.cameras.front();
  const Eigen::Matrix4d into_first = view_projection_of(first), into_this = view_projection_of(camera);
  std::vector<PlacedText> in_first, out;
  for (const DrawText& text : list.texts) {
    if (text.surface) continue;
    auto lifted = place(text, first, list.scale, into_first);
    if (lifted && !text.overlay) {
      lift_clear_of(in_first, std::ceil(list.scale * text_margin), *lifted);
      in_first.push_back(*lifted);
    }
    auto placed = place(text, camera, list.scale, into_this);
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
