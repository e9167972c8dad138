#include "client/view/cut_lines.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr double closer = 0.004;  // m, towards the eye: pressed sides of a cut penetrate each other
const Vec3 wet_dark{0.035, 0.002, 0.002};

/// Returns the number of pixels per metre at a position.
double pixels_per_metre(const DrawCamera& camera, const Vec3& at) {
  const double depth = std::max(-(camera.pose.inverse() * at).z(), camera.near);
  return camera.height / (camera.top - camera.bottom) / depth;
}

}  // namespace

void CutLines::begin() {
  for (auto& [id, body] : bodies_) body.mesh = nullptr;
}

void CutLines::put(BodyId id, const SoftReplica& soft, const DrawMesh& mesh, const Affine& shape) {
  const auto [entry, is_new] = bodies_.try_emplace(id);
  Body& body = entry->second;
  body.mesh = &mesh;
  body.placed = shape;
  if (!is_new && body.shape == soft.shape()) return;
  body.shape = soft.shape();
  changed_ = true;
  const TriangleMesh& rest = soft.rest();
  body.rims.clear();
  body.rest.clear();
  const bool has_walls = std::ranges::find(rest.inner, std::uint8_t{1}) != rest.inner.end();
  if (soft.revision() == 0 && !has_walls) return;
  body.rims = cut_rims(rest);
  for (const CutRim& rim : body.rims) body.rest.push_back({rest.positions[rim.a], rest.positions[rim.b]});
}

/// Finds the sides of all bodies' cuts. The opposite side may belong to another piece.
void CutLines::find_sides() {
  changed_ = false;
  sides_.clear();
  std::vector<RestEdge> rest;
  for (const auto& [id, body] : bodies_)
    for (std::size_t k = 0; k < body.rims.size(); ++k) {
      sides_.push_back({&body, body.rims[k], {}});
      rest.push_back(body.rest[k]);
    }
  const auto others = other_sides(rest);
  for (std::size_t k = 0; k < sides_.size(); ++k) sides_[k].other = others[k];
}

/// Returns the position in the room of the point at a fraction of a side's edge.
Vec3 CutLines::place(const Side& side, double share) {
  const auto& positions = side.body->mesh->positions;
  const Vec3 a = positions[side.rim.a].cast<double>(), b = positions[side.rim.b].cast<double>();
  return side.body->placed * Vec3((1 - share) * a + share * b);
}

void CutLines::add(DrawList& list) {
  if (changed_) find_sides();
  const Vec3 eye = list.cameras.front().pose.p;
  for (const Side& side : sides_) {
    if (!side.other || side.body->mesh == nullptr) continue;
    const Side& other = sides_[side.other->edge];
    if (other.body->mesh == nullptr) continue;
    const Vec3 middle = place(side, 0.5), opposite = place(other, side.other->share);
    const double gap = (opposite - middle).norm() * pixels_per_metre(list.cameras.front(), middle);
    if (gap > closed_pixels) continue;
    const Vec3 a = place(side, 0), b = place(side, 1);
    const auto nearer = [&](const Vec3& x) { return Vec3(x + closer * (eye - x).normalized()); };
    list.lines.push_back({.a = nearer(a), .b = nearer(b), .color = wet_dark, .width = width});
  }
}

}  // namespace prosector
