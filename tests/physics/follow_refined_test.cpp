// A body's solver follows refinement, and what takes it back, to the bits of one made anew. Motion keeps its
// momentum.

#include <gtest/gtest.h>

#include "common/anatomy/embedding.h"
#include "common/anatomy/rest_stretch.h"
#include "server/physics/mechanics/organs/refined_body.h"
#include "server/physics/mechanics/soft/mesh_follower.h"
#include "tests/cutting/meshes.h"
#include "tests/physics/following.h"
#include "tests/random.h"

namespace prosector {
namespace {

constexpr double tick_rate = 60;  // Hz

SoftDesc refined_block() {
  SoftDesc desc;
  desc.name = "block";
  desc.refinement.at = Refining::touch;
  desc.geometry.cell = 0.03;
  desc.refinement.reach = 0.02;
  desc.attach = {{{0.05, 0.1, 0.05}, 0.04, 1e8}};
  return desc;
}

Anatomy round_block() {
  return embed(shaken_box(4), surface_of("block", 0.01)).anatomy;
}

struct RefinedRung {
  const char *name, *model, *solver;
  const char* integrator = "implicit_euler";
  bool regions = false, tense = false, relaxes = false;
};

class RefinedFollowers : public ::testing::TestWithParam<RefinedRung> {};

TEST_P(RefinedFollowers, TouchingAtRandomIsBeingMadeAnew) {
  const RefinedRung rung = GetParam();
  SoftDesc desc = refined_block();
  desc.configuration.model = rung.model;
  desc.configuration.solver = rung.solver;
  desc.configuration.integrator = rung.integrator;
  if (rung.regions) {
    RegionDesc& region = desc.material.regions.emplace_back();
    region.center = {0.07, 0.05, 0.05};
    region.radius = 0.04;
    region.youngs_modulus = 5 * desc.material.youngs_modulus;
  }
  if (rung.relaxes) desc.material.relaxation = {{0.3, 0.5}};
  Anatomy mesh = round_block();
  if (rung.tense) {
    Random random(8);
    std::vector<Mat3> stretch;
    for (std::size_t t = 0; t < mesh.tets.tets.size(); ++t)
      stretch.emplace_back((Vec3::Ones() + random.point(0.1)).asDiagonal());
    mesh.tets.stretch = std::make_shared<RestStretch>(mesh.tets, stretch);
  }
  soft::SoftBody body(desc, mesh);
  organs::RefinedBody refined(body, tick_rate);
  const std::uint64_t compiled = body.content_hash();
  Random random(test_seed(true));
  std::size_t followed = 0, most = 0;
  const auto follow = [&](std::span<const cutting::RefinementStep> steps) {
    if (steps.empty()) return;
    organs::PieceMesh now = organs::refined_mesh(refined);
    const organs::PieceEdit edit = organs::edit_between(refined.piece, now);
    ASSERT_TRUE(body.follower().can_follow(edit.mesh));
    body.follower().follow(edit.mesh, organs::refined_embedding(refined, now));
    soft::SoftBody rebuilt(desc, organs::refined_anatomy(refined, now));
    ASSERT_EQ(body.content_hash(), rebuilt.content_hash());
    ASSERT_TRUE(same_answers(body, rebuilt, static_cast<unsigned>(followed)));
    const Anatomy& anatomy = body.anatomy();
    for (std::size_t v = 0; v < anatomy.embedding.rows.size(); ++v)
      ASSERT_LT((anatomy.embedding.apply(v, body.rest().data()) - anatomy.surface.positions[v]).norm(),
                1e-12);
    refined.piece = std::move(now);
    ++followed;
    most = std::max(most, refined.mesh.added());
  };
  Vec3 finger = Vec3::Constant(mesh_size / 2);
  for (int tick = 0; tick < 90; ++tick) {
    finger = (finger + random.point(0.015)).cwiseMax(0).cwiseMin(mesh_size);
    const bool lifted = tick > 20 && tick < 84;
    const cutting::TouchedPlaces touched =
        lifted ? cutting::TouchedPlaces() : cutting::TouchedPlaces({finger}, 1e-3);
    follow(refined.mesh.follow(touched, false, tick % 10 == 0));
    if (HasFatalFailure()) return;
  }
  follow(refined.mesh.take_back());
  EXPECT_GT(followed, 10u);
  EXPECT_GT(most, 100u);
  EXPECT_EQ(body.content_hash(), compiled);
}

INSTANTIATE_TEST_SUITE_P(
    Rungs, RefinedFollowers,
    ::testing::Values(
        RefinedRung{.name = "corotational", .model = "fem_corotational", .solver = "cg"},
        RefinedRung{.name = "regions", .model = "fem_neo_hookean", .solver = "direct", .regions = true},
        RefinedRung{.name = "multigrid", .model = "fem_corotational", .solver = "multigrid"},
        RefinedRung{.name = "tense", .model = "fem_corotational", .solver = "cg", .tense = true},
        RefinedRung{.name = "relaxing", .model = "fem_corotational", .solver = "cg", .relaxes = true},
        RefinedRung{.name = "explicit", .model = "fem_corotational", .solver = "cg", .integrator = "verlet"},
        RefinedRung{.name = "springs", .model = "mass_spring", .solver = "cg", .regions = true},
        RefinedRung{.name = "xpbd", .model = "xpbd", .solver = "cg"}),
    [](const auto& row) { return row.param.name; });

Vec3 momentum(const VecX& mass, const VecX& field) {
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < mass.size(); ++i) sum += mass[i] * field.segment<3>(3 * i);
  return sum;
}

// Whatever the motion is, linear momentum stays to rounding, and with it what a turn is as a whole.
TEST(RefinedMotion, KeepsMomentumAndWhatIsLinear) {
  const SoftDesc desc = refined_block();
  const soft::SoftBody coarse(desc, round_block());
  organs::RefinedBody refined(coarse, tick_rate);
  Random random(3);
  VecX velocity = VecX::NullaryExpr(3 * coarse.nodes(), [&] { return random.uniform(-1, 1); });
  Mat3 turn;
  turn << 0, -1, 2, 1, 0, -3, -2, 3, 0;
  VecX turning(3 * coarse.nodes());
  for (Eigen::Index i = 0; i < coarse.nodes(); ++i)
    turning.segment<3>(3 * i) = turn * coarse.rest().segment<3>(3 * i) + Vec3(1, 2, 3);
  const VecX turned = turning;
  VecX mass = coarse.node_mass();
  const auto take = [&](std::span<const cutting::RefinementStep> steps) {
    organs::PieceMesh now = organs::refined_mesh(refined);
    const Vec3 before = momentum(mass, velocity);
    velocity = organs::carried(velocity, refined.piece, now, steps, organs::Leaving::momentum);
    turning = organs::carried(turning, refined.piece, now, steps, organs::Leaving::momentum);
    mass = soft::SoftBody(desc, organs::refined_anatomy(refined, now)).node_mass();
    EXPECT_LT((momentum(mass, velocity) - before).norm(), 1e-12 * coarse.total_mass());
    EXPECT_NEAR(mass.sum(), coarse.total_mass(), 1e-14);
    refined.piece = std::move(now);
  };
  std::size_t taken_back = 0;
  for (int round = 0; round < 3; ++round) {
    for (int tick = 0; tick < 4; ++tick)
      take(refined.mesh.follow(cutting::TouchedPlaces({Vec3::Constant(0.05) + random.point(0.05)}, 1e-3),
                               false, true));
    velocity += VecX::NullaryExpr(velocity.size(), [&] { return random.uniform(-1, 1); });
    const auto steps = refined.mesh.take_back();
    taken_back += steps.size();
    take(steps);
  }
  EXPECT_GT(taken_back, 100u);
  EXPECT_LT((turning - turned).lpNorm<Eigen::Infinity>(), 1e-13);
}

TEST(RefinedMotion, HistoryIsTheHalvesMean) {
  const soft::SoftBody coarse(refined_block(), round_block());
  organs::RefinedBody refined(coarse, tick_rate);
  const auto count = [&] { return 6 * static_cast<Eigen::Index>(refined.piece.tets.size()); };
  const VecX begin = VecX::LinSpaced(count(), 1, 2);
  const auto steps = refined.mesh.follow(cutting::TouchedPlaces({Vec3::Constant(0.05)}, 1e-3), false, false);
  ASSERT_FALSE(steps.empty());
  organs::PieceMesh now = organs::refined_mesh(refined);
  const VecX halves = organs::refined_history(begin, refined.mesh.complex(), refined.piece, now, steps);
  const organs::PieceMesh before = std::exchange(refined.piece, std::move(now));
  ASSERT_EQ(halves.size(), count());
  for (std::size_t i = 0; i < refined.piece.tets.size(); ++i) {
    cutting::TetId whole = refined.piece.tets[i];
    while (refined.mesh.complex().lineage(whole).parent != cutting::TetComplex::none)
      whole = refined.mesh.complex().lineage(whole).parent;
    EXPECT_EQ(halves[6 * static_cast<Eigen::Index>(i)], begin[6 * static_cast<Eigen::Index>(whole)]);
  }
  const auto back = refined.mesh.take_back();
  const VecX again = organs::refined_history(halves, refined.mesh.complex(), refined.piece, before, back);
  EXPECT_LT((again - begin).lpNorm<Eigen::Infinity>(), 1e-14);
}

}  // namespace
}  // namespace prosector
