#include "server/physics/mechanics/soft/balanced_stretch.h"

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <utility>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/elements/edge_nodes.h"
#include "server/physics/mechanics/soft/laws/polar.h"
#include "server/physics/mechanics/soft/make_model.h"
#include "server/physics/mechanics/soft/matrices/block_matrix.h"
#include "server/physics/mechanics/soft/soft_body_setup.h"
#include "server/physics/mechanics/soft/solvers/conjugate_gradient.h"

namespace prosector::soft {
namespace {

constexpr int most_rounds = 12;
constexpr double balanced = 1e-6;  // relative to the body's diagonal: displacement at which iteration stops
// Relative to the last displacement: a round that leaves more than this is the last.
constexpr double gain = 0.7;
constexpr SolverSettings effort{400, 0.02};
constexpr std::size_t tets_per_chunk = 512;

std::unique_ptr<ElasticModel> model_of(const SoftDesc& desc, const Anatomy& anatomy) {
  return name_in_errors(desc, [&] { return make_elastic_model(desc, anatomy); });
}

/// Linear elastic stiffness of a body without prestretch, in its rest shape. The matrix is singular because
/// the body is free; forces of the body's elements are in its range.
class FreeStiffness final : public LinearOperator {
 public:
  explicit FreeStiffness(std::unique_ptr<ElasticModel> model)
      : model_(std::move(model)), pattern_(model_->connectivity()), values_(pattern_.blocks()) {
    pattern_.gather(model_->warped_stiffness(model_->rest().data()), 0, {}, values_);
    for (std::size_t row = 0; row < pattern_.rows(); ++row) {
      const Mat3& D = values_[pattern_.diagonal(row)];
      inverse_.push_back(D.determinant() > 0 ? Mat3(D.inverse()) : Mat3(Mat3::Zero()));
    }
  }
  Eigen::Index size() const override { return 3 * static_cast<Eigen::Index>(pattern_.rows()); }
  void multiply(const VecX& p, VecX& Hp) const override { pattern_.multiply(values_, p.data(), Hp.data()); }
  void block_jacobi(const VecX& r, VecX& z) const override {
    for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(inverse_.size()); ++i)
      z.segment<3>(3 * i) = inverse_[static_cast<std::size_t>(i)] * r.segment<3>(3 * i);
  }
  void elastic_factor(const VecX& r, VecX& z) const override { block_jacobi(r, z); }
  void multigrid(const VecX& r, VecX& z) const override { block_jacobi(r, z); }

 private:
  std::unique_ptr<ElasticModel> model_;
  BlockPattern pattern_;
  std::vector<Mat3> values_, inverse_;
};

/// Returns the mean gradient of displacements u (3n) in a tetrahedron. `edges`: the edge nodes of quadratic
/// elements, else null.
Mat3 mean_gradient(const TetMesh& mesh, std::size_t t, const EdgeNodes* edges, const VecX& u) {
  const auto& tet = mesh.tets[t];
  const auto of = [&](std::uint32_t node) -> Vec3 { return u.segment<3>(3 * Eigen::Index{node}); };
  // D_c at the centroid of a quadratic tetrahedron (tet10.h) is the sum over the midpoints of the edges at c.
  const auto corner = [&](std::size_t c) -> Vec3 {
    if (edges == nullptr) return of(tet[c]);
    Vec3 sum = Vec3::Zero();
    for (std::size_t d = 0; d < 4; ++d)
      if (d != c) sum += of(edges->find(tet[c], tet[d]));
    return sum;
  };
  Mat3 rest, moved;
  const Vec3 first = corner(0);
  for (int a = 0; a < 3; ++a) {
    const std::size_t c = static_cast<std::size_t>(a) + 1;
    rest.col(a) = mesh.positions[tet[c]] - mesh.positions[tet[0]];
    moved.col(a) = corner(c) - first;
  }
  const double length = rest.colwise().norm().maxCoeff();
  if (!(std::abs(rest.determinant()) > 1e-4 * length * length * length)) return Mat3::Zero();
  return moved * rest.inverse();
}

/// Adds displacements to V: material that was stretched by V and then by F = I + ∇u gets its present shape as
/// rest shape. Only the symmetric factor V' of FV = V'R is stored, since the rotation R causes no stress.
void take_in(const TetMesh& mesh, const EdgeNodes* edges, const VecX& u, std::vector<Mat3>& stretch) {
  parallel_chunks(stretch.size(), tets_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t t = first; t < last; ++t) {
      const Mat3 FV = (Mat3::Identity() + mean_gradient(mesh, t, edges, u)) * stretch[t];
      const auto [R, S] = polar(FV);
      const Mat3 left = R * S * R.transpose();
      stretch[t] = 0.5 * (left + left.transpose());
    }
  });
}

}  // namespace

BalancedStretch balanced_stretch(const SoftDesc& desc, Anatomy anatomy, std::vector<Mat3> wanted) {
  const TetMesh vertices = anatomy.tets;
  std::optional<EdgeNodes> edges;
  if (desc.configuration.is_quadratic()) edges = add_edge_nodes(anatomy);
  const FreeStiffness stiffness(model_of(desc, anatomy));
  const auto solver = make_cg();
  BalancedStretch out;
  for (int round = 0; round < most_rounds; ++round) {
    anatomy.tets.stretch = std::make_shared<RestStretch>(vertices, wanted);
    const auto model = model_of(desc, anatomy);
    const VecX& rest = model->rest();
    VecX force = VecX::Zero(rest.size()), u = VecX::Zero(rest.size());
    model->add_gradient(rest.data(), force.data());
    solver->solve(stiffness, -force, effort, u);
    const double moved = u.reshaped(3, u.size() / 3).colwise().norm().maxCoeff();
    const bool last = out.stretch && moved > gain * out.moved;
    if (last) break;
    out = {std::make_shared<RestStretch>(vertices, wanted), moved};
    if (moved <= balanced * bounding_diagonal(rest)) break;
    take_in(vertices, edges ? &*edges : nullptr, u, wanted);
  }
  return out;
}

}  // namespace prosector::soft
