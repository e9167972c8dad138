#include "server/physics/mechanics/contact/pad.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prosector::contact {
namespace {

constexpr double pad_modulus = 1e5;  // Pa, E/(1 − ν²): skin and fat; contact radius 4 mm under 1 N
constexpr double same_place = 3e-3;  // m: distance within which a rolling contact continues its memory

}  // namespace

double contact_radius(double pad_radius, double force) {
  return std::min(pad_radius, std::cbrt(3 * force * pad_radius / (4 * pad_modulus)));
}

std::array<Vec3, patch_points> friction_points(const Vec3& normal, const Vec3& along, double radius) {
  const Vec3 other = std::abs(normal.dot(along)) < 0.9 ? along : along.unitOrthogonal();
  const Vec3 first = (other - other.dot(normal) * normal).normalized(), second = normal.cross(first);
  std::array<Vec3, patch_points> out;
  for (std::size_t k = 0; k < patch_points; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / patch_points;
    out[k] = 2.0 / 3 * radius * (std::cos(angle) * first + std::sin(angle) * second);
  }
  return out;
}

const PadMemory* find(const std::vector<PadMemory>& memories, std::uint32_t part, std::size_t body,
                      const Vec3& place) {
  const PadMemory* nearest = nullptr;
  double distance = same_place;
  for (const PadMemory& m : memories) {
    if (m.part != part || m.body != body || (m.place - place).norm() >= distance) continue;
    nearest = &m;
    distance = (m.place - place).norm();
  }
  return nearest;
}

}  // namespace prosector::contact
