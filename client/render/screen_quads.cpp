#include "client/render/screen_quads.h"

namespace prosector {
namespace {

/// Clips off the part with z < −w (in front of the near plane); returns false if nothing is left.
bool clip_near(Eigen::Vector4d& a, Eigen::Vector4d& b) {
  const double da = a.z() + a.w(), db = b.z() + b.w();
  if (da <= 0 && db <= 0) return false;
  if (da < 0) a += (b - a) * (da / (da - db));
  if (db < 0) b += (a - b) * (db / (db - da));
  return a.w() > 0 && b.w() > 0;
}

}  // namespace

void add_line(std::vector<ScreenVertex>& out, Eigen::Vector4d a, Eigen::Vector4d b, const Vec3& color,
              double width, const Viewport& viewport) {
  if (!clip_near(a, b)) return;
  const Vec3 p = a.head<3>() / a.w(), q = b.head<3>() / b.w();
  const Eigen::Vector2d half_size(viewport.width / 2, viewport.height / 2);
  Eigen::Vector2d along = (q - p).head<2>().cwiseProduct(half_size);
  const double length = along.norm(), reach = width / 2;
  along = length > 1e-9 ? Eigen::Vector2d(along / length) : Eigen::Vector2d::UnitX();
  const Eigen::Vector2d across(-along.y(), along.x());
  const auto corner = [&](const Vec3& end, double forward, double sideways) {
    const Eigen::Vector2d shift = (forward * along + sideways * across).cwiseQuotient(half_size) * reach;
    return ScreenVertex{{static_cast<float>(end.x() + shift.x()), static_cast<float>(end.y() + shift.y()),
                         static_cast<float>(end.z())},
                        color.cast<float>()};
  };
  const ScreenVertex corners[] = {corner(p, -1, -1), corner(q, 1, -1), corner(q, 1, 1), corner(p, -1, 1)};
  for (const int k : {0, 1, 2, 0, 2, 3}) out.push_back(corners[k]);
}

}  // namespace prosector
