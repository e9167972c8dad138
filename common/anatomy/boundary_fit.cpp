#include "common/anatomy/boundary_fit.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "common/anatomy/mesh_quality.h"

namespace prosector {
namespace {

constexpr int rounds = 4;
constexpr int parts = 4;               // per edge of a face, in whose parts distances are measured
constexpr double step = 1e-3;          // of a cell, for derivatives
constexpr double most_distance = 0.5;  // cells: farther, the surface counts as this far
constexpr double steady = 1e-2;        // weight of a node's own motion, relative to that of the distance
constexpr double least_angle = 10.7, most_angle = 160;  // degrees
constexpr int halvings = 5;                             // of motions that would spoil angles

using Face = std::array<std::uint32_t, 3>;
using Sparse = Eigen::SparseMatrix<double>;

/// Returns the signed distance (m) from x to the surface along the unit vector `along`; none where the field
/// hardly changes.
std::optional<double> distance_along(const SolidField& field, const Vec3& x, const Vec3& along, double cell) {
  const double value = field.value(x), h = step * cell;
  const double slope = (field.value(x + h * along) - field.value(x - h * along)) / (2 * h);
  const double most = most_distance * cell;
  if (!(slope * most > std::abs(value) / 4)) return std::nullopt;
  return std::clamp(-value / slope, -most, most);
}

/// Calls f(weights) at the centroid of each part of a divided triangle.
template <class F>
void for_parts(const F& f) {
  for (int i = 0; i < parts; ++i)
    for (int j = 0; i + j < parts; ++j)
      for (const double third : {1.0 / 3, 2.0 / 3}) {
        const double u = (i + third) / parts, v = (j + third) / parts;
        if (u + v < 1) f(Vec3(1 - u - v, u, v));
      }
}

/// Boundary of a mesh, with a normal for each boundary node.
class Boundary {
 public:
  explicit Boundary(const TetMesh& mesh)
      : faces_(boundary_faces(mesh)), number_(mesh.positions.size(), none) {
    for (const Face& face : faces_)
      for (const std::uint32_t node : face) {
        if (number_[node] != none) continue;
        number_[node] = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back(node);
      }
  }

  const std::vector<std::uint32_t>& nodes() const { return nodes_; }

