// Tetrahedra that are smaller where a body is touched.

#include "server/physics/mechanics/cutting/local_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>

#include "common/error.h"
#include "tests/cutting/meshes.h"
#include "tests/cutting/soundness.h"
#include "tests/random.h"

namespace prosector {
namespace {

constexpr double edge = 0.02, reach = 0.015;  // m
constexpr std::uint32_t linger = 6;           // ticks

cutting::RefinementLimits limits(std::size_t most = 100'000) {
  return {edge, reach, most, linger};
}

cutting::TouchedPlaces at(std::vector<Vec3> points) {
  return {std::move(points), edge / 8};
}

double longest_edge_of(const cutting::TetComplex& complex, cutting::TetId tet) {
  double longest = 0;
  for (const cutting::NodeId a : complex.corners(tet))
    for (const cutting::NodeId b : complex.corners(tet))
      longest = std::max(longest, (complex.rest(a) - complex.rest(b)).norm());
  return longest;
}

bool has_box_near(const cutting::TetComplex& complex, cutting::TetId tet, const Vec3& point) {
  Vec3 low = complex.rest(complex.corners(tet)[0]), high = low;
  for (const cutting::NodeId node : complex.corners(tet)) {
    low = low.cwiseMin(complex.rest(node));
    high = high.cwiseMax(complex.rest(node));
  }
  return (point - point.cwiseMax(low).cwiseMin(high)).norm() < reach;
}

/// Follows until nothing more is done.
void settle(cutting::LocalRefinement& mesh, const cutting::TouchedPlaces& touched) {
  for (int tick = 0; tick < 100 && !mesh.follow(touched, false, false).empty(); ++tick) {
  }
}

TEST(LocalRefinement, IsFineWhereTouchedAndCoarseElsewhere) {
  for (const NamedMesh& named : meshes_to_cut()) {
    SCOPED_TRACE(named.name);
    cutting::LocalRefinement mesh(named.mesh, mesh_density, limits());
    const Whole before = whole(mesh.complex());
    const Vec3 point = named.mesh.positions[named.mesh.tets[0][0]];
    settle(mesh, at({point}));
    EXPECT_TRUE(is_sound(mesh.complex(), before));
    std::size_t near_it = 0, untouched = 0;
    for (const cutting::TetId tet : cutting::tet_ids(mesh.complex())) {
      if (has_box_near(mesh.complex(), tet, point)) {
        ++near_it;
        EXPECT_LE(longest_edge_of(mesh.complex(), tet), edge);
      }
      untouched += tet < named.mesh.tets.size();
    }
    EXPECT_GT(near_it, 0u);
    if (named.mesh.tets.size() > 100) {
      EXPECT_GT(untouched, named.mesh.tets.size() / 4);
    }
  }
}

TEST(LocalRefinement, GoesASecondAfterAndLeavesNoTrace) {
  cutting::LocalRefinement mesh(ball_mesh(0.02), mesh_density, limits());
  const std::uint64_t before = cutting::content_hash(mesh.complex());
  const Vec3 point = mesh.complex().rest(0);
  settle(mesh, at({point}));
  ASSERT_TRUE(mesh.any());
  EXPECT_NE(cutting::content_hash(mesh.complex()), before);
  EXPECT_TRUE(mesh.follow({}, true, true).empty());  // it rests under what touches it
  for (std::uint32_t tick = 1; tick < linger; ++tick) EXPECT_TRUE(mesh.follow({}, false, true).empty());
  EXPECT_TRUE(mesh.follow({}, false, false).empty());
  EXPECT_FALSE(mesh.follow({}, false, true).empty());
  EXPECT_FALSE(mesh.any());
  EXPECT_EQ(cutting::content_hash(mesh.complex()), before);
}

TEST(LocalRefinement, WhatStaysTouchedStays) {
  cutting::LocalRefinement mesh(ball_mesh(0.02), mesh_density, limits());
  const cutting::TouchedPlaces touched = at({mesh.complex().rest(0)});
  settle(mesh, touched);
  for (std::uint32_t tick = 0; tick < 3 * linger; ++tick)
    EXPECT_TRUE(mesh.follow(touched, false, true).empty());
}

// Of ids only the order counts: one that was read goes on as the one that was written.
TEST(LocalRefinement, RandomTouchingKeepsAllSoundAndGoesOnAlike) {
  const std::vector<NamedMesh> meshes = meshes_to_cut();
  for (const NamedMesh& named : meshes) {
    SCOPED_TRACE(named.name);
    Random random(test_seed(true));
    cutting::LocalRefinement mesh(named.mesh, mesh_density, limits());
    std::optional<cutting::LocalRefinement> read;
    const Whole before = whole(mesh.complex());
    const std::uint64_t hash = cutting::content_hash(mesh.complex());
    Vec3 finger = Vec3::Constant(mesh_size / 2);
    std::size_t made = 0, taken_back = 0;
    for (int tick = 0; tick < 160; ++tick) {
      finger += random.point(0.012);
      finger = finger.cwiseMax(0).cwiseMin(mesh_size);
      const bool lifted = tick / 20 % 3 == 2;
      const cutting::TouchedPlaces touched =
          lifted ? cutting::TouchedPlaces() : at({finger, finger + random.point(0.01)});
      for (const cutting::RefinementStep& step : mesh.follow(touched, false, tick % 3 == 0))
        ++(step.made ? made : taken_back);
      if (read) read->follow(touched, false, tick % 3 == 0);
      if (tick == 50) read.emplace(mesh.compacted(named.mesh));
      if (tick % 20 == 0) {
        ASSERT_TRUE(is_sound(mesh.complex(), before));
      }
      if (read) {
        ASSERT_EQ(mesh.edges(), read->edges());
        ASSERT_EQ(mesh.added(), read->added());
      }
    }
    EXPECT_GT(made, 0u);
    EXPECT_GT(taken_back, 0u);
    mesh.take_back();
    EXPECT_FALSE(mesh.any());
    EXPECT_EQ(cutting::content_hash(mesh.complex()), hash);
  }
}

TEST(LocalRefinement, AddsNoMoreThanItMay) {
  constexpr std::size_t most = 60;
  cutting::LocalRefinement mesh(ball_mesh(0.02), mesh_density, limits(most));
  Random random(3);
  for (int tick = 0; tick < 40; ++tick) {
    mesh.follow(at({Vec3::Constant(mesh_size / 2) + random.point(mesh_size / 2)}), false, true);
    EXPECT_LE(mesh.added(), most);
  }
  EXPECT_GT(mesh.added(), most / 2);
}

TEST(LocalRefinement, WhatIsTouchedNowTakesTheRoomOfWhatWas) {
  cutting::LocalRefinement all(ball_mesh(0.02), mesh_density, limits());
  const Vec3 first = all.complex().rest(0);
  settle(all, at({first}));
  cutting::LocalRefinement mesh(ball_mesh(0.02), mesh_density, limits(all.added() + all.added() / 4));
  settle(mesh, at({first}));
  EXPECT_EQ(mesh.added(), all.added());
  Vec3 second = first;  // the farthest node
  for (const cutting::NodeId node : cutting::node_ids(mesh.complex()))
    if ((mesh.complex().rest(node) - first).norm() > (second - first).norm())
      second = mesh.complex().rest(node);
  settle(mesh, at({second}));
  for (const cutting::TetId tet : cutting::tet_ids(mesh.complex()))
    EXPECT_FALSE(has_box_near(mesh.complex(), tet, first) && longest_edge_of(mesh.complex(), tet) < edge / 2);
  EXPECT_TRUE(std::ranges::any_of(cutting::tet_ids(mesh.complex()), [&](cutting::TetId tet) {
    return has_box_near(mesh.complex(), tet, second) && longest_edge_of(mesh.complex(), tet) <= edge;
  }));
}

TEST(LocalRefinement, EdgesThatAreNotThereAreRefused) {
  const TetMesh rest = ball_mesh(0.02);
  cutting::LocalRefinement mesh(rest, mesh_density, limits());
  settle(mesh, at({mesh.complex().rest(0)}));
  const std::vector<cutting::RefinedEdge> good = mesh.edges();
  std::mt19937_64 random(1);
  int refused = 0;
  for (int i = 0; i < 100; ++i) {
    std::vector<cutting::RefinedEdge> bad = good;
    cutting::RefinedEdge& edge = bad[random() % bad.size()];
    for (std::uint32_t* number : {&edge.a, &edge.b, &edge.left})
      if (random() % 2 == 0) *number ^= 1u << (random() % 32);
    cutting::LocalRefinement other = mesh.unrefined(rest);
    try {
      other.bisect(bad);
      other.take_back();
      EXPECT_EQ(other.added(), 0u);  // whatever was split
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace prosector
