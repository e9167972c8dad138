// Matrices of turned elements against the same in double from element blocks.

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "server/physics/mechanics/soft/elements/element_batches.h"
#include "server/physics/mechanics/soft/elements/tet10.h"
#include "server/physics/mechanics/soft/implicit_stepper.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/make_model.h"
#include "server/physics/mechanics/soft/matrices/block_matrix.h"
#include "server/physics/mechanics/soft/matrices/corotated_stiffness.h"
#include "tests/soft/kuhn.h"
#include "tests/soft/stepper.h"

namespace prosector {
namespace {

const Vec3 cube_size(0.1, 0.1, 0.1), gravity(0, -9.81, 0);
constexpr double h = 1. / 60;
constexpr double of_floats = 2e-6;  // relative: what single precision leaves of matrices

struct Case {
  std::string model, element;
  double poisson_ratio;  // quadratic ones average their dilatation above 0.2
};

/// Every batched law, with linear and quadratic elements.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const soft::BatchedLawRow& law : soft::batched_laws())
    for (const auto& [element, nu] :
         {std::pair("tet4", 0.3), {"tet4", 0.49}, {"tet10", 0.1}, {"tet10", 0.49}})
      all.push_back({law.law, element, nu});
  return all;
}

VecX random_vector(Eigen::Index n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return VecX::NullaryExpr(n, [&] { return std::uniform_real_distribution<double>(-1, 1)(random); });
}

SoftDesc description(const Case& row) {
  SoftDesc desc;
  desc.name = "cube";
  desc.configuration.model = row.model;
  desc.configuration.element = row.element;
  desc.material.poisson_ratio = row.poisson_ratio;
  RegionDesc stiffer;
  stiffer.size = Vec3(0.1, 0.1, 0.08);
  stiffer.poisson_ratio = row.poisson_ratio / 2;  // λ/μ and the mean part differ within the body
  stiffer.youngs_modulus = 10 * desc.material.youngs_modulus;
  if (row.model == "fem_fibers") {  // taut, slack and of other directions
    desc.material.fiber_stiffness = 2 * desc.material.youngs_modulus;
    desc.material.fiber_direction = Vec3(1, 0.2, 0.1);
    stiffer.fiber_direction = Vec3(-0.3, 1, 1);
  }
  desc.material.regions.push_back(stiffer);
  return desc;
}

class Corotated : public testing::TestWithParam<Case> {
 protected:
  Corotated()
      : desc_(description(GetParam())),
        anatomy_(with_nodes(kuhn_anatomy({2, 2, 3}, cube_size))),
        model_(soft::make_elastic_model(desc_, anatomy_)),
        pattern_(model_->connectivity()),
        symmetric_(pattern_),
        rotated_(model_->connectivity(), pattern_, symmetric_) {
    const Eigen::Index n = model_->rest().size();
    Mat3 turn = Eigen::AngleAxisd(2, Vec3(1, -2, 3).normalized()).toRotationMatrix();
    turn.col(0) *= 1.2;
    x_ = (turn * model_->rest().reshaped(3, n / 3)).reshaped() + 2e-3 * random_vector(n, 1);
  }

  Anatomy with_nodes(Anatomy anatomy) const {
    if (desc_.configuration.element == "tet10") soft::add_edge_nodes(anatomy);
    return anatomy;
  }
  std::vector<Mat3> in_double(double tangent, double warped) {
    std::vector<Mat3> K(pattern_.blocks()), W(pattern_.blocks());
    pattern_.gather(model_->tangent(x_.data()), 0, {}, K);
    pattern_.gather(model_->warped_stiffness(x_.data()), 0, {}, W);
    for (std::size_t k = 0; k < K.size(); ++k) K[k] = tangent * K[k] + warped * W[k];
    return K;
  }
  VecX product(const std::vector<Mat3>& K, const VecX& u) const {
    VecX f(u.size());
    pattern_.multiply(K, u.data(), f.data());
    return f;
  }

