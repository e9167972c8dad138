#include "client/render/text_pass.h"

#include <algorithm>
#include <optional>

#include "client/render/projection.h"
#include "client/render/stroke_font.h"

namespace prosector {
namespace {

constexpr double fade = 0.5;  // pixels beyond a stroke's border that it still covers in part

/// Top left of the text's first line in pixels from the viewport's top left; none behind the eye.
std::optional<Eigen::Vector2d> origin_of(const DrawText& text, const Eigen::Matrix4d& clip_from_room,
                                         const Viewport& viewport) {
  if (text.overlay) return Eigen::Vector2d(text.at.x(), text.at.y());
  const Eigen::Vector4d clip = clip_from_room * text.at.homogeneous();
  if (clip.w() <= 0) return std::nullopt;
  const Eigen::Vector2d center((clip.x() / clip.w() + 1) / 2 * viewport.width,
                               (1 - clip.y() / clip.w()) / 2 * viewport.height);
  const auto more_lines = static_cast<double>(std::count(text.text.begin(), text.text.end(), '\n'));
  const Eigen::Vector2d size(text_width(text.text, text.height),
                             text.height + more_lines * line_spacing(text.height));
  // Whole pixels, so that strokes stay crisp; the text stands above its place.
  return Eigen::Vector2d((center - Eigen::Vector2d(size.x() / 2, size.y())).array().round());
}

void add_strokes(std::vector<ScreenVertex>& out, const std::vector<TextStroke>& strokes,
                 const Eigen::Vector2d& origin, const Vec3& color, double width, const Viewport& viewport) {
  const auto flat = [&](const Eigen::Vector2d& pixels) {
    const Eigen::Vector2d at = origin + pixels;
    return Eigen::Vector4d(2 * at.x() / viewport.width - 1, 1 - 2 * at.y() / viewport.height, 0, 1);
  };
  for (const TextStroke& stroke : strokes)
    add_line(out, flat(stroke.a), flat(stroke.b), color, width, viewport, fade);
}

}  // namespace

void draw_texts(const DrawList& list, const DrawCamera& camera, const ScreenQuadDrawer& drawer) {
  const Viewport viewport{static_cast<double>(camera.width), static_cast<double>(camera.height)};
  const Eigen::Matrix4d clip_from_room = view_projection_of(camera);
  const Vec3 shade = Vec3::Constant(0.01);
  std::vector<ScreenVertex> vertices;
  for (const DrawText& text : list.texts) {
    const auto origin = origin_of(text, clip_from_room, viewport);
    if (!origin) continue;
    const std::vector<TextStroke> strokes = strokes_of(text.text, text.height);
    const double pen = std::max(1.2, text.height / 9);
    add_strokes(vertices, strokes, *origin, shade, pen + 2, viewport);
    add_strokes(vertices, strokes, *origin, text.color, pen, viewport);
  }
  drawer.draw(vertices, false);
}

}  // namespace prosector
