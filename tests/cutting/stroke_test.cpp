// Each stroke of the table on each mesh: sound afterwards, the same again, and taken back exactly.

#include <gtest/gtest.h>

#include "server/physics/mechanics/cutting/pieces.h"
#include "tests/cutting/meshes.h"
#include "tests/cutting/soundness.h"
#include "tests/cutting/strokes.h"

namespace prosector {
namespace {

struct Log {
  std::vector<cutting::CutResult> cuts;
  std::vector<std::uint64_t> hashes;  // before each
};

Log make(cutting::TetComplex& complex, const std::vector<Stroke>& strokes) {
  Log log;
  cutting::TetTree tree;
  std::vector<Vec3> x = rest_positions(complex);
  for (const Stroke& stroke : strokes) {
    cutting::BladeStroke state = cutting::begin_stroke(stroke.front());
    for (std::size_t i = 1; i < stroke.size(); ++i) {
      log.hashes.push_back(cutting::content_hash(complex));
      log.cuts.push_back(cut_and_carry(complex, tree, x, stroke[i], state));
    }
  }
  return log;
}

void take_back(cutting::TetComplex& complex, const cutting::CutResult& cut) {
  for (std::size_t i = cut.ops.size(); i-- > 0;) complex.take_back(cut.ops[i]);
}

class Strokes : public ::testing::TestWithParam<NamedMesh> {};

TEST_P(Strokes, LeaveItSound) {
  for (const NamedStrokes& row : strokes_to_make()) {
    SCOPED_TRACE(row.name);
    cutting::TetComplex complex(GetParam().mesh, mesh_density);
    const Whole before = whole(complex);
    const Log log = make(complex, row.strokes);
    EXPECT_TRUE(is_sound(complex, before));
    if (row.box_pieces > 0 && GetParam().name != "tet") {
      EXPECT_EQ(cutting::pieces(complex).size(), row.box_pieces);
    }
  }
}

TEST_P(Strokes, AreTakenBackExactly) {
  for (const NamedStrokes& row : strokes_to_make()) {
    SCOPED_TRACE(row.name);
    cutting::TetComplex complex(GetParam().mesh, mesh_density);
    const Log log = make(complex, row.strokes);
    for (std::size_t i = log.cuts.size(); i-- > 0;) {
      take_back(complex, log.cuts[i]);
      ASSERT_EQ(cutting::content_hash(complex), log.hashes[i]) << "cut " << i;
    }
    EXPECT_EQ(complex.tets(), GetParam().mesh.tets.size());
  }
}

TEST_P(Strokes, AreTheSameWhenReplayed) {
  for (const NamedStrokes& row : strokes_to_make()) {
    SCOPED_TRACE(row.name);
    cutting::TetComplex complex(GetParam().mesh, mesh_density), again(GetParam().mesh, mesh_density),
        replica(GetParam().mesh, mesh_density);
    const Log log = make(complex, row.strokes), second = make(again, row.strokes);
    ASSERT_EQ(log.cuts.size(), second.cuts.size());
    for (std::size_t i = 0; i < log.cuts.size(); ++i) {
      EXPECT_EQ(log.cuts[i].ops, second.cuts[i].ops);
      for (const cutting::TopologyOp& op : log.cuts[i].ops) replica.apply(op);
    }
    EXPECT_EQ(cutting::content_hash(complex), cutting::content_hash(replica));
    EXPECT_EQ(cutting::content_hash(complex), cutting::content_hash(again));
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Strokes, ::testing::ValuesIn(meshes_to_cut()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace prosector
