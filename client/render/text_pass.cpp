#include "client/render/text_pass.h"

#include <algorithm>
#include <cmath>

#include "client/render/projection.h"
#include "client/render/stroke_font.h"
#include "client/render/text_layout.h"

namespace prosector {
namespace {

constexpr double leader_gap = 3;  // points between a text and its leader
constexpr double fade = 0.5;      // pixels beyond a stroke's border that it still covers in part

void add_strokes(std::vector<ScreenVertex>& out, const std::vector<TextStroke>& strokes,
                 const Eigen::Vector2d& origin, const Vec3& color, double width, const Viewport& viewport) {
  const auto flat = [&](const Eigen::Vector2d& pixels) {
    const Eigen::Vector2d at = origin + pixels;
    return Eigen::Vector4d(2 * at.x() / viewport.width - 1, 1 - 2 * at.y() / viewport.height, 0, 1);
  };
  for (const TextStroke& stroke : strokes)
    add_line(out, flat(stroke.a), flat(stroke.b), color, width, viewport, fade);
}

/// Returns a line from a text that was lifted down to its place.
TextStroke leader_of(const PlacedText& placed, double gap) {
  const double x = std::round(placed.size.x() / 2), y = placed.size.y() + gap;
  return {{x, y}, {x, y + placed.lift - gap}};
}

}  // namespace

void draw_texts(const DrawList& list, const DrawCamera& camera, const ScreenQuadDrawer& drawer) {
  const Viewport viewport{static_cast<double>(camera.width), static_cast<double>(camera.height)};
  const Vec3 shade = Vec3::Constant(0.01);
  std::vector<ScreenVertex> vertices;
  for (const PlacedText& placed : place_texts(list, camera)) {
    const DrawText& text = *placed.text;
    const double height = list.scale * text.height;
    std::vector<TextStroke> strokes = strokes_of(lines_of(text), height);
    if (placed.lift > 0) strokes.push_back(leader_of(placed, list.scale * leader_gap));
    const double pen = std::max(1.2, height / 9);
    add_strokes(vertices, strokes, placed.origin, shade, pen + 2, viewport);
    add_strokes(vertices, strokes, placed.origin, text.color, pen, viewport);
  }
  drawer.draw(vertices, false);
}

}  // namespace prosector
