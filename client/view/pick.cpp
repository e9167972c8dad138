#include "client/view/pick.h"

#include <algorithm>
#include <cmath>

namespace prosector {

// Möller and Trumbore 1997.
std::optional<double> meet(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a, p = ray.along.cross(v);
  const double determinant = u.dot(p);
  if (determinant < 1e-15) return std::nullopt;
  const Vec3 s = ray.from - a, q = s.cross(u);
  const double x = s.dot(p) / determinant, y = ray.along.dot(q) / determinant;
  if (x < 0 || y < 0 || x + y > 1) return std::nullopt;
  const double distance = v.dot(q) / determinant;
  return distance > 0 ? std::optional(distance) : std::nullopt;
}

Ray ray_through(const DrawCamera& camera, double x, double y) {
  const Vec3 ahead(camera.left + (camera.right - camera.left) * x / camera.width,
                   camera.top + (camera.bottom - camera.top) * y / camera.height, -1);
  return {camera.pose.p, camera.pose.q * ahead.normalized()};
}

std::optional<PanelPoint> meet(const Ray& ray, const Panel& panel) {
  const Pose into = panel.pose.inverse();
  const Vec3 from = into * ray.from, along = into.q * ray.along;
  if (from.z() <= 0 || along.z() > -1e-6) return std::nullopt;
  PanelPoint out;
  // Caps protrude from the board, so at a slant they are hit at the height of their faces.
  for (const ControlDesc& control : panel_controls) {
    const double distance = -(from.z() - control.height) / along.z();
    const Vec3 at = from + distance * along;
    const double half = control.half_width + (control.kind == ControlKind::slider ? control.travel / 2 : 0);
    if (std::abs(at.x() - control.x) <= half && std::abs(at.y() - control.y) <= control.half_height)
      return PanelPoint{distance, at, control.control};
  }
  out.distance = -from.z() / along.z();
  out.at = from + out.distance * along;
  if (std::abs(out.at.x()) > panel_width / 2 || std::abs(out.at.y()) > panel_height / 2) return std::nullopt;
  return out;
}

double slider_position(const Vec3& at) {
  const ControlDesc& slider = describe(PanelControl::stiffness);
  return std::clamp((at.x() - slider.x) / slider.travel + 0.5, 0.0, 1.0);
}

}  // namespace prosector
