// Estimates of a body's error, against errors that are known.

#include "server/accuracy/body_estimator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/anatomy/rest_stretch.h"
#include "common/body_messages.h"
#include "common/error_map.h"
#include "server/accuracy/body_trial.h"
#include "server/accuracy/bubbles.h"
#include "server/accuracy/error_grid.h"
#include "server/accuracy/law_difference.h"
#include "server/physics/mechanics/soft/elements/edge_nodes.h"
#include "server/physics/mechanics/soft/laws/polar.h"
#include "server/physics/mechanics/soft/soft_matter.h"
#include "tests/accuracy/boxes.h"

namespace prosector {
namespace {

VecX everywhere(const Vec3& value, std::size_t nodes) {
  return value.replicate(static_cast<Eigen::Index>(nodes), 1);
}

BodyMoment still(const VecX& x, const Vec3& acceleration) {
  BodyMoment out;
  out.x = x;
  out.slip = VecX::Zero(x.size());
  out.acceleration = everywhere(acceleration, static_cast<std::size_t>(x.size() / 3));
  return out;
}

Estimate estimate(BodyEstimator& estimator, BodyMoment moment) {
  estimator.begin(moment);
  EXPECT_TRUE(estimator.go_on(estimator.pieces()));
  return estimator.newest();
}

/// A body at rest under an acceleration of all of it, and how far that goes, J.
struct Settled {
  Settled(SoftDesc desc, const Anatomy& mesh, const char* model, const char* element,
          const Vec3& acceleration)
      : body((desc.configuration.model = model, desc.configuration.element = element, desc), mesh) {
    VecX load(body.rest().size());
    for (Eigen::Index i = 0; i < body.mass().size(); ++i)
      load.segment<3>(3 * i) = body.mass()[i] * acceleration;
    x = body.settle(load).x;
    way = load.dot(x - body.rest());
    BodyEstimator estimator(desc, body.mesh(), body.matter().ties, tissue_law);
    found = estimate(estimator, still(x, acceleration));
  }
  StaticBody body;
  VecX x;
  double way;
  Estimate found;
};

Anatomy halved(const Anatomy& anatomy) {
  Anatomy fine;
  fine.tets = anatomy.tets;
  fine.tets = soft::divided(fine.tets, soft::add_edge_nodes(fine));
  return fine;
}

TEST(Bubbles, AreTheFunctionsThatTheyAreSaidToBe) {
  const BubbleTable linear = bubbles(false), quadratic = bubbles(true);
  ASSERT_EQ(linear.of_tet.size(), 6u);
  ASSERT_EQ(quadratic.of_tet.size(), 10u);
  const Bubble& edge = linear.of_tet[0];  // 4·L_0·L_1
  EXPECT_NEAR(edge.slope[0], 1, 1e-14);
  EXPECT_NEAR(edge.slope[2], 0, 1e-14);
  EXPECT_NEAR(edge.load.sum(), 0.2, 1e-14);          // ∫4L₀L₁ = 4·6/120
  EXPECT_NEAR(edge.square, 16. * 24 / 5040, 1e-14);  // ∫16L₀²L₁²
  EXPECT_NEAR(quadratic.of_tet[0].slope.norm(), 0, 1e-14) << "what is odd has no mean slope";
  EXPECT_NEAR(quadratic.of_tet[9].load.sum(), 6. / 720, 1e-14);   // ∫L₁L₂L₃
  EXPECT_NEAR(quadratic.of_face[3].load.sum(), 2. / 120, 1e-14);  // ∫L₀L₁L₂ of a triangle
  for (const BubbleTable& table : {linear, quadratic})
    for (const Bubble& bubble : table.of_tet)
      EXPECT_NEAR((bubble.stress.colwise().sum().transpose() - bubble.slope).norm(), 0, 1e-14);
}

/// Even strain leaves nothing for finer functions to take up.
TEST(BodyEstimator, FindsNothingWrongWithEvenStrain) {
  const Anatomy mesh = test::box({0.1, 0.1, 0.1}, 3, 3, 3);
  Mat3 F;
  F << 1.1, 0.03, 0, 0, 0.92, 0.02, 0, 0, 1.01;
  for (const char* element : {"tet4", "tet10"}) {
    SoftDesc desc = test::pinned(1, 5400, 0.45);
    desc.configuration.element = element;
    const StaticBody body(desc, mesh);
    VecX ties = VecX::Zero(body.mass().size()), x = body.rest();
    for (Eigen::Index i = 0; i < ties.size(); ++i) {
      const Vec3 at = body.rest().segment<3>(3 * i);
      x.segment<3>(3 * i) = F * at;
      const bool outside = (at.array() < 1e-6).any() || (at.array() > 0.1 - 1e-6).any();
      ties[i] =
          outside ? 1e-12 : 0;  // a tie so soft that it holds nothing: its functions are loaded by nothing
    }
    BodyEstimator estimator(desc, body.mesh(), ties, tissue_law);
    BodyMoment moment = still(x, Vec3::Zero());
    estimator.begin(moment);
    ASSERT_TRUE(estimator.go_on(estimator.pieces()));
    int inside = 0;
    for (std::size_t i = 0; i < estimator.newest().local.size(); ++i) {
      const Vec3 at = body.rest().segment<3>(3 * static_cast<Eigen::Index>(i));
      if ((at.array() < 0.03).any() || (at.array() > 0.07).any()) continue;
      ++inside;
      EXPECT_LT(estimator.newest().local[i], 1e-12) << element;
    }
    EXPECT_EQ(inside, 8);
    EXPECT_EQ(estimator.newest().parts.model, 0);
  }
}

TEST(BodyEstimator, IsAsLargeAsTheErrorItself) {
  struct Row {
    double ratio;
    const char* model;
    const char* element;
    double up;
  };
  const Anatomy mesh = test::box({0.1, 0.1, 0.1}, 4, 4, 4);
  for (const Row& row :
       {Row{0.3, "fem_neo_hookean", "tet4", 1}, Row{0.45, "fem_neo_hookean", "tet4", 1},
        Row{0.45, "fem_neo_hookean", "tet4", -1}, Row{0.45, "fem_corotational", "tet4", -1},
        Row{0.45, "fem_corotational", "tet10", 1}, Row{0.49, "fem_corotational", "tet10", -1}}) {
    const SoftDesc desc = test::pinned(1, 5400, row.ratio);
    const Settled body(desc, mesh, row.model, row.element, row.up * test::gravity);
    const double truth = Settled(desc, halved(mesh), tissue_law, "tet10", row.up * test::gravity).way;
    const double error = std::abs(1 - body.way / truth);
    EXPECT_GT(body.found.error / error, 0.7) << row.ratio << row.model << row.element << row.up;
    EXPECT_LT(body.found.error / error, 1.5) << row.ratio << row.model << row.element << row.up;
  }
}

/// A beam's sag converges at second order.
TEST(BodyEstimator, FallsAsTheErrorDoes) {
  const SoftDesc desc = test::pinned(0, 3e5, 0.3);
  const auto d = [&](unsigned cells) {
    const Estimate found =
        Settled(desc, test::box({0.4, 0.1, 0.1}, 4 * cells, cells, cells), tissue_law, "tet4", test::gravity)
            .found;
    return found.parts.discretisation / (1 - found.parts.discretisation);
  };
  const double coarse = d(4), fine = d(8);
  EXPECT_GT(coarse / fine, 2.8);
  EXPECT_LT(coarse / fine, 4.5);
}

TEST(BodyEstimator, IsTheSameHoweverTheBodyIsTurnedAndHoweverItsWorkIsDivided) {
  const SoftDesc desc = test::pinned(1, 5400, 0.3);
  const Anatomy mesh = test::box({0.1, 0.1, 0.1}, 3, 3, 3);
  const Settled body(desc, mesh, "fem_corotational", "tet4", test::gravity);
  SoftDesc free = desc;
  free.configuration.model = "fem_corotational";
  const VecX none = VecX::Zero(body.body.mass().size());
  BodyEstimator whole(free, body.body.mesh(), none, tissue_law),
      parted(free, body.body.mesh(), none, tissue_law);
  const Estimate expected = estimate(whole, still(body.x, test::gravity));
  const Mat3 R = Eigen::AngleAxisd(1.2, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  VecX turned = body.x;
  for (Eigen::Index i = 0; i < turned.size() / 3; ++i)
    turned.segment<3>(3 * i) = R * body.x.segment<3>(3 * i);
  const Estimate other = estimate(whole, still(turned, R * test::gravity));
  EXPECT_NEAR(other.parts.discretisation, expected.parts.discretisation, 1e-9);
  EXPECT_NEAR(other.parts.model, expected.parts.model, 1e-9);
  BodyMoment moment = still(body.x, test::gravity);
  parted.begin(moment);
  int calls = 1;
  while (!parted.go_on(7)) ++calls;
  EXPECT_EQ(calls, static_cast<int>((parted.pieces() + 6) / 7));
  EXPECT_EQ(parted.newest().error, expected.error) << "to the bit";
  EXPECT_EQ(parted.newest().local, expected.local);
}

/// What lay there before doesn't count for the force that is felt.
TEST(BodyEstimator, JudgesAPressByItself) {
  SoftDesc desc = test::pinned(1, 5e4, 0.3);
  const Anatomy mesh = test::box({0.1, 0.1, 0.1}, 4, 4, 4);
  StaticBody body(desc, mesh);
  VecX weight(body.rest().size());
  for (Eigen::Index i = 0; i < body.mass().size(); ++i)
    weight.segment<3>(3 * i) = body.mass()[i] * test::gravity;
  const std::vector<Act> acts = acts_of(desc, mesh.tets, test::gravity, 1);
  const VecX press = load_of(acts.back(), body);
  BodyEstimator estimator(desc, body.mesh(), body.matter().ties, tissue_law);
  const double alone = estimate(estimator, still(body.settle(press).x, Vec3::Zero())).press;
  estimate(estimator, still(body.settle(weight).x, test::gravity));
  estimator.keep_as_quiet();
  const Estimate both = estimate(estimator, still(body.settle(weight + press).x, test::gravity));
  EXPECT_GT(alone, 0.05);
  EXPECT_NEAR(both.press, alone, 0.05 * alone);
}

/// A tick that goes on evenly is right; one in which velocities change by strain is not.
TEST(BodyEstimator, KnowsWhatATickIsTooLongFor) {
  const SoftDesc desc = test::pinned(1, 5400, 0.3);
  const Settled body(desc, test::box({0.1, 0.1, 0.1}, 3, 3, 3), tissue_law, "tet4", test::gravity);
  BodyEstimator estimator(desc, body.body.mesh(), body.body.matter().ties, tissue_law);
  BodyMoment moment = still(body.x, test::gravity);
  moment.slip = everywhere({0.01, 0.02, 0}, static_cast<std::size_t>(body.x.size() / 3));
  EXPECT_NEAR(estimate(estimator, moment).parts.time, 0, 1e-12);
  moment = still(body.x, test::gravity);
  moment.slip = 0.1 * (body.x - body.body.rest());
  EXPECT_NEAR(estimate(estimator, moment).parts.time, 0.1, 0.02);
}

/// Tissue under tension rests as it does by either law. What comes on top of that differs by how stiff the
/// laws are then, however little it is: a difference at rest, over it, would grow without bound.
TEST(BodyEstimator, TellsOfTheLawInTissueUnderTensionWhateverItMoves) {
  SoftDesc desc = test::pinned(1, 5400, 0.45);
  desc.configuration.model = "fem_corotational";
  Anatomy box = test::box({0.1, 0.1, 0.1}, 3, 3, 3);
  const Mat3 grown = Vec3(0.95, 1 / (0.95 * 0.95), 0.95).asDiagonal();
  box.tets.stretch = std::make_shared<RestStretch>(box.tets, std::vector(box.tets.tets.size(), grown));
  const StaticBody body(desc, box);
  const VecX rest = body.rest();
  BodyEstimator estimator(desc, body.mesh(), body.matter().ties, tissue_law);
  const auto model = [&](double shear) {
    VecX x = rest;
    for (Eigen::Index i = 0; i < x.size() / 3; ++i) x[3 * i] += shear * rest[3 * i + 1];
    return std::abs(estimate(estimator, still(x, Vec3::Zero())).parts.model);
  };
  const double small = model(0.01);
  EXPECT_GT(small, 0) << "the laws differ";
  EXPECT_LT(small, 0.3);
  EXPECT_NEAR(model(0.001), small, 0.1 * small);
  EXPECT_NEAR(model(0.0001), small, 0.1 * small);
}

/// Under a pull along one axis both laws' stretches are known.
TEST(LawDifference, IsTheWorkThatTissueDoesMoreUnderOnePull) {
  for (const double ratio : {0.3, 0.45, 0.49, 0.499})
    for (const double pull : {-600., -200., 200., 600.}) {
      const soft::Material material(soft::lame(5400, ratio));
      const auto tissue = soft::make_law(tissue_law, material),
                 own = soft::make_law("fem_corotational", material);
      const auto stretched = [&](const soft::ConstitutiveLaw& law) {
        Vec3 s(1, 1, 1);  // of which only s.x() bears: Newton's method by differences
        const auto left = [&](const Vec3& at) -> Vec3 {
          const Mat3 F = at.asDiagonal();
          Mat3 P;
          law.stress({&F, 1}, {}, {&P, 1});
          return P.diagonal() - Vec3(pull, 0, 0);
        };
        for (int i = 0; i < 50; ++i) {
          Mat3 slope;
          for (int k = 0; k < 3; ++k) slope.col(k) = (left(s + 1e-6 * Vec3::Unit(k)) - left(s)) / 1e-6;
          s -= slope.inverse() * left(s);
        }
        return s;
      };
      const Mat3 F = stretched(*own).asDiagonal();
      Mat3 P;
      own->stress({&F, 1}, {}, {&P, 1});
      const Mat3 R = Mat3::Identity();
      const ElementStrain strain{{&F, 1}, {&R, 1}, {&P, 1}};
      const double more = pull * (stretched(*tissue).x() - F(0, 0));
      EXPECT_NEAR(law_difference(*tissue, 0, strain).work / more, 1, 0.3) << ratio << " " << pull;
      EXPECT_NEAR(law_difference(*own, 0, strain).work, 0, 1e-6 * std::abs(more));
    }
}

TEST(ErrorGrid, TellsAnEvenErrorEvenlyAndALocalOneWhereItIs) {
  const TetMesh mesh = test::box({0.2, 0.1, 0.05}, 8, 4, 2).tets;
  ErrorGrid grid(mesh, mesh.positions.size());
  std::vector<double> errors(mesh.positions.size(), 0.05);
  const ErrorMap even = grid.map_of(errors);
  EXPECT_EQ(even.size[0], max_error_map_side);
  for (const std::uint8_t level : even.levels) EXPECT_EQ(level, level_of(0.05));
  for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = mesh.positions[i].x() > 0.19 ? 0.4 : 0;
  const ErrorMap local = grid.map_of(errors);
  EXPECT_GT(*error_at(local, {0.2, 0.05, 0.02}), 0.2);
  EXPECT_LT(*error_at(local, {0.1, 0.05, 0.02}), 1e-3);
}

}  // namespace
}  // namespace prosector