  /// Returns the motion (m) of each boundary node that fits the faces to the surface.
  std::vector<Vec3> motions(const SolidField& field, double cell, const TetMesh& mesh) const {
    const std::vector<Vec3> normals = node_normals(mesh);
    const auto n = static_cast<Eigen::Index>(nodes_.size());
    std::vector<Eigen::Triplet<double>> entries;
    VecX load = VecX::Zero(n);
    for (const Face& face : faces_) {
      const Vec3 &a = mesh.positions[face[0]], &b = mesh.positions[face[1]], &c = mesh.positions[face[2]];
      const Vec3 twice = (b - a).cross(c - a);
      const Vec3 normal = twice.normalized();
      const double area = twice.norm() / (2 * parts * parts);
      Vec3 facing;  // motion of the face along its normal, per motion of each corner
      for (std::size_t k = 0; k < 3; ++k)
        facing[static_cast<Eigen::Index>(k)] = normals[number_[face[k]]].dot(normal);
      Mat3 product = area * parts * parts * steady / 3 * Mat3::Identity();
      Vec3 pull = Vec3::Zero();
      for_parts([&](const Vec3& w) {
        const std::optional<double> d = distance_along(field, w[0] * a + w[1] * b + w[2] * c, normal, cell);
        if (!d) return;
        const Vec3 moves = w.cwiseProduct(facing);
        product += area * moves * moves.transpose();
        pull += area * *d * moves;
      });
      for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Eigen::Index>(number_[face[i]]);
        load[row] += pull[static_cast<Eigen::Index>(i)];
        for (std::size_t j = 0; j < 3; ++j)
          entries.emplace_back(row, static_cast<Eigen::Index>(number_[face[j]]),
                               product(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      }
    }
    Sparse matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const VecX along = Eigen::SimplicialLDLT<Sparse>(matrix).solve(load);
    std::vector<Vec3> out(nodes_.size());
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = std::clamp(along[static_cast<Eigen::Index>(i)], -most_distance * cell, most_distance * cell) *
               normals[i];
    return out;
  }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;

  /// Returns the mean of the adjacent faces' normals, weighted by area, unit.
  std::vector<Vec3> node_normals(const TetMesh& mesh) const {
    std::vector<Vec3> out(nodes_.size(), Vec3::Zero());
    for (const Face& face : faces_) {
      const Vec3 &a = mesh.positions[face[0]], &b = mesh.positions[face[1]], &c = mesh.positions[face[2]];
      for (const std::uint32_t node : face) out[number_[node]] += (b - a).cross(c - a);
    }
    for (Vec3& normal : out) normal.normalize();
    return out;
  }

  std::vector<Face> faces_;
  std::vector<std::uint32_t> number_, nodes_;  // of each node among the boundary's; node of each number
};

/// Returns the positions of a tetrahedron's nodes.
std::array<Vec3, 4> corners(const std::vector<Vec3>& positions, const std::array<std::uint32_t, 4>& tet) {
  return {positions[tet[0]], positions[tet[1]], positions[tet[2]], positions[tet[3]]};
}

/// Returns whether a tetrahedron may take another shape: not inverted, and no dihedral angle spoiled.
bool may_become(const std::array<Vec3, 4>& before, const std::array<Vec3, 4>& after) {
  if (!(tet_volume(after[0], after[1], after[2], after[3]) > 0)) return false;
  const DihedralRange had = dihedral_range(before), has = dihedral_range(after);
  return has.least_deg >= std::min(had.least_deg, least_angle) &&
         has.most_deg <= std::max(had.most_deg, most_angle);
}

/// Moves the nodes, each by as much of its motion as the angles of its tetrahedra allow.
void move(const Boundary& boundary, std::vector<Vec3> motions, TetMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> moved_by(mesh.tets.size());  // numbers of boundary nodes
  std::vector<std::uint32_t> number(mesh.positions.size(), UINT32_MAX);
  for (std::uint32_t i = 0; i < boundary.nodes().size(); ++i) number[boundary.nodes()[i]] = i;
  std::vector<std::uint32_t> touched;
  for (std::uint32_t t = 0; t < mesh.tets.size(); ++t) {
    for (const std::uint32_t node : mesh.tets[t])
      if (number[node] != UINT32_MAX) moved_by[t].push_back(number[node]);
    if (!moved_by[t].empty()) touched.push_back(t);
  }
  std::vector<Vec3> to = mesh.positions;
  for (int tries = 0;; ++tries) {
    for (std::uint32_t i = 0; i < motions.size(); ++i)
      to[boundary.nodes()[i]] = mesh.positions[boundary.nodes()[i]] + motions[i];
    std::vector<bool> spoils(motions.size(), false);
    bool any = false;
    for (const std::uint32_t t : touched) {
      if (may_become(corners(mesh.positions, mesh.tets[t]), corners(to, mesh.tets[t]))) continue;
      any = true;
      for (const std::uint32_t i : moved_by[t]) spoils[i] = true;
    }
    if (!any) {
      mesh.positions = std::move(to);
      return;
    }
    for (std::size_t i = 0; i < motions.size(); ++i)
      if (spoils[i]) motions[i] *= tries < halvings ? 0.5 : 0;
  }
}

}  // namespace

void fit_boundary(const SolidField& field, double cell, TetMesh& mesh) {
  const Boundary boundary(mesh);
  for (int round = 0; round < rounds; ++round) move(boundary, boundary.motions(field, cell, mesh), mesh);
}

}  // namespace prosector
