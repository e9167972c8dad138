#include "server/accuracy/displacement.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/anatomy/mesh_quality.h"
#include "server/physics/mechanics/organs/locate.h"
#include "server/physics/mechanics/soft/soft_matter.h"

namespace prosector {
namespace {

/// Barycentric coordinates of a point on no face of the tetrahedron, nor of the parts into which its edge
/// midpoints divide it.
constexpr std::array<double, 4> inside = {0.41, 0.27, 0.19, 0.13};

collision::Aabb box_around(std::span<const Vec3> places) {
  collision::Aabb box;
  for (const Vec3& place : places) box.add(place);
  return box;
}

}  // namespace

std::vector<Vec3> places_in(const TetMesh& mesh, std::size_t count) {
  const auto volume = [&](const std::array<std::uint32_t, 4>& t) {
    const auto& x = mesh.positions;
    return std::abs(tet_volume(x[t[0]], x[t[1]], x[t[2]], x[t[3]]));
  };
  double whole = 0;
  for (const auto& tet : mesh.tets) whole += volume(tet);
  const double apart = whole / static_cast<double>(count);
  std::vector<Vec3> out;
  double passed = 0, next = apart / 2;  // m³
  for (const auto& tet : mesh.tets) {
    passed += volume(tet);
    if (passed < next) continue;
    while (next <= passed) next += apart;
    Vec3 place = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) place += inside[k] * mesh.positions[tet[k]];
    out.push_back(place);
  }
  return out;
}

Probes::Probes(const StaticBody& body, std::span<const Vec3> places) : body_(body) {
  const organs::Locator locator(body.mesh(), body.rest(), box_around(places));
  for (const Vec3& place : places) {
    const auto found = locator.at(place);
    std::optional<Row>& row = rows_.emplace_back();
    if (!found) continue;
    row.emplace();
    const auto& L = found->weight;
    for (std::size_t k = 0; k < 4; ++k) {
      row->node[k] = found->node[k];
      row->weight[k] = body.quadratic() ? L[k] * (2 * L[k] - 1) : L[k];
    }
    if (!body.quadratic()) continue;
    for (std::size_t k = 0; k < soft::EdgeNodes::edges_of_tet.size(); ++k) {
      const auto [a, b] = soft::EdgeNodes::edges_of_tet[k];
      row->node[4 + k] = body.matter().quadratic->edges.find(found->node[a], found->node[b]);
      row->weight[4 + k] = 4 * L[a] * L[b];
    }
  }
}

std::optional<Vec3> Probes::displacement(std::size_t k, const VecX& x) const {
  if (!rows_[k]) return std::nullopt;
  Vec3 u = Vec3::Zero();
  for (std::size_t n = 0; n < 10; ++n) {
    const auto at = 3 * static_cast<Eigen::Index>(rows_[k]->node[n]);
    u += rows_[k]->weight[n] * (x.segment<3>(at) - body_.rest().segment<3>(at));
  }
  return u;
}

double relative_difference(const Probes& a, const VecX& x_a, const Probes& b, const VecX& x_b,
                           std::size_t places) {
  double off = 0, all = 0;
  std::size_t shared = 0;
  for (std::size_t k = 0; k < places; ++k) {
    const auto u = a.displacement(k, x_a), v = b.displacement(k, x_b);
    if (!u || !v) continue;
    off += (*u - *v).squaredNorm();
    all += v->squaredNorm();
    ++shared;
  }
  if (2 * shared < places)
    throw std::logic_error(
        "less than half of the probe positions are inside both meshes of the body, so their displacements "
        "cannot be compared");
  return std::sqrt(off / all);
}

}  // namespace prosector
