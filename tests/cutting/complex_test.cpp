// The elementary changes by themselves, and what is refused.

#include <gtest/gtest.h>

#include "common/error.h"
#include "server/physics/mechanics/cutting/carry.h"
#include "tests/cutting/meshes.h"
#include "tests/cutting/soundness.h"
#include "tests/cutting/strokes.h"

namespace prosector {
namespace {

std::string refusal(cutting::TetComplex& complex, const cutting::TopologyOp& op) {
  const auto hash = cutting::content_hash(complex);
  try {
    complex.apply(op);
  } catch (const InputError& error) {
    EXPECT_EQ(cutting::content_hash(complex), hash) << "refused, but changed";
    return error.what();
  }
  return "";
}

cutting::SplitEdge split_of(const cutting::TetComplex& complex, cutting::NodeId a, cutting::NodeId b,
                            double t) {
  std::vector<cutting::TetId> around;
  complex.tables().around_edge(a, b, around);
  return {a,
          b,
          static_cast<cutting::NodeId>(complex.node_end()),
          t,
          static_cast<cutting::TetId>(complex.tet_end()),
          static_cast<std::uint32_t>(around.size())};
}

TEST(TetComplex, SplitsAnEdgeAndMendsIt) {
  cutting::TetComplex complex(box_mesh(2), mesh_density);
  const Whole before = whole(complex);
  const auto hash = cutting::content_hash(complex);
  const cutting::SplitEdge op =
      split_of(complex, 0, 26, 0.25);  // the diagonal ends in the middle: not an edge
  EXPECT_NE(refusal(complex, op), "");
  const cutting::SplitEdge good = split_of(complex, 0, 13, 0.25);
  EXPECT_EQ(good.count, 6u);
  complex.apply(good);
  EXPECT_TRUE(is_sound(complex, before));
  EXPECT_NEAR((complex.rest(good.node) - Vec3::Constant(0.0125)).norm(), 0, 1e-15);
  EXPECT_NE(cutting::content_hash(complex), hash);
  complex.take_back(good);
  EXPECT_EQ(cutting::content_hash(complex), hash);
  EXPECT_NE(refusal(complex, good), "") << "ids are not used again";
  EXPECT_EQ(refusal(complex, split_of(complex, 0, 13, 0.25)), "");
}

TEST(TetComplex, RefusesWhatDoesNotFit) {
  cutting::TetComplex complex(box_mesh(2), mesh_density);
  cutting::SplitEdge op = split_of(complex, 0, 13, 0.5);
  for (const double t : {0.0, 1.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    cutting::SplitEdge bad = op;
    bad.t = t;
    EXPECT_NE(refusal(complex, bad), "");
  }
  cutting::SplitEdge bad = op;
  bad.count = 5;
  EXPECT_NE(refusal(complex, bad), "");
  bad = op;
  bad.a = 4'000'000'000u;
  EXPECT_NE(refusal(complex, bad), "");
  bad = op;
  bad.node = bad.first = 4'000'000'000u;
  EXPECT_NE(refusal(complex, bad), "");
  EXPECT_NE(refusal(complex, cutting::SlitFaces{{{0, 47}}}), "");
  EXPECT_NE(refusal(complex, cutting::SlitFaces{{{1, 0}}}), "");
  EXPECT_NE(refusal(complex, cutting::PartNode{13, {{27, {0}}}}), "") << "tears faces";
  EXPECT_NE(refusal(complex, cutting::PartNode{0, {}}), "");
  EXPECT_THROW(complex.take_back(op), InputError);
  EXPECT_THROW(complex.take_back(cutting::SlitFaces{{{0, 1}}}), InputError);
  EXPECT_THROW(complex.take_back(cutting::PartNode{0, {{1, {0}}}}), InputError);
}

TEST(TetComplex, RefusesMeshesThatCannotBeCut) {
  TetMesh flat = single_tet();
  flat.positions[3] = flat.positions[0];
  EXPECT_THROW(cutting::TetComplex(flat, mesh_density), InputError);
  TetMesh thrice = single_tet();
  thrice.tets = {{0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}};
  EXPECT_THROW(cutting::TetComplex(thrice, mesh_density), InputError);
  TetMesh stray = single_tet();
  stray.tets[0][3] = 9;
  EXPECT_THROW(cutting::TetComplex(stray, mesh_density), InputError);
  EXPECT_THROW(cutting::TetComplex(single_tet(), 0), InputError);
}

TEST(Blade, RefusesGarbage) {
  cutting::TetComplex complex(box_mesh(2), mesh_density);
  cutting::TetTree tree;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec3> edge = {{0, 0, 0}, {0, 0, 1}}, bad = {{0, nan, 0}, {0, 0, 1}},
                          three(3, Vec3::Zero());
  EXPECT_THROW(cutting::begin_stroke(bad), InputError);
  EXPECT_THROW(cutting::begin_stroke(std::vector<Vec3>(1, Vec3::Zero())), InputError);
  cutting::BladeStroke stroke = cutting::begin_stroke(edge);
  const auto x = rest_positions(complex);
  EXPECT_THROW(cutting::cut(complex, tree, x, bad, stroke), InputError);
  EXPECT_THROW(cutting::cut(complex, tree, x, three, stroke), InputError);
  EXPECT_THROW(cutting::cut(complex, tree, std::vector<Vec3>(3), edge, stroke), InputError);
  try {
    cutting::cut(complex, tree, x, bad, stroke);
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("point 0"), std::string::npos) << error.what();
  }
}

// Linear momentum and the centre of mass stay when cut.
TEST(Carry, KeepsMomentum) {
  cutting::TetComplex complex(ball_mesh(0.016), mesh_density);
  std::vector<Vec3> x = rest_positions(complex), v = x;
  for (Vec3& u : v) u = Vec3(std::sin(90 * u[0]), u[1] * u[2] * 400, std::cos(70 * u[2]));
  const auto momentum = [&](const std::vector<Vec3>& value) {
    Vec3 p = Vec3::Zero();
    for (const cutting::NodeId i : cutting::node_ids(complex)) p += complex.mass(i) * value[i];
    return p;
  };
  const Vec3 before = momentum(v), center = momentum(x);
  cutting::TetTree tree;
  const Stroke stroke = across({0.5, 0.53, 0.5}, {0.3, 1, 0.2}, 1);
  cutting::BladeStroke state = cutting::begin_stroke(stroke[0]);
  const cutting::CutResult result = cutting::cut(complex, tree, x, stroke[1], state);
  for (const cutting::TopologyOp& op : result.ops) {
    cutting::carry(op, x);
    cutting::carry(op, v);
  }
  ASSERT_GT(result.parted_nodes, 10u);
  EXPECT_LT((momentum(v) - before).norm(), 1e-12 * before.norm());
  EXPECT_LT((momentum(x) - center).norm(), 1e-12 * center.norm());
}

}  // namespace
}  // namespace prosector
