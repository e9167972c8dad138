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
constexpr double least_angle = 17, most_angle = 147;  // degrees
constexpr int halvings = 5;                           // of motions that would spoil angles

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

/// Boundary of a mesh.
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

  /// Returns the motion (m) of each boundary node that fits the faces to the surface. A face's distance
  /// counts along its normal. So nodes near a sharp edge move along the flat faces towards it.
  std::vector<Vec3> motions(const SolidField& field, double cell, const TetMesh& mesh) const {
    const auto size = static_cast<Eigen::Index>(3 * nodes_.size());
    std::vector<Eigen::Triplet<double>> entries;
    VecX load = VecX::Zero(size);
    for (const Face& face : faces_) {
      const Vec3 &a = mesh.positions[face[0]], &b = mesh.positions[face[1]], &c = mesh.positions[face[2]];
      const Vec3 twice = (b - a).cross(c - a), normal = twice.normalized();
      const double area = twice.norm() / 2;
      Mat3 product = Mat3::Zero();  // of weights, mean over the face
      Vec3 pull = Vec3::Zero();     // m
      for_parts([&](const Vec3& w) {
        const std::optional<double> d = distance_along(field, w[0] * a + w[1] * b + w[2] * c, normal, cell);
        if (!d) return;
        product += w * w.transpose() / (parts * parts);
        pull += w * *d / (parts * parts);
      });
      const Mat3 along = area * normal * normal.transpose(), any = area * steady / 3 * Mat3::Identity();
      for (Eigen::Index i = 0; i < 3; ++i) {
        const Eigen::Index row = first_row(face, i);
        load.segment<3>(row) += area * pull[i] * normal;
        for (Eigen::Index j = 0; j < 3; ++j)
          add_block(product(i, j) * along + (i == j ? any : Mat3(Mat3::Zero())), row, first_row(face, j),
                    entries);
      }
    }
    Sparse matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const VecX solved = Eigen::SimplicialLDLT<Sparse>(matrix).solve(load);
    std::vector<Vec3> out(nodes_.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = solved.segment<3>(static_cast<Eigen::Index>(3 * i));
      out[i] *= std::min(1.0, most_distance * cell / std::max(out[i].norm(), most_distance * cell));
    }
    return out;
  }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;

  Eigen::Index first_row(const Face& face, Eigen::Index corner) const {
    return 3 * static_cast<Eigen::Index>(number_[face[static_cast<std::size_t>(corner)]]);
  }

  static void add_block(const Mat3& block, Eigen::Index row, Eigen::Index column,
                        std::vector<Eigen::Triplet<double>>& entries) {
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j < 3; ++j) entries.emplace_back(row + i, column + j, block(i, j));
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
