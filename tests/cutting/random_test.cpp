// Strokes at random, one after another in the same body, which is bent, squeezed and in places inside out.
// Of a fixed seed, and more of a new one each time, which is printed; with sanitizers, which take ten times
// as long, fewer. PROSECTOR_STROKES says how many instead, PROSECTOR_SEED which.

#include <gtest/gtest.h>

#include <iostream>
#include <utility>

#include "server/physics/mechanics/cutting/pieces.h"
#include "tests/cutting/meshes.h"
#include "tests/cutting/soundness.h"
#include "tests/cutting/strokes.h"
#include "tests/random.h"

namespace prosector {
namespace {

Vec3 in_mesh(Random& random, double reach) {
  return Vec3::Constant(mesh_size / 2) + random.point(mesh_size * reach);
}

// One to twelve ticks with an edge of two to five points that wanders; every tenth over 1e-6 m only.
Stroke random_stroke(Random& random) {
  const std::size_t points = 2 + random.below(4), ticks = 1 + random.below(12);
  const Vec3 a = in_mesh(random, 0.9), b = in_mesh(random, 0.9);
  Vec3 way = (in_mesh(random, 0.9) - in_mesh(random, 0.9)) / static_cast<double>(ticks);
  if (random.below(10) == 0) way *= 1e-6 / way.norm();
  std::vector<Vec3> edge;
  for (std::size_t i = 0; i < points; ++i)
    edge.push_back(a + (b - a) * static_cast<double>(i) / static_cast<double>(points - 1));
  Stroke stroke = {edge};
  for (std::size_t i = 0; i < ticks; ++i) {
    for (Vec3& x : edge) x += way + 0.1 * way.norm() / mesh_size * random.point(mesh_size);
    stroke.push_back(edge);
  }
  return stroke;
}

void knead(std::vector<Vec3>& x, const cutting::TetComplex& complex, Random& random) {
  const double bend = random.uniform(-8, 8), squeeze = random.uniform(0.3, 1.2),
               push = random.uniform(-0.04, 0.04);
  const Vec3 hit = in_mesh(random, 0.5);
  for (cutting::NodeId i = 0; i < x.size(); ++i) {
    const Vec3& r = complex.rest(i);
    x[i] = {r[0], squeeze * r[1] + bend * r[0] * r[0], r[2]};
    if ((r - hit).norm() < 0.03)
      x[i][0] += push;  // farther than the elements are long: turns some inside out
  }
}

/// As many as the gate has time for of a fixed seed, and as many as pay in the nightly run of a new one.
unsigned default_strokes(bool fixed_seed) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return fixed_seed ? 100 : 200;
#else
  return fixed_seed ? 300 : 1000;
#endif
}

constexpr unsigned close_look = 100;  // strokes; a look costs more the more there is

/// Whether all is looked at after this stroke.
bool is_sample(unsigned stroke, unsigned strokes) {
  return stroke < 20 || stroke % (stroke < close_look ? 10 : 50) == 9 || stroke + 1 == strokes;
}

struct Case {
  std::string mesh;
  bool fixed_seed = true;
};

class RandomStrokes : public ::testing::TestWithParam<Case> {};

TEST_P(RandomStrokes, LeaveTheMeshSoundAndCanBeTakenBack) {
  const unsigned strokes = number("PROSECTOR_STROKES", default_strokes(GetParam().fixed_seed));
  const unsigned seed = test_seed(GetParam().fixed_seed);
  std::cout << "PROSECTOR_STROKES=" << strokes << std::endl;
  const TetMesh mesh = GetParam().mesh == "box"    ? box_mesh(3)
                       : GetParam().mesh == "ball" ? ball_mesh(0.025)
                                                   : single_tet();
  Random random(seed);
  cutting::TetComplex complex(mesh, mesh_density);
  const Whole before = whole(complex);
  cutting::TetTree tree;
  std::vector<Vec3> x = rest_positions(complex);
  struct Cut {
    std::uint64_t hash_before = 0;
    std::vector<cutting::TopologyOp> ops;
    bool is_hashed = false;  // each of the first strokes' cuts, and each later stroke's first
  };
  std::vector<Cut> log;
  for (unsigned i = 0; i < strokes; ++i) {
    const Stroke stroke = random_stroke(random);
    cutting::BladeStroke state = cutting::begin_stroke(stroke.front());
    bool begins = true;
    std::uint64_t hash = cutting::content_hash(complex);
    for (std::size_t tick = 1; tick < stroke.size(); ++tick) {
      if (random.below(2) == 0) knead(x, complex, random);
      if (i < close_look) hash = cutting::content_hash(complex);
      cutting::CutResult result = cut_and_carry(complex, tree, x, stroke[tick], state);
      if (result.ops.empty()) continue;
      const bool first = std::exchange(begins, false);
      log.push_back({hash, std::move(result.ops), first || i < close_look});
    }
    if (is_sample(i, strokes)) {
      ASSERT_TRUE(is_sound(complex, before)) << "after stroke " << i;
    }
  }
  RecordProperty("tets", static_cast<int>(complex.tets()));
  RecordProperty("pieces", static_cast<int>(cutting::pieces(complex).size()));
  for (std::size_t i = log.size(); i-- > 0;) {
    for (std::size_t k = log[i].ops.size(); k-- > 0;) complex.take_back(log[i].ops[k]);
    if (!log[i].is_hashed) continue;
    ASSERT_EQ(cutting::content_hash(complex), log[i].hash_before) << "cut " << i << " taken back";
  }
  EXPECT_EQ(complex.tets(), mesh.tets.size());
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomStrokes,
                         ::testing::Values(Case{"box"}, Case{"ball"}, Case{"tet"}, Case{"box", false},
                                           Case{"ball", false}, Case{"tet", false}),
                         [](const auto& info) {
                           return info.param.mesh + (info.param.fixed_seed ? "_fixed" : "_any");
                         });

}  // namespace
}  // namespace prosector
