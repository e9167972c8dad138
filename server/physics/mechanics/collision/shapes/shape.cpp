#include "server/physics/mechanics/collision/shapes/shape.h"

#include <numbers>

namespace prosector::collision {
namespace {

constexpr double pi = std::numbers::pi;

Mat3 diagonal(double x, double y, double z) {
  return Vec3(x, y, z).asDiagonal();
}

MassProperties solid_mesh(const TriangleMesh& mesh, double density) {
  // Second moments of the tetrahedra between the surface and a reference vertex, which limits cancellation.
  const Vec3 reference = mesh.positions.empty() ? Vec3(Vec3::Zero()) : mesh.positions.front();
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]] - reference, b = mesh.positions[t[1]] - reference,
               c = mesh.positions[t[2]] - reference;
    const double v = a.dot(b.cross(c)) / 6;
    const Vec3 sum = a + b + c;
    volume += v;
    first += v / 4 * sum;
    second += v / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  if (!(volume > 0)) return {};
  const Vec3 center = first / volume;
  const Mat3 covariance = second - volume * center * center.transpose();
  return {density * volume, center + reference,
          density * (covariance.trace() * Mat3::Identity() - covariance)};
}

MassProperties local_mass(const ShapePart& part, double density) {
  const double r = part.half.x();
  switch (part.kind) {
    case ShapeKind::box: {
      const double m = 8 * density * part.half.prod();
      const Vec3 s = part.half.cwiseAbs2();
      return {m, Vec3::Zero(), m / 3 * diagonal(s.y() + s.z(), s.x() + s.z(), s.x() + s.y())};
    }
    case ShapeKind::sphere: {
      const double m = density * 4 / 3 * pi * r * r * r;
      return {m, Vec3::Zero(), 0.4 * m * r * r * Mat3::Identity()};
    }
    case ShapeKind::ellipsoid: {
      const double m = density * 4 / 3 * pi * part.half.prod();
      const Vec3 s = part.half.cwiseAbs2();
      return {m, Vec3::Zero(), m / 5 * diagonal(s.y() + s.z(), s.x() + s.z(), s.x() + s.y())};
    }
    case ShapeKind::cylinder: {
      const double h = 2 * part.half.y(), m = density * pi * r * r * h;
      const double side = m * (3 * r * r + h * h) / 12;
      return {m, Vec3::Zero(), diagonal(side, m * r * r / 2, side)};
    }
    case ShapeKind::capsule: {
      const double h = 2 * part.half.y();
      const double mc = density * pi * r * r * h, ms = density * 4 / 3 * pi * r * r * r;
      const double side = mc * (h * h / 12 + r * r / 4) + ms * (0.4 * r * r + h * h / 4 + 3 * h * r / 8);
      return {mc + ms, Vec3::Zero(), diagonal(side, mc * r * r / 2 + 0.4 * ms * r * r, side)};
    }
    case ShapeKind::hull:
    case ShapeKind::triangles:
      return solid_mesh(*part.mesh, density);
  }
  return {};
}

}  // namespace

MassProperties part_mass(const ShapePart& part, double density) {
  MassProperties m = local_mass(part, density);
  const Mat3 rotation = part.pose.q.toRotationMatrix();
  return {m.mass, part.pose * m.center, rotation * m.inertia * rotation.transpose()};
}

MassProperties combine(const std::vector<MassProperties>& parts) {
  MassProperties out;
  for (const MassProperties& p : parts) {
    out.mass += p.mass;
    out.center += p.mass * p.center;
  }
  if (!(out.mass > 0)) return {};
  out.center /= out.mass;
  for (const MassProperties& p : parts) {
    const Vec3 d = p.center - out.center;
    out.inertia += p.inertia + p.mass * (d.squaredNorm() * Mat3::Identity() - d * d.transpose());
  }
  return out;
}

Extent part_extent(const ShapePart& part) {
  const double r = part.half.x();
  switch (part.kind) {
    case ShapeKind::box:
    case ShapeKind::ellipsoid:
      return {Vec3::Zero(), part.half};
    case ShapeKind::sphere:
      return {Vec3::Zero(), Vec3::Constant(r)};
    case ShapeKind::capsule:
      return {Vec3::Zero(), {r, part.half.y() + r, r}};
    case ShapeKind::cylinder:
      return {Vec3::Zero(), {r, part.half.y(), r}};
    case ShapeKind::hull:
    case ShapeKind::triangles:
      break;
  }
  Vec3 lo = part.mesh->positions.front(), hi = lo;
  for (const Vec3& p : part.mesh->positions) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  return {(lo + hi) / 2, (hi - lo) / 2};
}

}  // namespace prosector::collision
