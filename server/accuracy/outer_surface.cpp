#include "server/accuracy/outer_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "server/physics/mechanics/soft/soft_matter.h"

namespace prosector {
namespace {

constexpr int parts = 12;  // subdivisions of a face's edges

/// Returns a face's shape functions at barycentric coordinates L: of its corners, then of edges 01, 12, 20.
std::array<double, 6> shape_functions(const Vec3& L, bool quadratic) {
  if (!quadratic) return {L[0], L[1], L[2], 0, 0, 0};
  return {L[0] * (2 * L[0] - 1), L[1] * (2 * L[1] - 1), L[2] * (2 * L[2] - 1),
          4 * L[0] * L[1],       4 * L[1] * L[2],       4 * L[2] * L[0]};
}

std::array<std::uint32_t, 6> nodes_of(const OuterFace& face, const soft::SoftMatter& matter) {
  if (!matter.quadratic) return {face[0], face[1], face[2], face[0], face[0], face[0]};
  const soft::EdgeNodes& edges = matter.quadratic->edges;
  return {face[0],
          face[1],
          face[2],
          edges.find(face[0], face[1]),
          edges.find(face[1], face[2]),
          edges.find(face[2], face[0])};
}

/// Returns the centres, in barycentric coordinates, of the equal triangles into which a face is subdivided.
std::vector<Vec3> middles_of_parts() {
  constexpr double n = parts;
  std::vector<Vec3> out;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; i + j < parts; ++j) {
      out.emplace_back((i + 1. / 3) / n, (j + 1. / 3) / n, (n - i - j - 2. / 3) / n);
      if (i + j < parts - 1) out.emplace_back((i + 2. / 3) / n, (j + 2. / 3) / n, (n - i - j - 4. / 3) / n);
    }
  return out;
}

/// Returns the distance, m, at which a ray from `from` along the unit direction meets a face; infinity: it
/// does not meet it.
double distance_to(const TetMesh& mesh, const OuterFace& face, const Vec3& from, const Vec3& direction) {
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  const Vec3& a = mesh.positions[face[0]];
  const Vec3 ab = mesh.positions[face[1]] - a, ac = mesh.positions[face[2]] - a;
  const Vec3 across = direction.cross(ac), away = from - a;
  const double volume = ab.dot(across);
  if (volume == 0) return nowhere;
  const double b = away.dot(across) / volume, c = direction.dot(away.cross(ab)) / volume;
  const double distance = ac.dot(away.cross(ab)) / volume;
  return b < 0 || c < 0 || b + c > 1 || distance <= 0 ? nowhere : distance;
}

}  // namespace

std::vector<OuterFace> outer_faces(const TetMesh& mesh) {
  constexpr std::array<std::array<std::size_t, 3>, 4> outward = {
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  std::map<OuterFace, int> count;
  const auto key = [](OuterFace face) {
    std::sort(face.begin(), face.end());
    return face;
  };
  std::vector<OuterFace> all;
  for (const auto& tet : mesh.tets)
    for (const auto& [a, b, c] : outward) {
      all.push_back({tet[a], tet[b], tet[c]});
      ++count[key(all.back())];
    }
  std::erase_if(all, [&](const OuterFace& face) { return count[key(face)] > 1; });
  return all;
}

Vec3 middle(const TetMesh& mesh, const OuterFace& face) {
  return (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]) / 3;
}

Vec3 area_vector(const TetMesh& mesh, const OuterFace& face) {
  const Vec3& a = mesh.positions[face[0]];
  return (mesh.positions[face[1]] - a).cross(mesh.positions[face[2]] - a) / 2;
}

double thickness(const TetMesh& mesh, const std::vector<OuterFace>& faces) {
  double volume = 0, area = 0;
  for (const OuterFace& face : faces) {
    const Vec3 of_face = area_vector(mesh, face);
    volume += of_face.dot(middle(mesh, face)) / 3;
    area += of_face.norm();
  }
  return 4 * volume / area;
}

double depth_below(const TetMesh& mesh, const std::vector<OuterFace>& faces, const OuterFace& face) {
  const Vec3 from = middle(mesh, face), inwards = -area_vector(mesh, face).normalized();
  double depth = std::numeric_limits<double>::infinity();
  for (const OuterFace& other : faces)
    if (other != face) depth = std::min(depth, distance_to(mesh, other, from, inwards));
  return depth;
}

void for_surface_points(const StaticBody& body, const std::function<bool(const OuterFace&)>& wanted,
                        const std::function<void(const SurfacePoint&)>& f) {
  static const std::vector<Vec3> middles = middles_of_parts();
  const TetMesh& mesh = body.mesh();
  for (const OuterFace& face : outer_faces(mesh)) {
    if (!wanted(face)) continue;
    SurfacePoint point;
    point.node = nodes_of(face, body.matter());
    point.area = area_vector(mesh, face).norm() / static_cast<double>(middles.size());
    for (const Vec3& L : middles) {
      point.at =
          L[0] * mesh.positions[face[0]] + L[1] * mesh.positions[face[1]] + L[2] * mesh.positions[face[2]];
      point.shape = shape_functions(L, body.quadratic());
      f(point);
    }
  }
}

}  // namespace prosector
