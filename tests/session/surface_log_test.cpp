// From anatomies that change to slots, patches and points: what clients are told is what the server has.

#include "server/session/sending/surface_log.h"

#include <gtest/gtest.h>

#include "server/session/sending/soft_sender.h"
#include "tests/physics/scenes.h"
#include "tests/session/random_cuts.h"

namespace prosector {
namespace {

using test::CutBody;

/// The surface that a client draws, its points where the server's sources put them.
test::Facets drawn_by(const DrawnSurface& client, const SurfaceLog& log, const VecX& x) {
  const SurfaceStream& stream = *log.stream();
  VecX points = VecX::Zero(3 * std::max<Eigen::Index>(1, stream.points));
  for (std::uint32_t i = 0; i < stream.points; ++i)
    if (stream.carriers[i] != ~0u) points.segment<3>(3 * i) = stream.sources.apply(i, x.data());
  return test::facets(client.rest.triangles, [&](std::uint32_t v) -> Eigen::Vector3f {
    return client.streamed.map.apply(v, points.data()).cast<float>();
  });
}

TEST(SurfaceLog, PatchesTakeAClientToWhateverTheBodyBecame) {
  std::mt19937_64 random(21);
  for (int round = 0; round < 4; ++round) {
    CutBody body(test::make_block({0.1, 0.1, 0.1}, {3, 3, 3}), 5);
    SurfaceLog log(body.anatomy, body.numbering, body.change, {0, 1});
    DrawnSurface client = log.surface();
    EXPECT_EQ(log.newest().surface_hash, hash(client));
    for (int n = 0; n < 60; ++n) {
      const std::uint64_t before = log.newest().chain_hash;
      const std::size_t points = client.streamed.rest.size();
      body.cut(random, 0.05 * n);
      log.follow(body.anatomy, body.numbering, body.x, body.change, {0, 2});
      const TopologyRevision& revision = log.newest();
      ASSERT_EQ(revision.previous_hash, before);
      ASSERT_EQ(revision.chain_hash, chain_hash_of(revision));
      apply(revision.patch, client);
      ASSERT_EQ(hash(client), revision.surface_hash) << "revision " << revision.revision;
      ASSERT_LT(test::largest_difference(drawn_by(client, log, body.x), test::facets_of(body)), 1e-6f);
      for (std::size_t i = 0; i < revision.patch.points.size(); ++i)
        EXPECT_LT((log.stream()->sources.apply(points + i, body.x.data()).cast<float>() -
                   revision.patch.points[i].now)
                      .norm(),
                  1e-6f);
      EXPECT_LT(revision.patch.triangles.size(), 12u) << "a small cut is a small patch";
    }
    EXPECT_TRUE(std::ranges::any_of(client.rest.inner, [](auto flag) { return flag != 0; }));
    const auto [mesh, map] = log.keyframe();
    EXPECT_EQ(hash({decode_triangle_mesh(mesh.bytes), decode_streamed_surface(map.bytes)}),
              log.newest().surface_hash);
  }
}

TEST(SurfaceLog, WhatComesBackComesBackToItsSlot) {
  std::mt19937_64 random(22);
  CutBody body(test::make_block({0.1, 0.1, 0.1}, {3, 3, 3}), 5);
  SurfaceLog log(body.anatomy, body.numbering, body.change, {0, 1});
  const std::uint64_t whole = log.newest().surface_hash;
  CutBody cut = body;
  cut.cut(random, 0);
  log.follow(cut.anatomy, cut.numbering, cut.x, cut.change, {0, 2});
  EXPECT_NE(log.newest().surface_hash, whole);
  const DrawnSurface parted = log.surface();
  body.change.revision = 2;
  body.change.cause = TopologyCause::undo;
  log.follow(body.anatomy, body.numbering, body.x, body.change, {0, 3});
  EXPECT_EQ(log.surface().rest.triangles.size(), parted.rest.triangles.size()) << "slots are never given up";
  EXPECT_LT(test::largest_difference(drawn_by(log.surface(), log, body.x), test::facets_of(body)), 1e-6f);
  EXPECT_EQ(log.newest().patch.points.size(), 0u);
}

/// A triangle on the edges of the first tetrahedron, whose nodes follow the vertices and have no numbers.
CutBody with_edge_nodes(CutBody body) {
  const auto tet = body.anatomy.tets.tets[0];
  std::array<std::uint32_t, 3> corners{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 middle = 0.5 * (body.anatomy.tets.positions[tet[k]] + body.anatomy.tets.positions[tet[k + 1]]);
    body.anatomy.tets.positions.push_back(middle);
    const auto node = static_cast<std::uint32_t>(body.anatomy.tets.positions.size() - 1);
    corners[k] = body.new_vertex({{node}, {1}}, middle);
  }
  body.anatomy.surface.inner.resize(body.anatomy.surface.triangles.size(), 0);
  body.new_triangle(corners);
  body.move(0);
  return body;
}

TEST(SurfaceLog, NodesOnEdgesKeepTheirSlotsWithoutNumbers) {
  const CutBody corners(test::make_block({0.1, 0.1, 0.1}, {2, 2, 2}), 5);
  CutBody body = with_edge_nodes(corners);
  SurfaceLog log(body.anatomy, body.numbering, body.change, {0, 1});
  const std::uint32_t points = log.stream()->points;
  CutBody cut = corners;  // a vertex more, so the nodes on edges have other indices
  const std::uint32_t node = cut.new_node({0.01, 0.02, 0.03});
  cut.anatomy.tets.tets.push_back(cut.anatomy.tets.tets[0]);
  cut.anatomy.tets.tets.back()[3] = node;
  cut = with_edge_nodes(cut);
  cut.change.revision = 1;
  log.follow(cut.anatomy, cut.numbering, cut.x, cut.change, {0, 2});
  EXPECT_EQ(log.stream()->points, points);  // nothing hangs on the new vertex
  EXPECT_TRUE(log.newest().patch.points.empty());
  EXPECT_LT(test::largest_difference(drawn_by(log.surface(), log, cut.x), test::facets_of(cut)), 1e-6f);
}

TEST(SurfaceLog, ASessionThatGoesOnAfterABodyBecameNothingStillHasAPointOfIt) {
  CutBody body(test::make_block({0.1, 0.1, 0.1}, {1, 1, 1}), 5);
  body.anatomy.surface = {};
  body.anatomy.embedding = {};
  const SurfaceLog log(body.anatomy, {}, body.change, {0, 1});
  EXPECT_EQ(log.stream()->points, 1u);  // SceneBody::points is at least that
  EXPECT_TRUE(drawn_by(log.surface(), log, body.x).empty());
}

TEST(SurfaceLog, OfABodyThatBecameNothingNothingIsDrawn) {
  CutBody body(test::make_block({0.1, 0.1, 0.1}, {2, 2, 2}), 5);
  SurfaceLog log(body.anatomy, body.numbering, body.change, {0, 1});
  body.anatomy.surface.inner.resize(body.anatomy.surface.triangles.size(), 0);
  body.vanish();
  log.follow(body.anatomy, body.numbering, body.x, body.change, {0, 2});
  EXPECT_TRUE(drawn_by(log.surface(), log, body.x).empty());
  SoftSender sender(5, 60);
  std::vector<Message> out;
  const auto x = std::make_shared<VecX>(body.x);
  sender.update({5, false, 1, x, x, log.stream()}, {0, 2}, true, out);
  ASSERT_FALSE(out.empty());
  for (const Vec3& shift : std::get<SoftState>(out[0]).positions) EXPECT_EQ(shift, Vec3(Vec3::Zero()));
}

TEST(SoftSender, SendsNewPointsAtOnceAndKeepsTheBoxOfThoseThatAreGoneSmall) {
  std::mt19937_64 random(23);
  CutBody body(test::make_block({0.1, 0.1, 0.1}, {5, 5, 5}), 0);
  SurfaceLog log(body.anatomy, body.numbering, body.change, {0, 1});
  SoftSender sender(0, 60);
  const auto step = [&](std::uint64_t tick) {
    std::vector<Message> out;
    sender.update({0, false, log.newest().revision, std::make_shared<VecX>(body.x),
                   std::make_shared<VecX>(VecX::Zero(body.x.size())), log.stream()},
                  {0, tick}, false, out);
    return out;
  };
  step(1);
  std::uint32_t sent = log.stream()->points;
  for (std::uint64_t tick = 2; tick < 80; ++tick) {
    body.cut(random, 0);
    log.follow(body.anatomy, body.numbering, body.x, body.change, {0, tick});
    std::uint32_t end = 0;
    for (const Message& message : step(tick)) {
      const auto& state = std::get<SoftState>(message);
      EXPECT_EQ(state.revision, log.newest().revision);
      end = std::max(end, state.first_point + static_cast<std::uint32_t>(state.positions.size()));
      for (const Vec3& shift : state.positions) EXPECT_LT(shift.norm(), 0.03);  // all points do within 0.02 m
    }
    if (log.stream()->points > sent) {
      EXPECT_EQ(end, log.stream()->points);
    }
    sent = log.stream()->points;
  }
  EXPECT_FALSE(log.stream()->leaders.empty()) << "no point has gone: the test says nothing of those";
}

}  // namespace
}  // namespace prosector