  SoftDesc desc_;
  Anatomy anatomy_;
  std::unique_ptr<soft::ElasticModel> model_;
  soft::BlockPattern pattern_;
  soft::SymmetricPattern symmetric_;
  soft::CorotatedStiffness rotated_;
  VecX x_;
};
INSTANTIATE_TEST_SUITE_P(Table, Corotated, testing::ValuesIn(cases()), [](const auto& row) {
  return row.param.model + "_" + row.param.element + (row.param.poisson_ratio > 0.4 ? "_incompressible" : "");
});

TEST_P(Corotated, TangentAndDampingAreThoseOfTheBlocks) {
  for (const double s : {0.0, 2.5}) {
    soft::CorotatedElements elements;
    model_->linearise(x_.data(), 1 / (s + 1), elements);
    soft::SymmetricRows rows(symmetric_);
    rotated_.assemble(elements, rows);
    const VecX u = random_vector(x_.size(), 2), expected = product(in_double(1, s), u);
    VecX f(u.size());
    soft::multiply(symmetric_, rows, s + 1, rows.diagonal, u.data(), f.data());
    for (std::size_t i = 0; i < rows.diagonal.size(); ++i)
      f.segment<3>(3 * static_cast<Eigen::Index>(i)) +=
          s * rows.diagonal[i] * u.segment<3>(3 * static_cast<Eigen::Index>(i));
    EXPECT_LT((f - expected).norm(), of_floats * expected.norm()) << s;
  }
}

TEST_P(Corotated, TraceAtRestIsThatOfTheBlocks) {
  EXPECT_NEAR(model_->rest_trace() / model_->soft::ElasticModel::rest_trace(), 1, 1e-13);
}

TEST_P(Corotated, RowsGoToDoubleAndBack) {
  soft::CorotatedElements elements;
  model_->linearise(x_.data(), 1, elements);
  soft::SymmetricRows rows(symmetric_), back(symmetric_);
  rotated_.assemble(elements, rows);
  std::vector<Mat3> blocks(pattern_.blocks());
  rows.write(symmetric_, pattern_, 2, blocks);
  back.set(symmetric_, pattern_, 0.5, blocks);
  EXPECT_EQ(back.right, rows.right);
}

TEST_P(Corotated, ProductIsTheWarpedStiffnessAndItsEnergyHalfOfIt) {
  soft::CorotatedElements elements;
  model_->linearise(x_.data(), 0.5, elements);
  const VecX u = random_vector(x_.size(), 2), expected = product(in_double(0, 1), u);
  VecX f(u.size());
  const double energy = rotated_.multiply(elements, u.data(), f.data());
  EXPECT_LT((f - expected).norm(), of_floats * expected.norm());
  EXPECT_NEAR(energy, 0.5 * u.dot(f), 1e-12 * energy);
  EXPECT_EQ(rotated_.energy(elements, u.data()), energy);
}

TEST_P(Corotated, ProductLeavesTranslationsAndMomentumAlone) {
  soft::CorotatedElements elements;
  model_->linearise(x_.data(), 0.5, elements);
  const VecX u = random_vector(x_.size(), 2);
  VecX moved = u, f(u.size()), g(u.size());
  for (Eigen::Index i = 0; i < u.size() / 3; ++i) moved.segment<3>(3 * i) += Vec3(0.5, -2, 8);
  rotated_.multiply(elements, u.data(), f.data());
  rotated_.multiply(elements, moved.data(), g.data());
  EXPECT_LT((f - g).norm(), 1e-13 * f.norm());
  EXPECT_LT(f.reshaped(3, f.size() / 3).rowwise().sum().norm(), 1e-13 * f.norm());
}

TEST_P(Corotated, BodiesHaveTheHessianOfTheirEnergy) {
  SoftDesc desc = desc_;
  desc.configuration.solver = "cg";
  desc.material.damping_stiffness = 0.02;
  desc.attach.push_back({Vec3::Zero(), 0.06, 2e6});
  soft::SoftBody body(desc, kuhn_anatomy({2, 2, 3}, cube_size));
  soft::SoftBodyState state = body.initial_state();
  const Eigen::Index n = state.motion.x.size();
  state.motion.x *= 1.01;  // nothing is projected
  state.motion.v = random_vector(n, 2);
  body.stepper().begin_stage(0, h, gravity, state);
  ASSERT_TRUE(body.potential().tangent_is_cheap());
  const VecX x = state.motion.x, dx = random_vector(n, 4);
  VecX g(n), g_plus(n), g_minus(n), Hdx(n);
  const double e = 1e-7;
  body.potential().linearise(x);
  body.potential().gradient(x, g);
  body.potential().assemble(x);
  body.potential().multiply(dx.data(), Hdx.data());
  const double slope = (body.potential().energy(x + e * dx) - body.potential().energy(x - e * dx)) / (2 * e);
  EXPECT_NEAR(g.dot(dx), slope, 1e-6 * std::abs(slope));
  body.potential().gradient(x + e * dx, g_plus);
  body.potential().gradient(x - e * dx, g_minus);
  EXPECT_LT((Hdx - (g_plus - g_minus) / (2 * e)).norm(), 1e-5 * Hdx.norm());
}

}  // namespace
}  // namespace prosector
