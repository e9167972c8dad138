// What trials on a body tell, against errors that are known.

#include "server/accuracy/body_trial.h"

#include <gtest/gtest.h>

#include "server/accuracy/outer_surface.h"
#include "server/physics/mechanics/soft/soft_matter.h"
#include "server/physics/stations/compile/grading.h"
#include "tests/accuracy/boxes.h"

namespace prosector {
namespace {

double error_of(const std::vector<ActError>& acts, const std::string& name) {
  for (const ActError& act : acts)
    if (act.act == name) return act.error;
  ADD_FAILURE() << "no act " << name;
  return 0;
}

/// The beam of the reference values, 8 × 2 × 2 cells: linear tetrahedra give this share of the continuum's
/// sag (shared table of fixed-mesh values; corotational over its continuum).
TEST(BodyTrial, KnowsTheBeamsLocking) {
  struct Row {
    double ratio, share;
  };
  for (const Row& row : {Row{0.3, 0.06788235 / 0.12275}, Row{0.45, 0.04312521 / 0.1206}}) {
    const SoftDesc desc = test::pinned(0, 3e5, row.ratio);
    const BodyTrial trial(desc, test::gravity, test::box({0.4, 0.1, 0.1}, 8, 2, 2),
                          {.law = "fem_corotational", .presses = 0});
    ASSERT_TRUE(trial.judges_quadratic());
    EXPECT_NEAR(error_of(trial.measure("fem_corotational", "tet4"), "under its weight"), 1 - row.share, 0.03)
        << row.ratio;
    EXPECT_LT(error_of(trial.measure("fem_corotational", "tet10"), "under its weight"), 0.06) << row.ratio;
  }
}

/// A cube that stands is off by the corotational law's error, which bending beams hide.
TEST(BodyTrial, SeesWhatALawGetsWrongUnderPressure) {
  const SoftDesc desc = test::pinned(1, 5400, 0.45);
  const BodyTrial trial(desc, test::gravity, test::box({0.1, 0.1, 0.1}, 4, 4, 4), {.presses = 0});
  const double own = error_of(trial.measure("fem_neo_hookean", "tet10"), "under its weight");
  const double other = error_of(trial.measure("fem_corotational", "tet10"), "under its weight");
  EXPECT_LT(own, 0.05);
  EXPECT_GT(other, own + 0.03);
}

/// Errors of every act fall as the cells do, of the reference's own law.
TEST(BodyTrial, ErrorsFallWithTheCells) {
  const SoftDesc desc = test::pinned(1, 5400, 0.3);
  const auto at = [&](unsigned cells) {
    return BodyTrial(desc, test::gravity, test::box({0.1, 0.1, 0.1}, cells, cells, cells), {.presses = 1})
        .measure("fem_neo_hookean", "tet4");
  };
  const auto coarse = at(2), fine = at(4);
  ASSERT_EQ(coarse.size(), 4u);
  for (std::size_t act = 0; act < coarse.size(); ++act) {
    EXPECT_LT(fine[act].error, 0.9 * coarse[act].error) << coarse[act].act;
    EXPECT_GT(fine[act].unsettled, 0) << "the reference's own part";
    EXPECT_LT(fine[act].unsettled, 0.3 * fine[act].error);
    EXPECT_LT(fine[act].unsettled, 0.9 * coarse[act].unsettled);
  }
}

/// A cube that stands, nearly incompressible: smaller elements at the foot's rim gain more than smaller ones
/// throughout.
TEST(BodyTrial, ErrorsFallMostWithElementsAtTheRims) {
  SoftDesc desc = test::pinned(1, 5400, 0.49);
  desc.configuration.element = "tet10";
  desc.geometry.grade = Grading::rims;
  const auto cube = [](std::uint32_t cells) { return test::box({0.1, 0.1, 0.1}, cells, cells, cells); };
  StaticBody reference(desc, graded_at_rims(desc, cube(5)));
  const std::vector<Vec3> places = places_in(reference.mesh(), 200);
  const Act act = {"under its weight", test::gravity, {}};
  const VecX right = reference.settle(load_of(act, reference)).x;
  const auto error_of = [&](const Anatomy& mesh) {
    StaticBody body(desc, mesh);
    return relative_difference(Probes(body, places), body.settle(load_of(act, body)).x,
                               Probes(reference, places), right, places.size());
  };
  const Anatomy uniform = cube(3), graded = graded_at_rims(desc, cube(2));
  EXPECT_LT(graded.tets.tets.size(), uniform.tets.tets.size());
  EXPECT_LT(error_of(graded), 0.5 * error_of(uniform));
  EXPECT_LT(error_of(graded), 0.04);
}

TEST(BodyTrial, NothingIsNearWhatCollapses) {
  const SoftDesc desc = test::pinned(1, 150, 0.3);
  const BodyTrial trial(desc, 2 * test::gravity, test::box({0.1, 0.1, 0.1}, 2, 2, 2), {.presses = 0});
  for (const char* element : {"tet4", "tet10"})
    EXPECT_GE(error_of(trial.measure("fem_neo_hookean", element), "under its weight"), collapsed) << element;
}

std::vector<std::string> names(const std::vector<Act>& acts) {
  std::vector<std::string> out;
  for (const Act& act : acts) out.push_back(act.name);
  return out;
}

/// A free body that is tilted stands on less of it, and coarse elements get more of that wrong.
TEST(BodyTrial, TiltsWhatIsFree) {
  SoftDesc desc = test::pinned(1, 30000, 0.3);
  const Anatomy mesh = test::box({0.24, 0.1, 0.1}, 4, 2, 2);
  const TrialSettings settings = {.most_tets = 1000, .presses = 0};
  const std::vector<std::string> level = {"under its weight", "hung", "on its side"};
  EXPECT_EQ(names(BodyTrial(desc, test::gravity, mesh, settings).acts()), level) << "tied";
  desc.attach.clear();
  const BodyTrial trial(desc, test::gravity, mesh, settings);
  const auto acts = trial.measure("fem_neo_hookean", "tet10");
  EXPECT_GT(error_of(acts, "tilted"), 1.5 * error_of(acts, "under its weight"));
  EXPECT_GT(error_of(acts, "tilted across"), 0);
}

/// A long soft body doesn't stand on its end, whatever models it: that says nothing of a model.
TEST(BodyTrial, LeavesOutATiltThatTissueDoesNotBear) {
  SoftDesc desc = test::pinned(1, 1000, 0.3);
  desc.attach.clear();
  const Anatomy mesh = test::box({0.4, 0.1, 0.1}, 4, 1, 1);
  const BodyTrial trial(desc, test::gravity, mesh, {.most_tets = 200, .presses = 0});
  const std::vector<std::string> level = {"under its weight", "hung", "on its side"};
  EXPECT_EQ(names(trial.acts()), level);
  EXPECT_EQ(trial.measure("fem_neo_hookean", "tet4").size(), level.size());
}

/// What a tie misses lies free: without a bed nothing would come to rest.
TEST(BodyTrial, ATieThatHoldsNothingLeavesABodyFree) {
  SoftDesc desc = test::pinned(1, 30000, 0.3);
  desc.attach = {{Vec3(1, 1, 1), 0.01, 1e12}};
  const BodyTrial trial(desc, test::gravity, test::box({0.1, 0.1, 0.1}, 2, 2, 2),
                        {.most_tets = 400, .presses = 1});
  EXPECT_LT(worst(trial.measure("fem_neo_hookean", "tet10")).error, 1);
}

/// Half of the places that a fingertip presses are where a body is thin.
TEST(BodyTrial, PressesWhereABodyIsThin) {
  const TetMesh mesh = test::box({0.3, 0.12, 0.06}, 6, 3, 2).tets;
  for (const OuterFace& face : outer_faces(mesh)) {
    const Vec3 normal = area_vector(mesh, face).normalized();
    EXPECT_NEAR(depth_below(mesh, outer_faces(mesh), face), std::abs(normal.dot(Vec3(0.3, 0.12, 0.06))),
                1e-12);
  }
  const std::vector<Act> acts = acts_of(SoftDesc{}, mesh, Vec3::Zero(), 6);
  ASSERT_EQ(acts.size(), 6u);
  for (std::size_t i = 3; i < acts.size(); ++i)
    EXPECT_NEAR(std::abs(acts[i].press->inward.z()), 1, 1e-9) << acts[i].name;
}

/// A bed takes the place of the one before; what the description ties stays.
TEST(StaticBody, IsTiedInPlaceOfTiesBefore) {
  SoftDesc desc = test::pinned(1, 30000, 0.3);
  const Anatomy mesh = test::box({0.1, 0.1, 0.1}, 2, 2, 2);
  StaticBody body(desc, mesh);
  const VecX described = body.matter().ties;
  ASSERT_GT(described.norm(), 0);
  const VecX bed = VecX::Constant(described.size(), 3);
  body.tie(2 * bed);
  body.tie(bed);
  EXPECT_NEAR((body.matter().ties - described - bed).norm(), 0, 1e-9 * described.norm());
}

/// A free body is held alike on every mesh: by a bed whose springs add up to the same.
TEST(Foot, HoldsEveryMeshAlike) {
  SoftDesc desc = test::pinned(1, 5400, 0.3);
  desc.attach.clear();
  const Anatomy fine = test::box({0.1, 0.1, 0.1}, 8, 8, 8);
  const auto foot = foot_of(desc, fine.tets, test::gravity);
  ASSERT_TRUE(foot);
  const double all = ties_of(*foot, StaticBody(desc, fine)).sum();
  for (const char* element : {"tet4", "tet10"}) {
    desc.configuration.element = element;
    EXPECT_NEAR(ties_of(*foot, StaticBody(desc, test::box({0.1, 0.1, 0.1}, 5, 5, 5))).sum() / all, 1, 0.1)
        << element;
  }
  EXPECT_FALSE(foot_of(test::pinned(1, 5400, 0.3), fine.tets, test::gravity)) << "its ties hold it";
}

}  // namespace
}  // namespace prosector
