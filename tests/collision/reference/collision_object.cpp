#include "tests/collision/reference/collision_object.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/error.h"

namespace prosector {
namespace {

/// By how much faster than the vertices a fitted shape's own points may move: a box's corners by √3; a
/// sphere's by its centre's √3, and its radius' 1 + √3.
double fitting_factor(Fidelity fidelity) {
  constexpr double corner = std::numbers::sqrt3;
  switch (fidelity) {
    case Fidelity::sphere:
      return 1 + 2 * corner;
    case Fidelity::aabb:
    case Fidelity::obb:
      return corner;
    default:
      return 1;
  }
}

Pose after(const Pose& pose, const Vec3& linear, const Vec3& angular, double t) {
  const double angle = t * angular.norm();
  const Quat turn = angle > 0 ? Quat(Eigen::AngleAxisd(angle, angular.normalized())) : Quat::Identity();
  return {pose.p + t * linear, (turn * pose.q).normalized()};
}

}  // namespace

CollisionObject::CollisionObject(std::shared_ptr<const collision::RigidOutline> outline)
    : outline_(std::move(outline)), part_poses_(outline_->rest_poses()) {
  place({});
}

CollisionObject::CollisionObject(const TriangleMesh& surface, Fidelity fidelity, double thickness)
    : fidelity_(fidelity),
      rounding_(thickness / 2),
      surface_(std::make_shared<collision::TriangleSurface>(surface)) {
  if (!(thickness >= 0) || !std::isfinite(thickness))
    throw InputError(
        fmt::format("collision surface: thickness {} m; it must be finite and not negative", thickness));
  fit_surface();
}

bool CollisionObject::place(const Pose& pose, const Vec3& linear, const Vec3& angular) {
  if (!is_finite(pose) || !is_finite(linear) || !is_finite(angular)) return false;
  pose_ = pose;
  linear_ = linear;
  angular_ = angular;
  outline_->place(pose_, part_poses_, pieces_);
  fit_box();
  return true;
}

bool CollisionObject::bend(std::size_t part, const Pose& pose) {
  if (!is_finite(pose)) return false;
  part_poses_[part] = pose;
  return true;
}

bool CollisionObject::move(std::span<const Vec3> positions, std::span<const Vec3> velocities) {
  if (!velocities.empty() && velocities.size() != positions.size())
    throw InputError(
        fmt::format("collision surface: {} velocities for {} vertices", velocities.size(), positions.size()));
  if (!std::all_of(velocities.begin(), velocities.end(), [](const Vec3& v) { return is_finite(v); }))
    return false;
  if (!surface_->move(positions)) return false;
  velocities_.assign(velocities.begin(), velocities.end());
  fit_surface();
  return true;
}

void CollisionObject::cut(const TriangleMesh& surface) {
  surface_ = std::make_shared<collision::TriangleSurface>(surface);
  velocities_.clear();
  fit_surface();
}

std::vector<collision::CollisionPiece> CollisionObject::surface_pieces(
    std::shared_ptr<const collision::TriangleSurface> surface, const Quat* axes) const {
  const std::array<collision::Cloud, 1> cloud{{{surface->positions(), rounding_}}};
  switch (fidelity_) {
    case Fidelity::none:
      return {};
    case Fidelity::sphere:
      return {collision::enclosing_sphere(cloud)};
    case Fidelity::aabb: {
      const collision::Aabb box = surface->box().grown(rounding_);
      return {collision::BoxShape{{box.center(), Quat::Identity()}, box.half()}};
    }
    case Fidelity::obb:
      return {axes ? collision::enclosing_box_along(*axes, cloud) : collision::enclosing_oriented_box(cloud)};
    case Fidelity::hull:
      return {collision::ConvexShape{std::make_shared<collision::SurfaceHull>(std::move(surface), rounding_),
                                     {}}};
    case Fidelity::mesh:
      return {collision::MeshShape{std::move(surface), {}, rounding_}};
  }
  return {};
}

void CollisionObject::fit_surface() {
  pieces_ = surface_pieces(surface_, nullptr);
  fit_box();
}

void CollisionObject::fit_box() {
  box_ = {};
  for (const collision::CollisionPiece& piece : pieces_) box_.add(collision::box_of(piece));
}

std::vector<collision::CollisionPiece> CollisionObject::pieces_after(double t) const {
  std::vector<collision::CollisionPiece> out;
  if (!soft()) {
    outline_->place(after(pose_, linear_, angular_, t), part_poses_, out);
    return out;
  }
  if (velocities_.empty() || t == 0) return pieces_;
  std::vector<Vec3> positions(surface_->positions().begin(), surface_->positions().end());
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] += t * velocities_[i];
  const auto moved = std::make_shared<collision::TriangleSurface>(*surface_);
  if (!moved->move(positions)) return pieces_;
  const auto* box = pieces_.empty() ? nullptr : std::get_if<collision::BoxShape>(&pieces_.front());
  return surface_pieces(moved, box ? &box->pose.q : nullptr);
}

Vec3 CollisionObject::local(const Vec3& x, double t) const {
  return soft() ? x : after(pose_, linear_, angular_, t).inverse() * x;
}

CollisionObject::Speed CollisionObject::speed() const {
  Speed out;
  if (!soft()) {
    double reach = 0;
    for (const collision::CollisionPiece& piece : pieces_) {
      const collision::Aabb box = collision::box_of(piece);
      reach = std::max(reach, (box.center() - pose_.p).norm() + box.half().norm());
    }
    // A box along the room's axes changes as it turns: its corners by √3 of what its sides do.
    const double factor = fidelity() == Fidelity::aabb ? std::numbers::sqrt3 : 1;
    return {linear_, factor * angular_.norm() * reach};
  }
  if (velocities_.empty()) return out;
  for (const Vec3& v : velocities_) out.linear += v / static_cast<double>(velocities_.size());
  for (const Vec3& v : velocities_) out.spread = std::max(out.spread, (v - out.linear).norm());
  out.spread *= fitting_factor(fidelity_);
  return out;
}

collision::Aabb CollisionObject::swept_box(double t) const {
  if (pieces_.empty()) return box_;
  const Speed s = speed();
  const Vec3 way = t * s.linear;
  collision::Aabb out = box_;
  out.add(collision::Aabb{box_.lo + way, box_.hi + way});
  return out.grown(t * s.spread);
}

}  // namespace prosector
