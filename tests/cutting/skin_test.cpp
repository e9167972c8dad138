// The surface that is drawn and touched stays closed, changes by its patches, comes back when a cut is taken
// back, and is the same whether it looks everywhere or follows.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "server/physics/mechanics/cutting/skin.h"
#include "server/physics/mechanics/cutting/touched.h"
#include "tests/cutting/meshes.h"
#include "tests/cutting/soundness.h"
#include "tests/cutting/strokes.h"

namespace prosector {
namespace {

bool is_live(const cutting::Skin::Triangle& t) {
  return t.corners[0] != t.corners[1];
}

// Every edge belongs to two triangles that run along it in opposite directions.
::testing::AssertionResult is_closed(const cutting::Skin& skin) {
  std::map<std::array<std::uint32_t, 2>, int> directed;
  for (const auto& t : skin.triangles()) {
    if (!is_live(t)) continue;
    for (std::size_t i = 0; i < 3; ++i) ++directed[{t.corners[i], t.corners[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : directed) {
    const auto back = directed.find({edge[1], edge[0]});
    if (count != 1 || back == directed.end())
      return ::testing::AssertionFailure()
             << "edge " << edge[0] << "-" << edge[1] << " has " << count << " triangles one way";
  }
  return ::testing::AssertionSuccess();
}

Vec3 at(const cutting::Skin& skin, const cutting::TetComplex& complex, std::uint32_t vertex) {
  const auto& v = skin.vertices()[vertex];
  Vec3 x = Vec3::Zero();
  for (std::size_t k = 0; k < 4; ++k)
    if (v.weight[k] != 0) x += v.weight[k] * complex.rest(v.node[k]);
  return x;
}

// By the divergence theorem.
double enclosed(const cutting::Skin& skin, const cutting::TetComplex& complex) {
  double volume = 0;
  for (const auto& t : skin.triangles())
    if (is_live(t))
      volume += at(skin, complex, t.corners[0])
                    .dot(at(skin, complex, t.corners[1]).cross(at(skin, complex, t.corners[2]))) /
                6;
  return volume;
}

struct Replica {
  std::vector<cutting::Skin::Vertex> vertices;
  std::vector<cutting::Skin::Triangle> triangles;
  void apply(const cutting::Skin::Change& change) {
    ASSERT_EQ(change.first_vertex, vertices.size());
    vertices.insert(vertices.end(), change.vertices.begin(), change.vertices.end());
    for (std::size_t i = 0; i < change.slots.size(); ++i) {
      if (change.slots[i] >= triangles.size()) triangles.resize(change.slots[i] + 1u);
      triangles[change.slots[i]] = change.triangles[i];
    }
  }
};

std::vector<cutting::Skin::Triangle> live(const cutting::Skin& skin) {
  std::vector<cutting::Skin::Triangle> out(skin.triangles().begin(), skin.triangles().end());
  while (!out.empty() && !is_live(out.back())) out.pop_back();
  return out;
}

::testing::AssertionResult same(const cutting::Skin& followed, const cutting::Skin::Change& a,
                                const cutting::Skin& updated, const cutting::Skin::Change& b) {
  if (!std::ranges::equal(followed.vertices(), updated.vertices()) ||
      !std::ranges::equal(followed.triangles(), updated.triangles()))
    return ::testing::AssertionFailure() << "another skin";
  for (std::uint32_t slot = 0; slot < followed.triangles().size(); ++slot)
    if (followed.tet(slot) != updated.tet(slot))
      return ::testing::AssertionFailure() << "slot " << slot << " is another tetrahedron's";
  if (a.first_vertex != b.first_vertex || a.vertices != b.vertices || a.slots != b.slots ||
      a.triangles != b.triangles)
    return ::testing::AssertionFailure() << "another change";
  return ::testing::AssertionSuccess();
}

class Skins : public ::testing::TestWithParam<NamedMesh> {};

TEST_P(Skins, StayClosedAndComeBack) {
  for (const NamedStrokes& row : strokes_to_make()) {
    SCOPED_TRACE(row.name);
    cutting::TetComplex complex(GetParam().mesh, mesh_density);
    cutting::Skin skin(complex, std::make_shared<const cutting::OuterShape>(complex, GetParam().surface)),
        updated = skin;
    const bool is_boundary = GetParam().surface.triangles.empty();
    const double volume = is_boundary ? whole(complex).volume : enclosed(skin, complex);
    Replica replica;
    replica.vertices.assign(skin.vertices().begin(), skin.vertices().end());
    replica.triangles.assign(skin.triangles().begin(), skin.triangles().end());
    cutting::TetTree tree;
    std::vector<Vec3> x = rest_positions(complex);
    std::vector<cutting::CutResult> cuts;
    std::vector<std::vector<cutting::TetId>> touched;
    std::vector<std::vector<cutting::Skin::Triangle>> before;
    for (const Stroke& stroke : row.strokes) {
      cutting::BladeStroke state = cutting::begin_stroke(stroke.front());
      for (std::size_t i = 1; i < stroke.size(); ++i) {
        before.push_back(live(skin));
        cuts.push_back(cut_and_carry(complex, tree, x, stroke[i], state));
        touched.push_back(cutting::touched_by(complex, cuts.back().ops));
        const cutting::Skin::Change change = skin.follow(complex, touched.back());
        replica.apply(change);
        ASSERT_TRUE(is_closed(skin)) << "tick " << i;
        ASSERT_TRUE(same(skin, change, updated, updated.update(complex))) << "tick " << i;
      }
    }
    EXPECT_NEAR(enclosed(skin, complex), volume, (is_boundary ? 1e-12 : 2e-3) * volume);
    EXPECT_TRUE(std::equal(replica.vertices.begin(), replica.vertices.end(), skin.vertices().begin(),
                           skin.vertices().end()));
    EXPECT_TRUE(std::equal(replica.triangles.begin(), replica.triangles.end(), skin.triangles().begin(),
                           skin.triangles().end()));
    for (std::size_t i = cuts.size(); i-- > 0;) {
      for (std::size_t k = cuts[i].ops.size(); k-- > 0;) complex.take_back(cuts[i].ops[k]);
      const cutting::Skin::Change change = skin.follow(complex, touched[i]);
      ASSERT_EQ(live(skin), before[i]) << "cut " << i << " taken back";
      ASSERT_TRUE(same(skin, change, updated, updated.update(complex))) << "cut " << i << " taken back";
    }
  }
}

// A cut right through a box lays bare twice its section.
TEST(Skin, KnowsWhatACutLaidBare) {
  cutting::TetComplex complex(box_mesh(4), mesh_density);
  cutting::Skin skin(complex);
  cutting::TetTree tree;
  std::vector<Vec3> x = rest_positions(complex);
  const Stroke stroke = across({0.5, 0.57, 0.5}, {0, 1, 0}, 1);
  cutting::BladeStroke state = cutting::begin_stroke(stroke[0]);
  cut_and_carry(complex, tree, x, stroke[1], state);
  skin.update(complex);
  double inner = 0, outer = 0;
  for (const auto& t : skin.triangles()) {
    if (!is_live(t)) continue;
    const Vec3 a = at(skin, complex, t.corners[0]);
    (t.inner ? inner : outer) +=
        (at(skin, complex, t.corners[1]) - a).cross(at(skin, complex, t.corners[2]) - a).norm() / 2;
  }
  EXPECT_NEAR(inner, 2 * mesh_size * mesh_size, 1e-9);
  EXPECT_NEAR(outer, 6 * mesh_size * mesh_size, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Skins, ::testing::ValuesIn(meshes_to_cut()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace prosector
