#include "client/render/line_pass.h"

#include <algorithm>
#include <functional>

#include "client/render/projection.h"
#include "client/render/stroke_font.h"
#include "client/render/text_layout.h"

namespace prosector {
namespace {

// Brings a line that lies on a surface in front of it: about 1 mm at arm's length.
constexpr double depth_bias = 4e-5;

using Project = std::function<Eigen::Vector4d(const Vec3&)>;

/// Strokes that lie on the surface, as wide as the writing is high, but never too thin to see.
void add_writing(std::vector<ScreenVertex>& out, const DrawText& text, const DrawCamera& camera,
                 const Viewport& viewport, const Project& project) {
  const double pixels_per_tangent = camera.height / (camera.top - camera.bottom);
  for (const TextStroke& stroke : strokes_of(lines_of(text), text.height)) {
    const auto place = [&](const Eigen::Vector2d& at) {
      return project(*text.surface * Vec3(at.x(), -at.y(), 0));
    };
    const Eigen::Vector4d a = place(stroke.a), b = place(stroke.b);
    const double pen = text.height / 9 * pixels_per_tangent / std::max(a.w(), 0.05);
    add_line(out, a, b, text.color, std::max(pen, 1.2), viewport);
  }
}

}  // namespace

void draw_lines(const DrawList& list, const DrawCamera& camera, const ScreenQuadDrawer& drawer) {
  const Viewport viewport{static_cast<double>(camera.width), static_cast<double>(camera.height)};
  const Eigen::Matrix4d clip_from_room = view_projection_of(camera);
  std::vector<ScreenVertex> room, overlay;
  const auto project = [&](const Vec3& x) -> Eigen::Vector4d {
    Eigen::Vector4d clip = clip_from_room * x.homogeneous();
    clip.z() -= depth_bias * clip.w();
    return clip;
  };
  for (const DrawLine& line : list.lines) {
    if (line.overlay) {
      const auto flat = [](const Vec3& x) { return Eigen::Vector4d(x.x(), x.y(), 0, 1); };
      add_line(overlay, flat(line.a), flat(line.b), line.color, list.scale * line.width, viewport);
    } else {
      add_line(room, project(line.a), project(line.b), line.color, list.scale * line.width, viewport);
    }
  }
  for (const DrawText& text : list.texts)
    if (text.surface) add_writing(room, text, camera, viewport, project);
  drawer.draw(room, true);
  drawer.draw(overlay, false);
}

}  // namespace prosector
