// Batches of elements against the laws element by element.

#include <gtest/gtest.h>

#include <hwy/targets.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/base/find_row.h"
#include "server/physics/mechanics/soft/elements/element_batches.h"
#include "server/physics/mechanics/soft/elements/element_blocks.h"
#include "server/physics/mechanics/soft/laws/fem_laws.h"

namespace prosector {
namespace {

/// Tetrahedra that share no node, so that each can be given any F.
TetMesh scattered(std::size_t count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  TetMesh mesh;
  while (mesh.tets.size() < count) {
    const Mat3 D = Mat3::NullaryExpr([&] { return uniform(random); });
    if (std::abs(D.determinant()) < 0.1) continue;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(Vec3::Zero());
    for (int a = 0; a < 3; ++a) mesh.positions.emplace_back(D.col(a));
    mesh.tets.push_back({first, first + 1, first + 2, first + 3});
  }
  return mesh;
}

/// Near rest, turned, torn, mirrored, flat, a line, a point, far too large and far too small in turn.
Mat3 any_gradient(std::size_t e, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Mat3 noise = Mat3::NullaryExpr([&] { return uniform(random); });
  const Mat3 turned = Eigen::AngleAxisd(3 * uniform(random), noise.col(0).normalized()).toRotationMatrix();
  switch (e % 9) {
    case 0:
      return turned * (Mat3::Identity() + 1e-9 * noise);
    case 1:
      return turned * (Mat3::Identity() + 0.3 * noise);
    case 2:
      return noise;
    case 3:
      return turned * Vec3(-1, 1 + 0.1 * uniform(random), 1).asDiagonal();
    case 4:
      return noise * Vec3(1, 0, 1).asDiagonal();
    case 5:
      return noise * Vec3(1, 0, 0).asDiagonal();
    case 6:
      return e % 2 ? Mat3::Zero() : Mat3(-Mat3::Identity());
    case 7:
      return 1e6 * noise;
    default:
      return 1e-6 * noise;
  }
}

struct Everything {
  std::vector<double> energy;  // of each batch
  std::vector<soft::Tet4Elements::Forces> forces;
  std::vector<soft::Tet4Elements::Stiffness> stiffness, warped;
  std::vector<double> theta;
  std::vector<soft::Tet4Elements::Forces> dilating;
};

Everything everything(soft::ElementBatches& batches, std::size_t elements, const VecX& x) {
  Everything all{{},
                 std::vector<soft::Tet4Elements::Forces>(elements),
                 std::vector<soft::Tet4Elements::Stiffness>(elements),
                 std::vector<soft::Tet4Elements::Stiffness>(elements),
                 std::vector<double>(elements),
                 std::vector<soft::Tet4Elements::Forces>(elements)};
  for (std::size_t batch = 0; batch < chunk_count(elements, soft::elements_per_batch); ++batch) {
    const std::size_t first = batch * soft::elements_per_batch,
                      n = std::min(soft::elements_per_batch, elements - first);
    batches.move(batch, x.data());
    batches.set_pressures(batch, std::vector<double>(n, 0.7));
    all.energy.push_back(batches.energy(batch));
    batches.forces(batch, std::span(all.forces).subspan(first, n));
    batches.stiffness(batch, std::span(all.stiffness).subspan(first, n));
    batches.warped_stiffness(batch, std::span(all.warped).subspan(first, n));
    batches.dilatations(batch, std::span(all.theta).subspan(first, n));
    batches.dilatation_forces(batch, std::span(all.dilating).subspan(first, n));
  }
  return all;
}

template <std::size_t n, class A>
double largest(const std::array<A, n>& a) {
  double most = 0;
  for (const A& block : a) most = std::max(most, block.cwiseAbs().maxCoeff());
  return most;
}
template <std::size_t n, class A>
double difference(const std::array<A, n>& a, const std::array<A, n>& b) {
  double most = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!a[i].allFinite() || !b[i].allFinite()) return INFINITY;
    most = std::max(most, (a[i] - b[i]).cwiseAbs().maxCoeff());
  }
  return most;
}

std::vector<std::string> batched_law_names() {
  std::vector<std::string> names;
  for (const soft::BatchedLawRow& row : soft::batched_laws()) names.emplace_back(row.law);
  return names;
}

