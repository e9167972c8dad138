// Batches of elements against the laws element by element.

#include <gtest/gtest.h>

#include <hwy/targets.h>

#include <cmath>
#include <random>
#include <vector>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/elements/element_batches.h"
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
};

Everything everything(soft::ElementBatches& batches, std::size_t elements, const VecX& x) {
  Everything all{{},
                 std::vector<soft::Tet4Elements::Forces>(elements),
                 std::vector<soft::Tet4Elements::Stiffness>(elements),
                 std::vector<soft::Tet4Elements::Stiffness>(elements)};
  for (std::size_t batch = 0; batch < chunk_count(elements, soft::elements_per_batch); ++batch) {
    const std::size_t first = batch * soft::elements_per_batch,
                      n = std::min(soft::elements_per_batch, elements - first);
    batches.move(batch, x.data());
    all.energy.push_back(batches.energy(batch));
    batches.forces(batch, std::span(all.forces).subspan(first, n));
    batches.stiffness(batch, std::span(all.stiffness).subspan(first, n));
    batches.warped_stiffness(batch, std::span(all.warped).subspan(first, n));
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

class CorotationalBatches : public testing::Test {
 protected:
  static constexpr std::size_t count = 9 * 37;
  CorotationalBatches()
      : mesh_(scattered(count, random_)), elements_(mesh_), x_(12 * count), materials_(soft::lame(3, 0.45)) {
    materials_.kinds.push_back(soft::lame(70, 0.1));
    for (std::size_t e = 0; e < count; ++e) {
      const Mat3 F = any_gradient(e, random_);
      for (std::uint32_t node : mesh_.tets[e]) x_.segment<3>(3 * node) = F * mesh_.positions[node];
      materials_.kind.push_back(e % 5 == 2);
    }
  }

  std::mt19937_64 random_{11};
  TetMesh mesh_;
  soft::Tet4Elements elements_;
  VecX x_;
  soft::Materials materials_;
};

TEST_F(CorotationalBatches, AreTheLaw) {
  ASSERT_EQ(elements_.size(), count);
  const auto fast = soft::make_corotational_batches(materials_, elements_);
  const auto plain = soft::make_law_batches(soft::make_fem_corotational, materials_, elements_);
  const Everything a = everything(*fast, count, x_), b = everything(*plain, count, x_);
  for (std::size_t batch = 0; batch < a.energy.size(); ++batch) {
    EXPECT_NEAR(a.energy[batch], b.energy[batch], 1e-12 * b.energy[batch]);
  }
  for (std::size_t e = 0; e < count; ++e) {
    EXPECT_LE(difference(a.forces[e], b.forces[e]), 1e-10 * (1 + largest(b.forces[e]))) << e;
    EXPECT_LE(difference(a.stiffness[e], b.stiffness[e]), 1e-6 * (1 + largest(b.stiffness[e]))) << e;
    EXPECT_EQ(a.warped[e], b.warped[e]) << e;
  }
}

TEST_F(CorotationalBatches, GiveTheSameBitsForEveryInstructionSet) {
  const auto batches = soft::make_corotational_batches(materials_, elements_);
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
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace
}  // namespace prosector
