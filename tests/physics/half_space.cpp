#include "tests/physics/half_space.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/stuffing.h"

namespace prosector::test {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
constexpr double lattice_constant = 1.1547005383792515;  // 2/√3 cells
constexpr int small = 6, large = 12;                     // lattice constants across
constexpr int parts = 24;                                // per edge of a face under the load
constexpr std::array<std::array<double, 2>, 4> places = {
    {{0.0, 0.0}, {0.31, 0.17}, {-0.42, 0.23}, {0.11, -0.47}}};  // cells

/// A block of cells of size 1 with E = 1, held at its underside, with its top at y = 0.
class Block {
 public:
  Block(double across, double poisson_ratio) : height_(across / 2), nu_(poisson_ratio) {
    SolidField field;
    const Vec3 half(across / 2, height_ / 2, across / 2), middle(0, -height_ / 2, 0);
    field.box = {middle - half - Vec3::Ones(), middle + half + Vec3::Ones()};
    field.value = [=](const Vec3& x) {
      const Vec3 q = (x - middle).cwiseAbs() - half;
      const double outside = q.cwiseMax(0).norm();
      return outside > 0 ? outside : q.maxCoeff();
    };
    mesh_ = stuff(field, 1, Vec3::Zero());
    factor();
  }

  MeshYield press(double x, double z, double patch) const {
    VecX load = VecX::Zero(static_cast<Eigen::Index>(mesh_.positions.size()));
    double size = 0;
    for (const auto& face : boundary_faces(mesh_)) {
      const Vec3 &a = mesh_.positions[face[0]], &b = mesh_.positions[face[1]], &c = mesh_.positions[face[2]];
      if (std::max({std::abs(a.y()), std::abs(b.y()), std::abs(c.y())}) > 0.05) continue;  // not of the top
      const double area = (b - a).cross(c - a).norm() / 2,
                   longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
      for (int i = 0; i < parts; ++i)
        for (int j = 0; i + j < parts; ++j) {
          const double u = (i + 1. / 3) / parts, v = (j + 1. / 3) / parts;
          const Vec3 at = a + u * (b - a) + v * (c - a) - Vec3(x, 0, z);
          const double inside = 1 - at.squaredNorm() / (patch * patch);
          if (inside <= 0) continue;
          const double force = std::sqrt(inside) * area;
          load[face[0]] += (1 - u - v) * force;
          load[face[1]] += u * force;
          load[face[2]] += v * force;
          size += force * longest / std::sqrt(2.0);
        }
    }
    size /= load.sum();
    load /= load.sum();
    VecX right = VecX::Zero(free_);
    for (Eigen::Index i = 0; i < load.size(); ++i)
      if (const Eigen::Index row = rows_[static_cast<std::size_t>(i)]; row >= 0) right[row + 1] = load[i];
    const double moved = right.dot(solver_.solve(right));
    return {moved * size / (1 - nu_ * nu_), load.squaredNorm()};
  }

 private:
  void factor() {
    constexpr double held_below = 0.3;  // cells over the underside
    for (const Vec3& x : mesh_.positions) {
      rows_.push_back(x.y() < -height_ + held_below ? -1 : free_);
      if (rows_.back() >= 0) free_ += 3;
    }
    const double lambda = nu_ / ((1 + nu_) * (1 - 2 * nu_)), mu = 1 / (2 * (1 + nu_));
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& tet : mesh_.tets) {
      Mat3 edges;
      for (Eigen::Index k = 0; k < 3; ++k)
        edges.col(k) = mesh_.positions[tet[static_cast<std::size_t>(k) + 1]] - mesh_.positions[tet[0]];
      Eigen::Matrix<double, 4, 3> gradient;
      gradient.bottomRows<3>() = edges.inverse();
      gradient.row(0) = -gradient.bottomRows<3>().colwise().sum();
      const double volume = edges.determinant() / 6;
      for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < 4; ++b) {
          if (rows_[tet[a]] < 0 || rows_[tet[b]] < 0) continue;
          const auto ga = gradient.row(static_cast<Eigen::Index>(a)),
                     gb = gradient.row(static_cast<Eigen::Index>(b));
          const Mat3 stiffness = volume * (lambda * ga.transpose() * gb + mu * gb.transpose() * ga +
                                           mu * ga.dot(gb) * Mat3::Identity());
          for (Eigen::Index i = 0; i < 3; ++i)
            for (Eigen::Index j = 0; j < 3; ++j)
              entries.emplace_back(rows_[tet[a]] + i, rows_[tet[b]] + j, stiffness(i, j));
        }
    }
    Sparse matrix(free_, free_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(matrix);
  }

  double height_, nu_;
  TetMesh mesh_;
  std::vector<Eigen::Index> rows_;  // first row of each node; -1: held
  Eigen::Index free_ = 0;
  Eigen::SimplicialLDLT<Sparse> solver_;
};

}  // namespace

MeshYield yield_of_half_space(double poisson_ratio, double patch) {
  const Block near(small * lattice_constant, poisson_ratio), far(large * lattice_constant, poisson_ratio);
  MeshYield mean;
  for (const auto& [x, z] : places) {
    const MeshYield a = near.press(x, z, patch), b = far.press(x, z, patch);
    mean.displacement += (2 * b.displacement - a.displacement) / static_cast<double>(places.size());
    mean.spread += b.spread / static_cast<double>(places.size());
  }
  return mean;
}

}  // namespace prosector::test
