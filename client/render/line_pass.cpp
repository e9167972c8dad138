#include "client/render/line_pass.h"

#include "client/render/projection.h"

namespace prosector {
namespace {

constexpr float faintness = 0.4f;  // opacity of the occluded parts of lines

}  // namespace

void draw_lines(const DrawList& list, const DrawCamera& camera, const ScreenQuadDrawer& drawer) {
  const Viewport viewport{static_cast<double>(camera.width), static_cast<double>(camera.height)};
  const Eigen::Matrix4d clip_from_room = view_projection_of(camera);
  std::vector<ScreenVertex> room, hidden, overlay;
  const auto project = [&](const Vec3& x) { return in_front(clip_from_room * x.homogeneous()); };
  for (const DrawLine& line : list.lines) {
    if (line.overlay) {
      const auto flat = [](const Vec3& x) { return Eigen::Vector4d(x.x(), x.y(), 0, 1); };
      add_line(overlay, flat(line.a), flat(line.b), line.color, list.scale * line.width, viewport);
    } else {
      for (auto* lines : {line.over ? &overlay : &room, line.faint_when_occluded ? &hidden : nullptr})
        if (lines != nullptr)
          add_line(*lines, project(line.a), project(line.b), line.color, list.scale * line.width, viewport);
    }
  }
  drawer.draw_hidden(hidden, faintness);
  drawer.draw(room, true);
  drawer.draw(overlay, false);
}

}  // namespace prosector
