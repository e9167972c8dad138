#include "client/render/line_pass.h"

#include "client/render/projection.h"

namespace prosector {
namespace {

// Brings a line that lies on a surface in front of it: about 1 mm at arm's length.
constexpr double depth_bias = 4e-5;

}  // namespace

void draw_lines(const DrawList& list, const DrawCamera& camera, const ScreenQuadDrawer& drawer) {
  const Viewport viewport{static_cast<double>(camera.width), static_cast<double>(camera.height)};
  const Eigen::Matrix4d clip_from_room = view_projection_of(camera);
  std::vector<ScreenVertex> room, overlay;
  for (const DrawLine& line : list.lines) {
    if (line.overlay) {
      const auto flat = [](const Vec3& x) { return Eigen::Vector4d(x.x(), x.y(), 0, 1); };
      add_line(overlay, flat(line.a), flat(line.b), line.color, line.width, viewport);
    } else {
      const auto project = [&](const Vec3& x) -> Eigen::Vector4d {
        Eigen::Vector4d clip = clip_from_room * x.homogeneous();
        clip.z() -= depth_bias * clip.w();
        return clip;
      };
      add_line(room, project(line.a), project(line.b), line.color, line.width, viewport);
    }
  }
  drawer.draw(room, true);
  drawer.draw(overlay, false);
}

}  // namespace prosector
