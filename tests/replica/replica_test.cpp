#include "client/replica/server_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "client/replica/shown_names.h"
#include "common/asset.h"
#include "common/server_run.h"
#include "common/surface_patch.h"

namespace prosector {
namespace {

constexpr double rate = 60, dt = 1 / rate;

TEST(Hermite, ReproducesUniformAcceleration) {
  const auto x = [](double t) { return Vec3(0, -4.905 * t * t, 0); };
  const auto v = [](double t) { return Vec3(0, -9.81 * t, 0); };
  for (double s = 0; s <= 1; s += 0.125)
    EXPECT_LT((hermite(x(0), v(0), x(dt), v(dt), dt, s) - x(s * dt)).norm(), 1e-15);
}

RigidState rigid_at(const SimTime& time, BodyId body = 0) {
  RigidState out;
  out.body = body;
  out.time = time;
  return out;
}

TEST(Track, HoldsThroughAGapThatMeansRest) {
  Track<RigidState> track;
  track.add(rigid_at({0, 10}));
  track.add(rigid_at({0, 100}));
  EXPECT_EQ(track.at(50, dt).from, track.at(50, dt).to);
  const auto b = track.at(98, dt);
  EXPECT_NE(b.from, b.to);
  EXPECT_NEAR(b.share, 0.5, 1e-12);
  EXPECT_EQ(track.at(1000, dt).to->time.tick, 100u);
}

TEST(Track, SortsLateSamplesAndDropsOldEpochs) {
  Track<RigidState> track;
  track.add(rigid_at({1, 5}));
  track.add(rigid_at({1, 3}));
  track.add(rigid_at({0, 9}));
  EXPECT_EQ(track.newest().time.tick, 5u);
  EXPECT_EQ(track.at(3.5, dt).from->time.tick, 3u);
}

// A tetrahedron of four streamed points carrying a one-triangle surface.
struct SmallScene {
  TriangleMesh surface{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  SparseMap map{{{{0, 1, 2, 3}, {1, 0, 0, 0}}, {{0, 1, 2, 3}, {0, 1, 0, 0}}, {{0, 1, 2, 3}, {0, 0, 1, 0}}}};
  std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Asset mesh_asset = encode(surface), map_asset = encode(StreamedSurface{points, map});

  SceneInfo scene() const {
    SceneBody body;
    body.name = "organ";
    body.kind = BodyKind::soft;
    body.mesh = mesh_asset.hash;
    body.map = map_asset.hash;
    body.points = 4;
    body.chunk_points = 3;
    SceneInfo out;
    out.bodies.push_back(body);
    return out;
  }
  TopologyRevision first() const {
    TopologyRevision out;
    out.mesh = mesh_asset.hash;
    out.map = map_asset.hash;
    out.surface_hash = hash(rounded(surface, {points, map}));
    out.chain_hash = chain_hash_of(out);
    return out;
  }
  static AssetChunk chunk(const Asset& a) {
    return {a.hash, 0, 1, static_cast<std::uint32_t>(a.bytes.size()), a.bytes};
  }
  SoftState soft(std::uint32_t chunk, std::uint64_t tick, const Vec3& offset) const {
    SoftState s;
    s.chunk = chunk;
    s.time = {0, tick};
    s.first_point = chunk * 3;
    for (std::uint32_t i = s.first_point; i < std::min(4u, s.first_point + 3); ++i)
      s.positions.push_back(offset);
    s.velocities.assign(s.positions.size(), Vec3::Zero());
    return s;
  }
};

void feed(Replica& replica, const Message& message, std::int64_t arrival_ns = 1) {
  replica.apply({message, Liveness::alive, 1, arrival_ns});
}

void feed(ServerChoice& choice, std::uint64_t writer, const Message& message) {
  choice.apply({message, Liveness::alive, writer, 1});
}

SessionInfo session(std::uint64_t run = 1) {
  SessionInfo s;
  s.session = "test";
  s.server_run = run;
  return s;
}

TEST(Replica, IsCompleteOnlyWithSceneMeshesTopologyAndState) {
  const SmallScene s;
  Replica replica;
  const std::vector<Message> all = {s.soft(0, 1, Vec3::Zero()),
                                    SmallScene::chunk(s.map_asset),
                                    session(),
                                    s.scene(),
                                    SmallScene::chunk(s.mesh_asset),
                                    s.first(),
                                    s.soft(1, 1, Vec3::Zero())};
  for (const Message& m : all) {
    EXPECT_FALSE(replica.complete());
    EXPECT_FALSE(replica.missing().empty());
    feed(replica, m);
  }
  EXPECT_TRUE(replica.complete());
  EXPECT_EQ(replica.refused(), 0u);
}

TEST(Replica, KnowsTheEdgesOfABlade) {
  const SmallScene s;
  SceneInfo scene;
  SceneBody& knife = scene.bodies.emplace_back();
  knife.name = "knife";
  knife.mesh = s.mesh_asset.hash;
  const auto received = [&](const std::vector<Vec3>& ends) {
    const Asset edges = encode(TriangleMesh{ends, {}});
    scene.bodies[0].map = edges.hash;
    Replica replica;
    for (const Message& m : std::vector<Message>{session(), scene, SmallScene::chunk(s.mesh_asset)})
      feed(replica, m);
    EXPECT_FALSE(replica.complete()) << "the edges are on their way";
    feed(replica, SmallScene::chunk(edges));
    EXPECT_TRUE(replica.complete());
    return replica;
  };
  const Replica good = received({{0, 0, -0.5}, {0, 0, -1}, {1, 0, 0}, {2, 0, 0}});
  ASSERT_EQ(good.bodies().rigid(0)->edges.size(), 2u);
  EXPECT_EQ(good.bodies().rigid(0)->edges[1].to, Vec3(2, 0, 0));
  const Replica bad = received({{0, 0, -0.5}, {0, 0, -1}, {1, 0, 0}});
  EXPECT_TRUE(bad.bodies().rigid(0)->edges.empty()) << "one without its other end";
  EXPECT_EQ(bad.refused(), 1u);
}

TEST(Replica, CallsBodiesAsInItsReadersLanguage) {
  SceneInfo scene = SmallScene().scene();
  scene.bodies[0].names = {{"de", "Organ auf Deutsch"}};
  for (const auto& [language, shown] : std::map<std::string, std::string>{
           {"", "organ"}, {"tr", "organ"}, {"de", "Organ auf Deutsch"}, {"de-AT", "Organ auf Deutsch"}}) {
    ServerChoice choice(language);
    feed(choice, 1, session());
    feed(choice, 1, scene);
    const SceneBody& body = choice.replica().scene()->bodies[0];
    EXPECT_EQ(body.name, shown);
    EXPECT_EQ(authors_name(body), "organ");
    EXPECT_TRUE(is_called(body, "organ") && is_called(body, "Organ auf Deutsch"));
    EXPECT_FALSE(is_called(body, "Leber"));
  }
}

TEST(Replica, CarriesTheSurfaceWithTheStreamedPoints) {
  const SmallScene s;
  Replica replica;
  for (const Message& m : std::vector<Message>{
           session(), s.scene(), SmallScene::chunk(s.mesh_asset), SmallScene::chunk(s.map_asset), s.first(),
           s.soft(0, 10, Vec3::Zero()), s.soft(1, 10, Vec3::Zero()), s.soft(0, 11, {0, 0, 0.5})})
    feed(replica, m);
  ASSERT_TRUE(replica.bodies().soft(0)->sample(10.5, dt));
  EXPECT_NEAR(static_cast<double>(replica.bodies().soft(0)->surface()[1].z()), 0.25, 1e-6);
  EXPECT_TRUE(replica.bodies().soft(0)->sample(11, dt));
  EXPECT_FALSE(replica.bodies().soft(0)->sample(12, dt));  // nothing moved any more
}

TEST(Replica, SettledOverridesALostLastChunk) {
  const SmallScene s;
  Replica replica;
  Settled settled;
  settled.time = {0, 20};
  for (const Vec3& x : s.points) settled.positions.push_back((x + Vec3(0, 0, 1)).cast<float>());
  for (const Message& m :
       std::vector<Message>{session(), s.scene(), SmallScene::chunk(s.mesh_asset),
                            SmallScene::chunk(s.map_asset), s.first(), s.soft(0, 10, Vec3::Zero()), settled})
    feed(replica, m);
  ASSERT_TRUE(replica.complete());
  replica.bodies().soft(0)->sample(30, dt);
  EXPECT_NEAR(replica.bodies().soft(0)->points()[2].z(), 1, 1e-6);
}

TEST(Replica, CountsContradictionsAndGoesOn) {
  const SmallScene s;
  Replica replica;
  SoftState wrong = s.soft(0, 10, Vec3::Zero());
  wrong.first_point = 2;
  SceneInfo scene = s.scene();
  scene.bodies[0].points = 3;  // the asset has 4
  for (const Message& m : std::vector<Message>{session(), scene, SmallScene::chunk(s.mesh_asset),
                                               SmallScene::chunk(s.map_asset), rigid_at({0, 1}, 77), wrong})
    feed(replica, m);
  EXPECT_FALSE(replica.complete());
  EXPECT_GE(replica.refused(), 2u);
}

TEST(ServerChoice, ARestartedServerStartsOverButKeepsMeshes) {
  const SmallScene s;
  ServerChoice choice;
  const std::vector<Message> state = {s.scene(), s.first(), s.soft(0, 10, Vec3::Zero()),
                                      s.soft(1, 10, Vec3::Zero())};
  for (const Message& m :
       std::vector<Message>{session(2), SmallScene::chunk(s.mesh_asset), SmallScene::chunk(s.map_asset)})
    feed(choice, 7, m);
  for (const Message& m : state) feed(choice, 7, m);
  ASSERT_TRUE(choice.replica().complete());
  feed(choice, 8, session(1));
  EXPECT_FALSE(choice.replica().complete());
  for (const Message& m : state) feed(choice, 8, m);
  EXPECT_TRUE(choice.replica().complete());
}

RosterEntry entry(ParticipantId id) {
  RosterEntry out;
  out.participant = id;
  return out;
}

TEST(ServerChoice, NeverMixesWhatTwoServersSay) {
  ServerChoice choice;
  feed(choice, 7, entry(70));  // before anybody says whose it is
  EXPECT_FALSE(choice.replica().session());
  feed(choice, 7, session(5));
  feed(choice, 8, session(6));
  feed(choice, 8, entry(80));
  EXPECT_EQ(choice.followed(), 7u);
  EXPECT_EQ(choice.replica().session()->server_run, 5u);
  EXPECT_TRUE(choice.replica().roster().contains(70));
  EXPECT_FALSE(choice.replica().roster().contains(80));
  choice.apply({entry(70), Liveness::gone, 8, 1});  // the other's word about ours
  EXPECT_TRUE(choice.replica().roster().contains(70));
}

TEST(ServerChoice, FollowsTheServerThatPrecedesAndStaysWithItUntilItIsGone) {
  ServerChoice choice;
  feed(choice, 7, session(make_server_run(1)));
  EXPECT_EQ(choice.followed(), 7u);
  feed(choice, 8, session(make_server_run(2)));  // went on with the journal
  feed(choice, 8, entry(80));
  EXPECT_EQ(choice.followed(), 8u);
  feed(choice, 7, session(make_server_run(1)));
  EXPECT_EQ(choice.followed(), 8u);
  choice.apply({choice.replica().session().value(), Liveness::gone, 8, 1});
  EXPECT_EQ(choice.followed(), 7u);
  choice.apply({choice.replica().session().value(), Liveness::gone, 7, 1});
  EXPECT_TRUE(choice.replica().server_gone());  // nobody else: it may come back
  feed(choice, 9, session(make_server_run(1)));
  EXPECT_EQ(choice.followed(), 9u);
  EXPECT_FALSE(choice.replica().server_gone());
}

TEST(ServerChoice, IsNotFilledByProcessesThatSayToBeServers) {
  ServerChoice choice;
  feed(choice, 7, session(5));
  for (std::uint64_t writer = 100; writer < 200; ++writer) feed(choice, writer, entry(writer));
  choice.apply({session(5), Liveness::gone, 7, 1});
  feed(choice, 300, session(9));
  EXPECT_EQ(choice.followed(), 300u);
  feed(choice, 0, session(1));  // of a process that was gone before it was known
  EXPECT_EQ(choice.followed(), 300u);
}

TEST(Replica, LeavingTakesAUserAway) {
  Replica replica;
  feed(replica, session());
  RosterEntry entry;
  entry.participant = 5;
  UserState user;
  user.participant = 5;
  feed(replica, entry);
  feed(replica, user);
  EXPECT_TRUE(replica.user(5, 0));
  replica.apply({entry, Liveness::gone, 1, 2});
  EXPECT_TRUE(replica.roster().empty());
  EXPECT_FALSE(replica.user(5, 0));
}

}  // namespace
}  // namespace prosector
