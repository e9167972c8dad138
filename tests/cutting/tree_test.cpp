// The tree that a blade asks for tetrahedra takes in what was split: what it answers is what one built anew
// would.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cutting/meshes.h"
#include "tests/cutting/strokes.h"

namespace prosector {
namespace {

std::vector<cutting::TetId> sorted(std::vector<cutting::TetId> tets) {
  std::sort(tets.begin(), tets.end());
  return tets;
}

class Trees : public ::testing::TestWithParam<NamedMesh> {};

TEST_P(Trees, FollowCutsAndWhatIsTakenBack) {
  std::size_t found = 0;
  for (const NamedStrokes& row : strokes_to_make()) {
    SCOPED_TRACE(row.name);
    cutting::TetComplex complex(GetParam().mesh, mesh_density);
    cutting::TetTree tree, followed;
    std::vector<Vec3> x = rest_positions(complex);
    const auto answers_as_rebuilt = [&](const std::vector<Vec3>& edge, const std::vector<Vec3>& next) {
      const Vec3 low = Vec3::Constant(-1), high = Vec3::Constant(1);  // m: all of the mesh
      cutting::TetTree rebuilt;
      rebuilt.update(complex, x, low, high);
      followed.update(complex, x, low, high);
      const std::vector<std::size_t> one_part(edge.size(), 0);
      for (const cutting::SweptSurface sheet(edge, next, one_part);
           const cutting::SweptSurface::Piece& piece : sheet.pieces()) {
        std::vector<cutting::TetId> a, b;
        followed.query(piece, a);
        rebuilt.query(piece, b);
        EXPECT_EQ(sorted(a), sorted(b));
        found += a.size();
      }
      for (cutting::NodeId node = 0; node < complex.node_end(); node += 7) {
        std::vector<cutting::TetId> a, b;
        followed.query(x[node], x[node], a);
        rebuilt.query(x[node], x[node], b);
        EXPECT_EQ(sorted(a), sorted(b));
        found += a.size();
      }
    };
    std::vector<cutting::CutResult> cuts;
    for (const Stroke& stroke : row.strokes) {
      cutting::BladeStroke state = cutting::begin_stroke(stroke.front());
      for (std::size_t i = 1; i < stroke.size(); ++i) {
        cuts.push_back(cut_and_carry(complex, tree, x, stroke[i], state));
        if (!cuts.back().ops.empty()) answers_as_rebuilt(stroke[i - 1], stroke[i]);
      }
    }
    if (cuts.empty()) continue;
    const Stroke& last = row.strokes.back();
    for (std::size_t k = cuts.back().ops.size(); k-- > 0;) complex.take_back(cuts.back().ops[k]);
    answers_as_rebuilt(last.front(), last.back());
  }
  EXPECT_GT(found, 0U);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Trees, ::testing::ValuesIn(meshes_to_cut()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace prosector
