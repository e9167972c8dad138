#include "server/physics/mechanics/contact/proxy_shape.h"

#include <numeric>

#include "server/physics/mechanics/soft/laws/polar.h"

namespace prosector::contact {
namespace {

Vec3 mean(std::span<const Vec3> points) {
  return std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero())) /
         static_cast<double>(points.size());
}

}  // namespace

ProxyShape::ProxyShape(const Anatomy& anatomy, Fidelity fidelity)
    : fidelity_(fidelity), rounding_(anatomy.thickness / 2), shape_matching_(anatomy) {
  const std::vector<Vec3>& rest = anatomy.surface.positions;
  if (fidelity == Fidelity::hull) surface_ = std::make_shared<collision::TriangleSurface>(anatomy.surface);
  const Vec3 middle = mean(rest);
  for (const Vec3& x : rest) rest_.push_back(x - middle);
  const std::array<collision::Cloud, 1> cloud{{{rest, rounding_}}};
  if (fidelity == Fidelity::obb) rest_axes_ = collision::enclosing_oriented_box(cloud).pose.q;
}

/// Returns the axes of the box at rest, rotated by the best-fit rotation of the vertices.
Quat ProxyShape::rotated_axes(std::span<const Vec3> surface) const {
  Mat3 moved = Mat3::Zero();
  for (std::size_t i = 0; i < rest_.size(); ++i) moved += surface[i] * rest_[i].transpose();
  return (Quat(soft::polar(moved).R) * rest_axes_).normalized();
}

void ProxyShape::fit(const VecX& x, std::span<const Vec3> surface) {
  shape_matching_.fit(x);
  const std::array<collision::Cloud, 1> cloud{{{surface, rounding_}}};
  if (fidelity_ == Fidelity::hull) {
    surface_->move(surface);
    piece_ = collision::ConvexShape{std::make_shared<collision::SurfaceHull>(surface_, rounding_), {}};
  } else {
    const collision::BoxShape box = collision::enclosing_box_along(rotated_axes(surface), cloud);
    piece_ = box;
    if (fidelity_ == Fidelity::sphere) piece_ = collision::enclosing_sphere_about(box.pose.p, cloud);
  }
  box_ = collision::box_of(piece_);
}

}  // namespace prosector::contact
