#include "server/physics/stations/compile/tension.h"

#include <algorithm>
#include <array>
#include <optional>

#include "common/anatomy/mesh_quality.h"
#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/collision/surface/triangle_surface.h"
#include "server/physics/mechanics/soft/balanced_stretch.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/mechanics/soft/soft_body_setup.h"

namespace prosector {
namespace {

using Corners = std::array<Vec3, 4>;

constexpr std::size_t tets_per_chunk = 64;
constexpr double apart = 1e-6;  // of a tetrahedron's range of values: least difference between corner values

/// Returns eight parts of equal volume: one at each corner, and four of the octahedron between them.
std::array<Corners, 8> eighths(const Corners& x) {
  const auto middle = [&](std::size_t a, std::size_t b) -> Vec3 { return (x[a] + x[b]) / 2; };
  const Vec3 m01 = middle(0, 1), m02 = middle(0, 2), m03 = middle(0, 3), m12 = middle(1, 2),
             m13 = middle(1, 3), m23 = middle(2, 3);
  return {{{x[0], m01, m02, m03},
           {m01, x[1], m12, m13},
           {m02, m12, x[2], m23},
           {m03, m13, m23, x[3]},
           {m01, m23, m02, m03},
           {m01, m23, m03, m13},
           {m01, m23, m13, m12},
           {m01, m23, m12, m02}}};
}

/// Returns the fraction of a tetrahedron in which the linear function with these corner values is below
/// `limit`: one minus the divided difference of the truncated cube.
double share_below(std::array<double, 4> value, double limit) {
  std::sort(value.begin(), value.end());
  if (limit >= value[3]) return 1;
  if (limit <= value[0]) return 0;
  const double least = apart * (value[3] - value[0]);
  for (std::size_t i = 1; i < 4; ++i) value[i] = std::max(value[i], value[i - 1] + least);
  double above = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (value[i] <= limit) continue;
    double term = 1;
    for (std::size_t j = 0; j < 4; ++j)
      if (j != i) term *= (value[i] - limit) / (value[i] - value[j]);
    above += term;
  }
  return std::clamp(1 - above, 0.0, 1.0);
}

/// Adds the fraction of a part that lies in the layer, along the nearest face of the surface.
void add_layer(const collision::TriangleSurface& surface, const Corners& x, double depth, Mat3& sum) {
  const Vec3 middle = (x[0] + x[1] + x[2] + x[3]) / 4;
  double reach = depth;
  for (const Vec3& corner : x) reach = std::max(reach, depth + (corner - middle).norm());
  const std::optional<collision::NearestPoint> nearest = surface.nearest(middle, reach);
  if (!nearest) return;
  const collision::Triangle face = surface.triangle(nearest->triangle);
  const Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
  std::array<double, 4> deep{};
  for (std::size_t c = 0; c < 4; ++c) deep[c] = normal.dot(face[0] - x[c]);
  sum += share_below(deep, depth) / 8 * (Mat3::Identity() - normal * normal.transpose());
}

}  // namespace

std::vector<Mat3> layer_stretch(const TetMesh& mesh, double strain, double depth) {
  const collision::TriangleSurface surface(TriangleMesh{mesh.positions, boundary_faces(mesh)});
  const double stretch = strain / (1 - strain);
  std::vector<Mat3> out(mesh.tets.size());
  parallel_chunks(out.size(), tets_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t t = first; t < last; ++t) {
      Corners x;
      for (std::size_t c = 0; c < 4; ++c) x[c] = mesh.positions[mesh.tets[t][c]];
      Mat3 layer = Mat3::Zero();
      for (const Corners& part : eighths(x)) add_layer(surface, part, depth, layer);
      out[t] = Mat3::Identity() + stretch * layer;
    }
  });
  return out;
}

double put_under_tension(const SoftDesc& desc, Anatomy& anatomy) {
  if (!desc.material.tension || soft::mesh_kind(anatomy) == soft::MeshKind::sheet) return 0;
  soft::require(
      soft::mesh_kind(anatomy) == soft::MeshKind::tets, desc,
      "tension is given for a rope, which has no outermost layer; allowed only for solid bodies and sheets");
  soft::BalancedStretch found = soft::balanced_stretch(
      desc, anatomy,
      layer_stretch(anatomy.tets, desc.material.tension.value / 100, desc.material.tension_depth));
  anatomy.tets.stretch = std::move(found.stretch);
  return found.moved;
}

}  // namespace prosector