class BatchedLaws : public testing::TestWithParam<std::string> {
 protected:
  static constexpr std::size_t count = 9 * 37;
  BatchedLaws()
      : mesh_(scattered(count, random_)), elements_(mesh_), x_(12 * count), materials_(soft::lame(3, 0.45)) {
    materials_.kinds.push_back(soft::lame(70, 0.1));
    if (GetParam() == "fem_fibers") {
      materials_.kinds[0].fiber_stiffness = 20;
      materials_.kinds[1].fiber_stiffness = 5;
      materials_.kinds[1].fiber = Vec3(1, -2, 0.5).normalized();
    }
    for (std::size_t e = 0; e < count; ++e) {
      const Mat3 F = any_gradient(e, random_);
      for (std::uint32_t node : mesh_.tets[e]) x_.segment<3>(3 * node) = F * mesh_.positions[node];
      materials_.kind.push_back(e % 5 == 2);
    }
  }

  std::unique_ptr<soft::ElementBatches> fast() const {
    return soft::make_batches(GetParam(), materials_, elements_);
  }
  /// The same law, element by element.
  std::unique_ptr<soft::ElementBatches> plain() const {
    return soft::make_law_batches(soft::find_row(soft::laws(), "model", GetParam()).make, materials_,
                                  elements_);
  }

  std::mt19937_64 random_{11};
  TetMesh mesh_;
  soft::Tet4Elements elements_;
  VecX x_;
  soft::Materials materials_;
};

INSTANTIATE_TEST_SUITE_P(Table, BatchedLaws, testing::ValuesIn(batched_law_names()),
                         [](const auto& law) { return law.param; });

TEST_P(BatchedLaws, AreTheLaw) {
  ASSERT_EQ(elements_.size(), count);
  const Everything a = everything(*fast(), count, x_), b = everything(*plain(), count, x_);
  for (std::size_t batch = 0; batch < a.energy.size(); ++batch) {
    EXPECT_NEAR(a.energy[batch], b.energy[batch], 1e-12 * std::abs(b.energy[batch]));
  }
  for (std::size_t e = 0; e < count; ++e) {
    EXPECT_LE(difference(a.forces[e], b.forces[e]), 1e-10 * (1 + largest(b.forces[e]))) << e;
    EXPECT_LE(difference(a.stiffness[e], b.stiffness[e]), 1e-6 * (1 + largest(b.stiffness[e]))) << e;
    EXPECT_EQ(a.warped[e], b.warped[e]) << e;
    EXPECT_NEAR(a.theta[e], b.theta[e], 1e-12 * (1 + std::abs(b.theta[e]))) << e;
    EXPECT_LE(difference(a.dilating[e], b.dilating[e]), 1e-10 * (1 + largest(b.dilating[e]))) << e;
  }
}

TEST_P(BatchedLaws, HaveTheirStiffnessInSinglePrecision) {
  const auto batches = fast(), law = plain();
  if (!batches->has_point_tangents()) return;  // corotational: test_turned.cpp
  for (const double share : {1.0, 0.3}) {
    const Everything b = everything(*law, count, x_);
    (void)everything(*batches, count, x_);
    for (std::size_t batch = 0; batch < b.energy.size(); ++batch) {
      const std::size_t first = batch * soft::elements_per_batch,
                        n = std::min(soft::elements_per_batch, count - first);
      soft::PointTangents points;
      batches->point_tangents(batch, share, points);
      std::vector<float> blocks(soft::floats_per_tet4 * n);
      soft::lane_tet4_blocks(points, blocks);
      for (std::size_t e = 0; e < n; ++e) {
        soft::Tet4Elements::Stiffness a, mixed;
        for (std::size_t k = 0; k < a.size(); ++k) {
          a[k] = Eigen::Map<const Eigen::Matrix3f>(&blocks[soft::floats_per_tet4 * e + 9 * k]).cast<double>();
          mixed[k] = share * b.stiffness[first + e][k] + (1 - share) * b.warped[first + e][k];
        }
        EXPECT_LE(difference(a, mixed), 1e-5 * (1 + largest(mixed))) << first + e << ", share " << share;
      }
    }
  }
}

TEST_P(BatchedLaws, GiveTheSameBitsForEveryInstructionSet) {
  const auto batches = fast();
  const Everything reference = everything(*batches, count, x_);
  const std::int64_t targets = hwy::SupportedTargets();
  for (std::int64_t rest = targets; rest != 0; rest &= rest - 1) {
    hwy::SetSupportedTargetsForTest(rest & -rest);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    const Everything other = everything(*batches, count, x_);
    EXPECT_EQ(other.energy, reference.energy) << hwy::TargetName(rest & -rest);
    EXPECT_EQ(other.forces, reference.forces);
    EXPECT_EQ(other.stiffness, reference.stiffness);
    EXPECT_EQ(other.warped, reference.warped);
    EXPECT_EQ(other.theta, reference.theta);
    EXPECT_EQ(other.dilating, reference.dilating);
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace
}  // namespace prosector
