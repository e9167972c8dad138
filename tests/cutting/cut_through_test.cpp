// What is done when a blade has left the body: what it missed, and what it left on purpose.

#include <gtest/gtest.h>

#include <utility>

#include "server/physics/mechanics/cutting/cut_through.h"
#include "server/physics/mechanics/cutting/missing_nodes.h"
#include "server/physics/mechanics/cutting/pieces.h"
#include "tests/cutting/meshes.h"
#include "tests/cutting/strokes.h"
#include "tests/random.h"

namespace prosector {
namespace {

constexpr std::uint32_t cells = 4;
constexpr double middle = mesh_size / 2;

/// Of the box's middle plane, across z, what `chosen` says.
template <class Chosen>
cutting::Marks marks_of(const cutting::TetComplex& complex, const Chosen& chosen) {
  cutting::Marks marks({}, complex.node_end());
  for (const cutting::NodeId node : cutting::node_ids(complex))
    if (std::abs(complex.rest(node).z() - middle) < 1e-9 && chosen(node))
      marks.add({node, complex.rest(node), Vec3::UnitZ()});
  return marks;
}

TEST(CutThrough, WhatHoldsTheHalvesTogetherIsFound) {
  cutting::TetComplex complex(box_mesh(cells), mesh_density);
  for (const cutting::NodeId left_out : cutting::node_ids(complex)) {
    if (std::abs(complex.rest(left_out).z() - middle) > 1e-9) continue;
    cutting::Marks marks = marks_of(complex, [&](cutting::NodeId node) { return node != left_out; });
    const std::vector<cutting::NodeId> missing = cutting::missing_nodes(complex, marks, 2);
    ASSERT_EQ(missing, std::vector<cutting::NodeId>{left_out});
    EXPECT_TRUE(cutting::faces_between_parts(complex, marks, 0).faces.empty());
    const cutting::BladeStroke::Mark mark = cutting::mark_between(complex, marks, left_out);
    EXPECT_NEAR(mark.normal.z(), 1, 1e-12);
    marks.add(mark);
    EXPECT_EQ(cutting::faces_between_parts(complex, marks, 0).faces.size(), 2 * cells * cells);
  }
}

/// A strip of the plane, one node wide, and straight ways through each of its nodes from above the marks to
/// below them: none of them can be spared, however many they are.
TEST(CutThrough, AsManyAsAreMissingAreFound) {
  for (const std::uint32_t across : {4U, 8U, 12U}) {
    const cutting::TetComplex complex(box_mesh(across), mesh_density);
    std::vector<cutting::NodeId> left_out;
    const cutting::Marks marks = marks_of(complex, [&](cutting::NodeId node) {
      const bool marked = std::abs(complex.rest(node).x() - middle) > 1e-9;
      if (!marked) left_out.push_back(node);
      return marked;
    });
    ASSERT_EQ(left_out.size(), across + 1);
    EXPECT_EQ(cutting::missing_nodes(complex, marks, across + 1), left_out);
    EXPECT_EQ(cutting::missing_nodes(complex, marks, 10 * across), left_out);
    EXPECT_TRUE(cutting::missing_nodes(complex, marks, across).empty());
  }
}

/// Whether marks, and more nodes, part what is above the middle plane from what is below.
bool part(const cutting::TetComplex& complex, const cutting::Marks& marks,
          const std::vector<cutting::NodeId>& more) {
  std::vector<std::uint8_t> seen(complex.node_end(), 0);
  for (const cutting::NodeId node : more) seen[node] = 1;
  std::vector<cutting::NodeId> open;
  for (const cutting::NodeId node : cutting::node_ids(complex))
    if (complex.rest(node).z() > 0.99 * mesh_size) open.push_back(node);
  while (!open.empty()) {
    const cutting::NodeId node = open.back();
    open.pop_back();
    if (complex.rest(node).z() < 0.01 * mesh_size) return false;
    for (const cutting::TetId t : complex.star(node))
      for (const cutting::NodeId next : complex.corners(t))
        if (!marks.find(next) && !std::exchange(seen[next], std::uint8_t{1})) open.push_back(next);
  }
  return true;
}

TEST(CutThrough, WhatIsFoundPartsAndNoneOfItCanBeSpared) {
  const cutting::TetComplex complex(box_mesh(8), mesh_density);
  Random random(test_seed(true));
  for (const double share : {0.05, 0.1, 0.2}) {
    std::size_t left_out = 0;
    const cutting::Marks marks = marks_of(complex, [&](cutting::NodeId) {
      const bool marked = random.uniform(0, 1) > share;
      left_out += marked ? 0 : 1;
      return marked;
    });
    const std::vector<cutting::NodeId> missing = cutting::missing_nodes(complex, marks, left_out);
    EXPECT_EQ(missing.size(), left_out) << share;
    EXPECT_TRUE(part(complex, marks, missing)) << share;
    for (std::size_t k = 0; k < missing.size(); ++k) {
      std::vector<cutting::NodeId> fewer = missing;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_FALSE(part(complex, marks, fewer)) << share;
    }
    EXPECT_TRUE(cutting::missing_nodes(complex, marks, missing.size() - 1).empty()) << share;
  }
}

TEST(CutThrough, WhatIsHalfCutIsNotParted) {
  const cutting::TetComplex complex(box_mesh(cells), mesh_density);
  const cutting::Marks marks =
      marks_of(complex, [&](cutting::NodeId node) { return complex.rest(node).x() < 0.6 * mesh_size; });
  EXPECT_TRUE(cutting::missing_nodes(complex, marks, 4).empty());
  EXPECT_TRUE(cutting::faces_between_parts(complex, marks, 0).faces.empty());
}

TEST(CutThrough, CrumbsStayTogether) {
  const cutting::TetComplex complex(box_mesh(cells), mesh_density);
  const cutting::Marks plane = marks_of(complex, [](cutting::NodeId) { return true; });
  const double more_than_all = 2 * mesh_size * mesh_size * mesh_size;
  EXPECT_FALSE(cutting::faces_between_parts(complex, plane, 0).faces.empty());
  EXPECT_TRUE(cutting::faces_between_parts(complex, plane, more_than_all).faces.empty());
}

std::size_t pieces_after(double deepest, double step_back) {
  cutting::TetComplex complex(box_mesh(2), mesh_density);
  cutting::TetTree tree;
  std::vector<Vec3> x = rest_positions(complex);
  const auto edge = [](double at) {
    return std::vector<Vec3>{{at, -0.5 * mesh_size, 0.52 * mesh_size},
                             {at, 1.5 * mesh_size, 0.52 * mesh_size}};
  };
  constexpr double outside = -0.03, step = 0.004;
  cutting::BladeStroke stroke = cutting::begin_stroke(edge(outside));
  double at = outside;
  for (; at < deepest; at += step) cut_and_carry(complex, tree, x, edge(at), stroke);
  while (step_back > 0 && at > outside) cut_and_carry(complex, tree, x, edge(at -= step_back), stroke);
  return cutting::pieces(complex).size();
}

TEST(CutThrough, AHingeStaysWhereTheBladeIsDrawnBack) {
  EXPECT_EQ(pieces_after(0.07, 0.004), 1U);  // of three nodes
  EXPECT_EQ(pieces_after(0.07, 0.2), 1U);
  EXPECT_EQ(pieces_after(0.13, 0), 2U);
}

/// A blade that is drawn out along its edge in one tick, and cuts a little more meanwhile.
TEST(CutThrough, WhatTheBladeDidNotComeToStays) {
  cutting::TetComplex complex(box_mesh(8), mesh_density);
  cutting::TetTree tree;
  std::vector<Vec3> x = rest_positions(complex);
  const auto edge = [](double at, double up) {
    return std::vector<Vec3>{{at, up - 0.5 * mesh_size, 0.52 * mesh_size},
                             {at, up + 1.5 * mesh_size, 0.52 * mesh_size}};
  };
  cutting::BladeStroke stroke = cutting::begin_stroke(edge(-0.01, 0));
  cut_and_carry(complex, tree, x, edge(0.075, 0), stroke);
  EXPECT_FALSE(stroke.ended_inside);
  const cutting::CutResult out = cut_and_carry(complex, tree, x, edge(0.078, 3 * mesh_size), stroke);
  EXPECT_FALSE(out.ops.empty());
  EXPECT_EQ(cutting::pieces(complex).size(), 1U);
}

}  // namespace
}  // namespace prosector
