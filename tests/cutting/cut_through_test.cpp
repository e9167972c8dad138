// What is done when a blade has left the body: what it missed, and what it left on purpose.

#include <gtest/gtest.h>

#include "server/physics/cutting/cut_through.h"
#include "server/physics/cutting/pieces.h"
#include "tests/cutting/meshes.h"
#include "tests/cutting/strokes.h"

namespace prosector {
namespace {

constexpr std::uint32_t cells = 4;
constexpr double middle = mesh_size / 2;

/// Of the box's middle plane, across z, what `chosen` says.
template <class Chosen>
Marks marks_of(const TetComplex& complex, const Chosen& chosen) {
  Marks marks({}, complex.node_end());
  for (const NodeId node : complex.node_ids())
    if (std::abs(complex.rest(node).z() - middle) < 1e-9 && chosen(node))
      marks.add({node, complex.rest(node), Vec3::UnitZ()});
  return marks;
}

TEST(CutThrough, WhatHoldsTheHalvesTogetherIsFound) {
  TetComplex complex(box_mesh(cells), mesh_density);
  for (const NodeId left_out : complex.node_ids()) {
    if (std::abs(complex.rest(left_out).z() - middle) > 1e-9) continue;
    Marks marks = marks_of(complex, [&](NodeId node) { return node != left_out; });
    const std::vector<NodeId> missing = missing_nodes(complex, marks, 2);
    ASSERT_EQ(missing, std::vector<NodeId>{left_out});
    EXPECT_TRUE(faces_between_parts(complex, marks, 0).faces.empty());
    const BladeStroke::Mark mark = mark_between(complex, marks, left_out);
    EXPECT_NEAR(mark.normal.z(), 1, 1e-12);
    marks.add(mark);
    EXPECT_EQ(faces_between_parts(complex, marks, 0).faces.size(), 2 * cells * cells);
  }
}

TEST(CutThrough, WhatIsHalfCutIsNotParted) {
  const TetComplex complex(box_mesh(cells), mesh_density);
  const Marks marks =
      marks_of(complex, [&](NodeId node) { return complex.rest(node).x() < 0.6 * mesh_size; });
  EXPECT_TRUE(missing_nodes(complex, marks, 4).empty());
  EXPECT_TRUE(faces_between_parts(complex, marks, 0).faces.empty());
}

TEST(CutThrough, CrumbsStayTogether) {
  const TetComplex complex(box_mesh(cells), mesh_density);
  const Marks plane = marks_of(complex, [](NodeId) { return true; });
  const double more_than_all = 2 * mesh_size * mesh_size * mesh_size;
  EXPECT_FALSE(faces_between_parts(complex, plane, 0).faces.empty());
  EXPECT_TRUE(faces_between_parts(complex, plane, more_than_all).faces.empty());
}

std::size_t pieces_after(double deepest, bool back) {
  TetComplex complex(box_mesh(2), mesh_density);
  TetTree tree;
  std::vector<Vec3> x = rest_positions(complex);
  const auto edge = [](double at) {
    return std::vector<Vec3>{{at, -0.5 * mesh_size, 0.52 * mesh_size},
                             {at, 1.5 * mesh_size, 0.52 * mesh_size}};
  };
  constexpr double outside = -0.03, step = 0.004;
  BladeStroke stroke = begin_stroke(edge(outside));
  double at = outside;
  for (; at < deepest; at += step) cut_and_carry(complex, tree, x, edge(at), stroke);
  for (; back && at > outside; at -= step) cut_and_carry(complex, tree, x, edge(at), stroke);
  return pieces(complex).size();
}

TEST(CutThrough, AHingeStaysWhereTheBladeIsDrawnBack) {
  EXPECT_EQ(pieces_after(0.07, true), 1U);  // of three nodes
  EXPECT_EQ(pieces_after(0.13, false), 2U);
}

}  // namespace
}  // namespace prosector
