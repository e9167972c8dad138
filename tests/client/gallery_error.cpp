#include <cmath>

#include "client/view/contact_overlay.h"
#include "client/view/normals.h"
#include "client/view/value_paint.h"
#include "common/error_map.h"
#include "tests/client/gallery_stage.h"

namespace prosector::test {
namespace {

/// Returns a map in which the error falls off from a place: 15 % there, 0.3 % far from it.
ErrorMap map_around(const Vec3& worst, const Eigen::AlignedBox3d& box) {
  ErrorMap map{.corner = box.min(), .cell = 0.02};
  for (int axis = 0; axis < 3; ++axis)
    map.size[static_cast<std::size_t>(axis)] =
        static_cast<std::uint8_t>(2 + static_cast<int>(box.sizes()[axis] / map.cell));
  for (int z = 0; z < map.size[2]; ++z)
    for (int y = 0; y < map.size[1]; ++y)
      for (int x = 0; x < map.size[0]; ++x) {
        const double off = (map.corner + map.cell * Vec3(x, y, z) - worst).norm() / 0.035;
        map.levels.push_back(level_of(0.003 + 0.147 * std::exp(-off * off)));
      }
  return map;
}

}  // namespace

GalleryPicture error() {
  constexpr int wide = 480, high = 320;
  DrawList list = stage({0.14, 1.44, 0.74}, {0.11, 1.02, 0}, 0.6);
  list.cameras = {mono_camera(list.cameras[0].pose, 0.6, wide, high)};
  list.items.push_back(table());
  const ValueScale& scale = scale_of(Shown::error);
  const Vec3 pressed(-0.15, 1.105, 0.02);
  for (int k = 0; k < 3; ++k) {
    PartDesc ball;
    ball.shape = "ellipsoid";
    ball.size = {0.16, 0.11, 0.14};
    ball.pose.p = {-0.16 + 0.17 * k, 1.055, 0};
    DrawItem item = rigid(ball, 90 + static_cast<std::uint64_t>(k), {});
    DrawMesh mesh = *item.mesh;
    mesh.rest_positions = mesh.positions;
    Eigen::AlignedBox3d box;
    for (Eigen::Vector3f& at : mesh.positions) {
      box.extend(at.cast<double>());
      const double off = (at.cast<double>() - pressed).norm() / 0.03;
      if (k == 0) at.y() -= static_cast<float>(0.025 * std::exp(-off * off));
    }
    smooth_normals(mesh.positions, mesh.triangles, mesh.normals);
    const ErrorMap map = k == 0 ? map_around(pressed, box) : ErrorMap();
    item.mesh =
        PaintedMesh(93 + static_cast<std::uint64_t>(k)).of(mesh, scale, k == 2 ? not_known : 0.06, &map);
    item.painted = true;
    list.items.push_back(item);
  }
  add_legend(list, scale);
  return {"error", wide, high, list};
}

}  // namespace prosector::test
